# SPDX-License-Identifier: GPL-3.0-or-later
"""Where scenes stay stable, by format and method, with the bounds of theory."""
import math

import matplotlib.pyplot as plt

import style

FORMATS = ["q8_8", "q8_24", "q16_16", "q32_32", "float"]
FORMAT_LABELS = {"q8_8": "Q8.8", "q8_24": "Q8.24", "q16_16": "Q16.16", "q32_32": "Q32.32",
                 "float": "float"}
# Okabe and Ito, 2008: one colour a format.
FORMAT_COLOURS = {"q8_8": "#d55e00", "q8_24": "#cc79a7", "q16_16": "#0072b2",
                  "q32_32": "#009e73", "float": "#444444"}
# The arithmetic of a format where nothing else is said.
DEFAULT = ["nearest", "ieee"]
METHODS = ["explicit_euler", "semi_implicit_euler", "velocity_verlet", "implicit_springs"]
METHOD_LABELS = {"explicit_euler": "explicit Euler (2016 design)",
                 "semi_implicit_euler": "semi-implicit Euler",
                 "velocity_verlet": "velocity Verlet",
                 "implicit_springs": "springs solved implicitly"}


def number(cell):
    return math.nan if cell in (None, "none", "") else float(cell)


def whole(value):
    """An integer with its thousands apart."""
    return f"{value:,}".replace(",", "\u202f")


def figure(value):
    """A cell of the page's tables: a number to three significant digits, as a power of ten where
    it is very small or large; a text as it is."""
    if not isinstance(value, (int, float)):
        return str(value)
    if value == 0:
        return "0"
    mantissa, exponent = f"{value:.2e}".split("e")
    if -3 <= int(exponent) <= 2:
        return f"{float(f'{value:.3g}'):g}"
    if 3 <= int(exponent) <= 5:
        return whole(round(float(f"{value:.2e}")))
    factor = "" if float(mantissa) == 1 else f"{float(mantissa):g}·"
    return f"{factor}10<sup>{int(exponent)}</sup>".replace("-", "−")


def scalars(rows):
    """How many formats with their arithmetic there are."""
    return len({(row["scalar"], row["arithmetic"]) for row in rows})


def silent(rows, arithmetic):
    """Of Q16.16 in the engine's own methods: all rows, those that a result ends which wraps within
    a step, and those that a number of the scene ends which the format cannot hold at all."""
    mine = [row for row in rows if row["scalar"] == "q16_16" and row["arithmetic"] == arithmetic
            and row["integrator"] != "explicit_euler"]
    ended = [row for row in mine if row["verdict"] == "overflows"]
    unfit = [row for row in ended if row["first_event"].startswith("overflow convert")]
    return len(mine), len(ended) - len(unfit), len(unfit)


def change(before, after):
    """By how many percent a number of cycles changed."""
    percent = round(100 * (after / before - 1))
    return f"{percent:+d} %".replace("-", "−") if percent else "±0 %"


def points(rows, name, scalar, method, arithmetic=None):
    """The x and the limits of a map's line, in order of x."""
    mine = [row for row in rows if row["map"] == name and row["scalar"] == scalar
            and row["integrator"] == method
            and row["arithmetic"] in ([arithmetic] if arithmetic else DEFAULT)]
    mine.sort(key=lambda row: number(row["x"]))
    return [number(row["x"]) for row in mine], [number(row["limit"]) for row in mine]


def bound(rows, name):
    mine = {number(row["x"]): number(row["bound"]) for row in rows if row["map"] == name}
    return sorted(mine), [mine[x] for x in sorted(mine)]


def panels(title_of=METHOD_LABELS.get, methods=tuple(METHODS)):
    figure, grid = plt.subplots(2, 2, figsize=(9, 7), sharex=True, sharey=True)
    for axes, method in zip(grid.flat, methods):
        axes.set(xscale="log", yscale="log", title=title_of(method))
    return figure, grid


def finish(figure, grid):
    handles, labels = grid.flat[0].get_legend_handles_labels()
    style.legend_above(figure, handles, labels, len(labels))
    return figure


