# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a held lever stays at rest: measured over a family of plants, and by linear theory."""
import matplotlib.pyplot as plt
import numpy
from matplotlib.lines import Line2D

import style

ARITHMETICS = {"published": "2016 design", "q16_16": "ours, Q16.16", "float": "ours, float"}
DAMPINGS = {"no": "without damping", "yes": "selective damping"}
COLOURS = {"yes": style.INK, "no": "#999999"}
THEORY = "#777777"
AT_REST = 1.5  # degrees


def key(row):
    return row["arithmetic"], row["damping"], row["clock"], row["loop_rate_hz"]


def grouped(rows):
    groups = {}
    for row in rows:
        groups.setdefault(key(row), []).append(row)
    return groups


def grid(rows, column):
    """Shares of the plants over arms (columns) and hands (rows)."""
    arms = sorted({row["arm_m"] for row in rows})
    hands = sorted({row["hand_n_per_m"] for row in rows})
    shares = numpy.zeros((len(hands), len(arms)))
    for row in rows:
        shares[hands.index(row["hand_n_per_m"]), arms.index(row["arm_m"])] = (
            row[column] / row["plants"])
    return arms, hands, shares


def write_released(axes, rows, arms, hands):
    """How many plants are at rest when they are released against the hand, if not all are."""
    for row in rows:
        if row["released_at_rest"] == row["plants"]:
            continue
        axes.text(arms.index(row["arm_m"]), hands.index(row["hand_n_per_m"]),
                  str(row["released_at_rest"]), ha="center", va="center", fontsize=6,
                  color="white" if 2 * row["at_rest"] < row["plants"] else "black")


def settled(data):
    """The levers with which every plant is at rest, grasped or released against, at each rate, arm and hand."""
    rows = data.rows("stable_region")
    levers = dict.fromkeys((row["arithmetic"], row["damping"]) for row in rows)
    return [lever for lever in levers if all(row["at_rest"] == row["released_at_rest"] == row["plants"] for row in rows
                                             if (row["arithmetic"], row["damping"]) == lever)]


def settled_finding(data):
    """Which levers need no picture, in a sentence."""
    names = [f"{ARITHMETICS[arithmetic]} with {DAMPINGS[damping]}" if damping == "yes"
             else f"{ARITHMETICS[arithmetic]} {DAMPINGS[damping]}" for arithmetic, damping in settled(data)]
    return f"Not drawn, because all plants are at rest everywhere: {'; '.join(names)}." if names else ""


def draw(data):
    """One panel per lever and loop rate: shades are measured, the dashed line is the theory's."""
    rest, every = settled(data), grouped(data.rows("stable_region"))
    groups = {group: rows for group, rows in every.items() if group[:2] not in rest} or every
    columns = sorted({(clock, rate) for _, _, clock, rate in groups},
                     key=lambda column: (column[0] != "published", column[1]))
    lines = [(arithmetic, damping) for arithmetic in ARITHMETICS for damping in DAMPINGS
             if any(group[:2] == (arithmetic, damping) for group in groups)]
    figure, panels = plt.subplots(len(lines), len(columns), squeeze=False, sharex=True,
                                  sharey=True, figsize=(11, 1.55 * len(lines) + 0.6))
    image = None
    for (arithmetic, damping), axes_of_line in zip(lines, panels):
        for (clock, rate), axes in zip(columns, axes_of_line):
            axes.grid(visible=False)
            rows = groups.get((arithmetic, damping, clock, rate))
            if rows is None:
                axes.set_axis_off()
                continue
            arms, hands, measured = grid(rows, "at_rest")
            theory = grid(rows, "linear_stable")[2]
            write_released(axes, rows, arms, hands)
            image = axes.imshow(measured, origin="lower", aspect="auto", vmin=0, vmax=1,
                                cmap="cividis")
            if theory.min() < 0.5 <= theory.max():
                axes.contour(theory, levels=[0.5], colors=THEORY, linestyles="dashed",
                             linewidths=1.6)
            axes.set_xticks(range(len(arms)), [f"{100 * arm:.0f}" for arm in arms], fontsize=7)
            axes.set_yticks(range(len(hands)), [f"{hand:.0f}" for hand in hands], fontsize=7)
    for (clock, rate), axes in zip(columns, panels[0]):
        axes.set_title(f"{rate:.0f} Hz" if clock == "fixed" else "its own clock")
    for (arithmetic, damping), axes_of_line in zip(lines, panels):
        first = next(axes for axes in axes_of_line if axes.axison)
        first.set_ylabel(f"{ARITHMETICS[arithmetic]},\n{DAMPINGS[damping]}\nhand, N/m",
                         fontsize=7)
        first.tick_params(labelleft=True)
    for axes in panels[-1]:
        axes.set_xlabel("arm, cm", fontsize=8)
    bar = figure.colorbar(image, ax=panels, shrink=0.5, pad=0.01)
    bar.set_label("share of plants at rest when grasped")
    style.legend_above(figure, [Line2D([], [], color=THEORY, linestyle="dashed")],
                       ["linear theory: at least half of the plants are stable below the line, or everywhere if "
                        "there is none. Numbers: plants at rest when released against, if not all"], 1)
    return figure


