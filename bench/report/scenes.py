# SPDX-License-Identifier: GPL-3.0-or-later
"""Error against run time of each scene: a point a scalar, method and time step; the Pareto front."""
import matplotlib.pyplot as plt
from matplotlib.lines import Line2D

import style

SCALARS = {
    ("q8_8", "nearest"): ("Q8.8", "#cc79a7"),
    ("q8_24", "nearest"): ("Q8.24", "#009e73"),
    ("q16_16", "nearest"): ("Q16.16", "#0072b2"),
    ("q16_16", "saturating"): ("Q16.16 saturating", "#332288"),
    ("q32_32", "nearest"): ("Q32.32", "#56b4e9"),
    ("float", "avr-libc"): ("float", "#e69f00"),
    ("q16_16", "published"): ("Q16.16 as published", "#d55e00"),
}
METHODS = {
    "explicit_euler": ("explicit Euler, as published", "X"),
    "semi_implicit_euler": ("semi-implicit Euler", "o"),
    "velocity_verlet": ("velocity Verlet", "^"),
    "implicit_springs": ("implicit springs", "s"),
}
TARGETS = {"1 cm": 1e-2, "1 mm": 1e-3, "0.1 mm": 1e-4, "10 µm": 1e-5}
# Errors that differ by less are the same error, of the method.
SAME = 0.05
# An error below what the truth itself is known to has no place on a logarithmic axis.
FLOOR = 1e-12


def title(scene):
    return scene.replace("_", " ")


def scalar(row):
    return SCALARS[row["scalar"], row["arithmetic"]][0]


def ours(row):
    return row["arithmetic"] in ("nearest", "saturating")


def method(row):
    return METHODS[row["integrator"]][0].split(",")[0]


def step(row):
    return f"1/{round(1 / row['dt'])} s"


def measured(data, scene=None):
    """The runs on the chip that held and have a truth to be judged by."""
    return [row for row in data.rows("scenes")
            if row["cycles_per_simulated_second"] is not None and row["error"] is not None
            and row["verdict"] == "held" and scene in (None, row["scene"])]


def names(data):
    return list(dict.fromkeys(row["scene"] for row in data.rows("scenes")))


def judged(data):
    """Scenes with a truth."""
    return list(dict.fromkeys(row["scene"] for row in measured(data)))


def front(rows):
    """The rows that no other beats in both error and cycles, by cycles."""
    best, kept = float("inf"), []
    for row in sorted(rows, key=lambda row: (row["cycles_per_simulated_second"], row["error"])):
        if row["error"] < best:
            best = row["error"]
            kept.append(row)
    return kept


def cheapest(data, scene, error):
    """The run with the fewest cycles whose error is no larger; None where there is none."""
    fit = [row for row in measured(data, scene) if row["error"] <= error]
    return min(fit, key=lambda row: row["cycles_per_simulated_second"], default=None)


def float_wins(data):
    """For each scene the rows of float on its front whose error is smaller, by more than SAME, than
    that of the best of ours at no higher cost."""
    wins = []
    for scene in judged(data):
        rows = measured(data, scene)
        for row in front(rows):
            if row["scalar"] != "float":
                continue
            rivals = [rival for rival in rows if ours(rival)
                      and rival["cycles_per_simulated_second"] <= row["cycles_per_simulated_second"]]
            rival = min(rivals, key=lambda rival: rival["error"], default=None)
            if rival is not None and row["error"] > (1 - SAME) * rival["error"]:
                continue
            match = min((other for other in rows if ours(other) and other["error"] <= row["error"]),
                        key=lambda other: other["cycles_per_simulated_second"], default=None)
            wins.append({"scene": scene, "row": row, "rival": rival, "match": match,
                         "reason": reason(row, rival, match)})
    return wins


def reason(row, rival, match):
    """Why none of ours is as good as that row at its cost, from the two shares of the rival's error."""
    if rival is None:
        return "none of ours is as cheap"
    if rival["error_arithmetic"] > rival["error_method"]:
        cause = (f"{scalar(rival)} errs by its resolution there "
                 f"({rival['error_arithmetic']:.1e} m, the method by {rival['error_method']:.1e} m)")
    else:
        step_of_it = ("a longer" if rival["dt"] > row["dt"] else
                      "a shorter" if rival["dt"] < row["dt"] else "the same")
        cause = (f"{scalar(rival)} errs by {method(rival)} there, at {step_of_it} step "
                 f"({rival['error_method']:.1e} m, the arithmetic by "
                 f"{rival['error_arithmetic']:.1e} m)")
    if match is None:
        return cause + "; none of ours reaches float's error"
    return (f"{cause}; ours reaches float's error as {scalar(match)}, {method(match)}, at "
            f"{match['cycles_per_simulated_second'] / 1e6:.3g} million cycles")