def draw_stiffness(data):
    """The band of stiffness in which a spring of 1 kg oscillates, against the step."""
    rows = data.rows("stability_map")
    figure, grid = panels()
    for axes, method in zip(grid.flat, METHODS):
        for scalar in FORMATS:
            x, high = points(rows, "stiffness_upper", scalar, method)
            low = points(rows, "stiffness_lower", scalar, method)[1]
            colour = FORMAT_COLOURS[scalar]
            axes.plot(x, high, color=colour, marker="v", markersize=3, linewidth=1.2,
                      label=FORMAT_LABELS[scalar])
            axes.plot(x, low, color=colour, marker="^", markersize=3, linewidth=0.8,
                      linestyle=":")
            axes.fill_between(x, low, high, color=colour, alpha=0.06, linewidth=0)
        axes.plot(*bound(rows, "stiffness_upper"), color="black", linewidth=1, linestyle="--",
                  label="ω dt = 2")
    for axes in grid[1]:
        axes.set_xlabel("step, s")
    for axes in grid[:, 0]:
        axes.set_ylabel("stiffness, N/m")
    return finish(figure, grid)


def draw_chain(data):
    """The mass ratio that a hanging chain of rods bears, against its length."""
    rows = data.rows("stability_map")
    figure, axes = plt.subplots(figsize=(7, 4.2))
    axes.set(xscale="log", yscale="log", xlabel="rods in the chain",
             ylabel="largest mass of the end, in masses of a link")
    for scalar in FORMATS:
        for method, line in (("explicit_euler", ":"), ("semi_implicit_euler", "-")):
            x, y = points(rows, "mass_ratio", scalar, method)
            axes.plot(x, y, line, color=FORMAT_COLOURS[scalar], marker="o", markersize=3,
                      linewidth=1.2, label=f"{FORMAT_LABELS[scalar]}, {METHOD_LABELS[method]}")
    axes.set_xticks([2, 3, 4, 6, 8, 12, 16], ["2", "3", "4", "6", "8", "12", "16"])
    axes.minorticks_off()
    axes.legend(fontsize=7, ncols=2)
    return figure


def draw_speed(data):
    """The speed on a rod that keeps its length, against that length."""
    rows = data.rows("stability_map")
    figure, grid = panels()
    for axes, method in zip(grid.flat, METHODS):
        for scalar in FORMATS:
            x, y = points(rows, "speed", scalar, method)
            axes.plot(x, y, color=FORMAT_COLOURS[scalar], marker="o", markersize=3, linewidth=1.2,
                      label=FORMAT_LABELS[scalar])
        axes.plot(*bound(rows, "speed"), color="black", linewidth=1, linestyle="--",
                  label="v dt = r")
    for axes in grid[1]:
        axes.set_xlabel("radius, m")
    for axes in grid[:, 0]:
        axes.set_ylabel("largest speed, m/s")
    return finish(figure, grid)


def draw_verdicts(data):
    """How many cases end in which verdict, by format and method."""
    rows = data.rows("stability")
    kinds = ["stable", "drifts", "diverges", "overflows", "saturates", "underflows", "reports"]
    colours = ["#009e73", "#e69f00", "#d55e00", "#0072b2", "#56b4e9", "#999999", "#cc79a7"]
    bars = [(scalar, arithmetic, method)
            for scalar, arithmetic in [(s, "") for s in FORMATS]
            + [("q16_16", "saturating"), ("q16_16", "published")]
            for method in METHODS]
    figure, axes = plt.subplots(figsize=(9, 6))
    for place, (scalar, arithmetic, method) in enumerate(reversed(bars)):
        mine = [row["verdict"].split()[0] for row in rows
                if row["scalar"] == scalar and row["integrator"] == method
                and row["arithmetic"] in ([arithmetic] if arithmetic else DEFAULT)]
        left = 0
        for kind, colour in zip(kinds, colours):
            count = mine.count(kind)
            axes.barh(place, count, left=left, color=colour, height=0.8,
                      label=kind if place == 0 else None)
            left += count
    axes.set_yticks(range(len(bars)),
                    [f"{FORMAT_LABELS[s]}{' ' + a if a else ''}, {METHOD_LABELS[m]}"
                     for s, a, m in reversed(bars)], fontsize=7)
    axes.set_xlabel("cases, by what ends them")
    handles, labels = axes.get_legend_handles_labels()
    style.legend_above(figure, handles, labels, len(kinds))
    return figure