def draw_oscillation(data):
    """The poked lever over time."""
    rows = data.rows("oscillation")
    time = [row["time_s"] for row in rows]
    figure, panels = plt.subplots(2, 1, sharex=True, sharey=True, figsize=(9, 4.6))
    for axes, arithmetic in zip(panels, ("published", "q16_16")):
        for damping, name in (("no", "undamped"), ("yes", "damped")):
            axes.plot(time, [row[f"{arithmetic}_{name}_deg"] for row in rows],
                      color=COLOURS[damping], linewidth=1, label=DAMPINGS[damping])
        axes.axvline(2, color="#888888", linewidth=0.8, linestyle=":")
        axes.set(title=ARITHMETICS[arithmetic], ylabel="lever, degrees", xlim=(0, time[-1]))
    panels[1].set_xlabel("s; poked at 2 s")
    style.legend_above(figure, *panels[0].get_legend_handles_labels(), 2)
    return figure


def oscillation(data):
    """For each trace in its last second: lever, damping, swing in degrees, frequency in Hz."""
    rows = [row for row in data.rows("oscillation")]
    end = rows[-1]["time_s"]
    last = [row for row in rows if row["time_s"] > end - 1]
    result = []
    for arithmetic in ("published", "q16_16"):
        for damping, name in (("no", "undamped"), ("yes", "damped")):
            angles = numpy.array([row[f"{arithmetic}_{name}_deg"] for row in last])
            swing = angles.max() - angles.min()
            above = angles > angles.mean()
            passes = int(numpy.sum(above[1:] & ~above[:-1]))
            result.append({"lever": ARITHMETICS[arithmetic], "damping": DAMPINGS[damping],
                           "swing": float(swing), "frequency": passes if swing > AT_REST else None})
    return result


def share(rows, column):
    return 100 * sum(row[column] for row in rows) / sum(row["plants"] for row in rows)


def least(values):
    """The smallest value; None, which means no value, counts as the smallest."""
    values = list(values)
    return None if None in values else min(values)


def most(values):
    """The largest value; None, which means no value, counts as the largest."""
    values = list(values)
    return None if None in values else max(values)


def summary(data):
    """One row per lever, damping and loop rate."""
    limits = grouped(data.rows("stable_limits"))
    chips = grouped(data.rows("stable_on_chip"))
    result = []
    for lever, rows in grouped(data.rows("stable_region")).items():
        arithmetic, damping, clock, rate = lever
        of_plants, seen = limits[lever], chips.get(lever, [])
        result.append({
            "lever": ARITHMETICS[arithmetic], "damping": damping,
            "rate": f"{rate:.0f}" + (", its own clock" if clock == "published" else ""),
            "grasped": share(rows, "at_rest"), "released": share(rows, "released_at_rest"),
            "theory": share(rows, "linear_stable"),
            "hardest": least(row["hardest_hand_n_per_m"] for row in of_plants),
            "theory_arm": most(row["linear_shortest_arm_m"] for row in of_plants),
            "chip": f"{sum(row['chip'] == 'at_rest' for row in seen)} of {len(seen)}" if seen
                    else None,
        })
    return result


def at_own_rate(data):
    """The rows of the summary at the loop rate that the lever runs at."""
    loops = {ARITHMETICS[row["arithmetic"]]: f"{row['loop_rate_hz']:.0f}"
             for row in data.rows("haptic", scenario="poke_while_held")}
    return [row for row in summary(data)
            if row["rate"].endswith("its own clock") or row["rate"] == loops[row["lever"]]]


def agreement(data):
    """The number of points at which chip and host agree, and of all points."""
    rows = data.rows("stable_on_chip")
    return sum(row["chip"] == row["host"] for row in rows), len(rows)


def differing(data):
    """The levers for which they do not agree, each with how often."""
    counts = {}
    for row in data.rows("stable_on_chip"):
        if row["chip"] != row["host"]:
            name = f"{ARITHMETICS[row['arithmetic']]} at {row['loop_rate_hz']:.0f} Hz"
            counts[name] = counts.get(name, 0) + 1
    return counts