def saturation(data):
    """For each scene the rows of Q16.16, Q16.16 saturating and float at 1/256 s that all took cycles."""
    kinds = [("q16_16", "nearest"), ("q16_16", "saturating"), ("float", "avr-libc")]
    lines = []
    for scene in names(data):
        rows = {(row["scalar"], row["arithmetic"]): row
                for row in data.rows("scenes", scene=scene, integrator="semi_implicit_euler")
                if row["dt"] == 1 / 256 and row["cycles_per_step_mean"] is not None}
        if all(kind in rows for kind in kinds):
            lines.append([rows[kind] for kind in kinds])
    return lines


def failures(data):
    return [row for row in data.rows("scenes") if row["verdict"] != "held"]


def draw(data):
    scenes = judged(data)
    columns = 3
    lines = -(-len(scenes) // columns)
    figure, grid = plt.subplots(lines, columns, figsize=(11, 2.7 * lines + 0.9), squeeze=False)
    for axes, scene in zip(grid.flat, scenes):
        rows = measured(data, scene)
        for row in rows:
            axes.scatter(row["cycles_per_simulated_second"], max(row["error"], FLOOR), s=26, zorder=3,
                         marker=METHODS[row["integrator"]][1], edgecolors="white", linewidths=0.4,
                         color=SCALARS[row["scalar"], row["arithmetic"]][1])
        best = front(rows)
        right = max(row["cycles_per_simulated_second"] for row in rows) * 1.3
        axes.step([row["cycles_per_simulated_second"] for row in best] + [right],
                  [max(row["error"], FLOOR) for row in best] + [max(best[-1]["error"], FLOOR)],
                  where="post", color="#888888", linewidth=1, zorder=2)
        axes.axvline(16e6, color="#222222", linewidth=0.8, linestyle=":", zorder=1)
        axes.set(xscale="log", yscale="log", title=title(scene))
    for axes in list(grid.flat)[len(scenes):]:
        axes.set_axis_off()
    figure.supxlabel("cycles per simulated second (dotted: all that the chip has)")
    figure.supylabel("largest error, m")
    handles = [Line2D([], [], linestyle="", marker="o", color=colour) for _, colour in SCALARS.values()]
    handles += [Line2D([], [], linestyle="", marker=marker, color="#666666")
                for _, marker in METHODS.values()]
    labels = [name for name, _ in SCALARS.values()] + [name for name, _ in METHODS.values()]
    style.legend_above(figure, handles, labels, 5)
    return figure


def draw_time_steps(data):
    """What the method and what the arithmetic errs by, against the time step."""
    scenes = judged(data)
    columns = 3
    lines = -(-len(scenes) // columns)
    figure, grid = plt.subplots(lines, columns, figsize=(11, 2.5 * lines + 0.9), squeeze=False,
                                sharex=True)
    for axes, scene in zip(grid.flat, scenes):
        rows = [row for row in data.rows("scenes", scene=scene, integrator="velocity_verlet")
                if row["verdict"] == "held"]
        wide = [row for row in rows if row["scalar"] == "fifty_digits"]
        axes.plot([row["dt"] for row in wide], [max(row["error"], FLOOR) for row in wide],
                  color="#222222", linewidth=1.2)
        for key, (_, colour) in SCALARS.items():
            points = [row for row in rows if (row["scalar"], row["arithmetic"]) == key]
            axes.plot([row["dt"] for row in points],
                      [max(row["error_arithmetic"], FLOOR) for row in points], color=colour,
                      marker=".", linewidth=0.8)
        axes.set(xscale="log", yscale="log", title=title(scene))
    for axes in list(grid.flat)[len(scenes):]:
        axes.set_axis_off()
    figure.supxlabel("time step, s")
    figure.supylabel("m")
    shown = [value for key, value in SCALARS.items() if key[1] != "published"]
    handles = [Line2D([], [], color="#222222")]
    handles += [Line2D([], [], marker=".", color=colour) for _, colour in shown]
    labels = ["error of velocity Verlet itself"] + ["arithmetic, " + name for name, _ in shown]
    style.legend_above(figure, handles, labels, 3)
    return figure
