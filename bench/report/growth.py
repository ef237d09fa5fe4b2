# SPDX-License-Identifier: GPL-3.0-or-later
"""The cost of a step against the number of particles."""
import matplotlib.pyplot as plt

import style

SEARCHES = {"brute_force": (style.PALE, "o", "every pair"),
            "sort_and_sweep": (style.INK, "s", "sort and sweep"),
            "box2d": (style.RIVAL[1], "^", "Box2D")}


def crossing(rows):
    """The smallest number of particles from which sort and sweep is cheaper."""
    cost = {name: {row["particles"]: row["cost_per_step"] for row in rows
                   if row["broad_phase"] == name} for name in SEARCHES}
    first = None
    for count in sorted(cost["sort_and_sweep"]):
        if cost["sort_and_sweep"][count] < cost["brute_force"].get(count, float("inf")):
            first = count if first is None else first
        else:
            first = None
    return first


def beside_box2d(rows):
    """The cost of a step of the most discs in Box2D and in our engine."""
    most = max(row["particles"] for row in rows)
    ours, theirs = (row["cost_per_step"] for name in ("sort_and_sweep", "box2d") for row in rows
                    if (row["broad_phase"], row["particles"]) == (name, most))
    ratios = [row["cost_per_step"] / own["cost_per_step"] for row in rows for own in rows
              if row["broad_phase"] == "box2d" and own["broad_phase"] == "sort_and_sweep"
              and row["particles"] == own["particles"]]
    return (f"There {most} discs take {ours / 1e6:.2f} ms a step in Q16.16 and {theirs / 1e6:.2f} ms in Box2D's float; "
            f"over all numbers of discs Box2D takes {min(ratios):.2f} to {max(ratios):.2f} times as long as ours.")


def fits(rows):
    """By how much each search's cost misses its fit."""
    missed = {row["broad_phase"]: row["fit_worst_percent"] for row in rows if row["fitted"] is not None}
    return " and ".join(f"{miss:.1f}% ({SEARCHES[search][2]})" for search, miss in missed.items())


def draw(data):
    places = [("growth", "ATmega328P, Q16.16, cycles a step", False)]
    if data.has("growth_host"):
        places.append(("growth_host", "this project's host, nanoseconds a step", True))
    figure, panels = plt.subplots(1, len(places), figsize=(9, 3.8), squeeze=False)
    for axes, (name, title, logarithmic) in zip(panels[0], places):
        rows = data.rows(name)
        for search, (colour, marker, label) in SEARCHES.items():
            mine = sorted((row for row in rows if row["broad_phase"] == search),
                          key=lambda row: row["particles"])
            if not mine:
                continue  # Box2D does not run on the chip
            counts = [row["particles"] for row in mine]
            axes.plot(counts, [row["cost_per_step"] for row in mine], marker, color=colour,
                      label=label)
            if mine[0]["fitted"] is not None:
                axes.plot(counts, [row["fitted"] for row in mine], "-", color=colour, linewidth=1)
        axes.set(title=title, xlabel="particles in a box")
        if logarithmic:
            # The fit may be negative for few particles: the measured costs determine the axis.
            costs = [row["cost_per_step"] for row in rows]
            axes.set(xscale="log", yscale="log", ylim=(min(costs) / 2, max(costs) * 2))
        else:
            axes.set_ylim(bottom=0)
        axes.legend()
    return figure


def finding(data):
    """From what number of particles sort and sweep is cheaper, in this box and in the lever's scene."""
    def told(rows, where):
        count = crossing(rows)
        return f"never cheaper {where}" if count is None else f"cheaper from {count} particles upwards {where}"

    parts = [told(data.rows("growth"), "on the chip")]
    if data.has("growth_host"):
        parts.append(told(data.rows("growth_host"), "on the host"))
    text = "In this box sort and sweep is " + " and ".join(parts) + "."
    if data.has("growth_host"):
        text += " " + beside_box2d(data.rows("growth_host"))
    text += f" A step costs a + b N + c times the pairs tested: on the chip within {fits(data.rows('growth'))}"
    if data.has("growth_host"):
        text += (f", on the host within {fits(data.rows('growth_host'))}. There sort and sweep compares copies stored in a row "
                 "(`CachedSortAndSweep`)")
    text += "."
    if data.has("features"):
        brute, sweep = (row["cycles_per_step_mean"] for search in ("BruteForce", "SortAndSweep") for row in
                        data.some("features", scene="lever", feature=f"broad_phase={search}", **{"with": "yes"}))
        text += (f" With the two particles of the lever's scene, sort and sweep takes {sweep:.0f} cycles a step and every pair "
                 f"{brute:.0f}.")
    return text
