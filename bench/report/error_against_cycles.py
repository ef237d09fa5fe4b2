# SPDX-License-Identifier: GPL-3.0-or-later
"""Error against cycles, annotated with flash: a panel for each operation, a point for each implementation
of 32 bits, and the Pareto front."""
import math

import matplotlib.pyplot as plt
from matplotlib.ticker import LogLocator, NullFormatter, ScalarFormatter

import operations
import rivals
import style

# Formats of one size compete: a caller with four bytes per number chooses among these.
FORMATS = ("q16_16", "q8_24", "s16_15", "float")
IMPLEMENTATIONS = ("default", "small", "published", "accum", "libc")
# An exact result has no place on a logarithmic axis; it is drawn at this floor.
FLOOR = 1e-11


def pareto(points):
    """The points that no other point beats in both coordinates, by cycles."""
    front, best = [], float("inf")
    for point in sorted(points):
        if point[1] < best:
            front.append(point)
            best = point[1]
    return front


def panels(data):
    """The rows of each operation that has a kernel and more than one implementation."""
    rows = [row for row in data.rows("operations", operands="physics")
            if row["format"] in FORMATS and row["implementation"] in IMPLEMENTATIONS
            and row["operation"] not in operations.ELEMENTARY
            and row["rms_error"] is not None]
    by_operation = {}
    for row in rows:
        by_operation.setdefault(row["operation"], []).append(row)
    return {operation: each for operation, each in by_operation.items() if len(each) > 1}


def floored(cycles_and_error):
    return cycles_and_error[0], max(cycles_and_error[1], FLOOR)


def point(row):
    return floored((row["cycles_mean"], row["rms_error"]))


def contested(data):
    """The panels to draw: operations that others have in addition to our default, float and the 2016 design."""
    plain = {("q16_16", "default"), ("q8_24", "default"), ("float", "libc"), ("q16_16", "published")}
    return {operation: rows for operation, rows in panels(data).items()
            if rivals.rows(data, operation, ("q16_16",)) or any((row["format"], row["implementation"]) not in plain for row in rows)}


def draw(data):
    shown = contested(data)
    columns = 4
    lines = -(-len(shown) // columns)
    figure, grid = plt.subplots(lines, columns, figsize=(11, 2.5 * lines + 0.6), squeeze=False)
    seen = {}
    for axes, (operation, rows) in zip(grid.flat, shown.items()):
        # _Accum is already a subject of operations.csv.
        others = [row for row in rivals.rows(data, operation, ("q16_16",)) if row["variant"] != "gcc_accum"]
        points = [point(row) for row in rows + others]
        for row in others:
            handle = axes.scatter(*point(row), marker=rivals.MARKERS[row["variant"]], s=36, zorder=3,
                                  color=rivals.COLOURS[row["variant"]], linewidths=1)
            seen.setdefault(rivals.NAMES[row["variant"]], handle)
        for row in rows:
            kind = row["format"], row["implementation"]
            handle = axes.scatter(*point(row), marker=style.marker(*kind), s=42, zorder=3,
                                  facecolors=style.face(*kind), edgecolors=style.colour(*kind))
            if row["flash_bytes"] is not None:
                below = kind in (("q16_16", "small"), ("q8_24", "default"))  # beside Q16.16's
                axes.annotate(row["flash_bytes"], point(row), fontsize=6, xytext=(5, -8 if below else 3),
                              textcoords="offset points", color=style.colour(*kind))
            seen.setdefault(style.label(*kind), handle)
        front = pareto(points)
        left, right = min(x for x, _ in points), max(x for x, _ in points) * 1.3
        axes.step([x for x, _ in front] + [right], [y for _, y in front] + [front[-1][1]],
                  where="post", color="#888888", linewidth=1, zorder=2)
        axes.set(xscale="log", yscale="log", title=operation)
        steps = (1,) if right > 200 * left else (1, 3) if right > 8 * left else (1, 2, 3, 5) if right > 4 * left else (1, 1.5, 2, 3, 5, 7)
        axes.xaxis.set_major_locator(LogLocator(subs=steps))
        axes.xaxis.set_major_formatter(ScalarFormatter())
        axes.xaxis.set_minor_formatter(NullFormatter())
        low, high = min(y for _, y in points), max(y for _, y in points)
        # Room for a label below the lowest point.
        axes.set_ylim(low / max(3, (high / low)**0.15), max(high * 3, low * 30))
        axes.yaxis.set_minor_formatter(NullFormatter())
        if low == FLOOR:  # below it the axis has no error, only "none"
            ticks = [FLOOR] + [10.0**e for e in range(-9, 3, 2) if 10.0**e <= high * 3]
            axes.set_yticks(ticks, ["exact"] + [f"$10^{{{round(math.log10(tick))}}}$" for tick in ticks[1:]])
    for axes in list(grid.flat)[len(shown):]:
        axes.set_axis_off()
    figure.supxlabel("cycles, mean over operands of 0.01 to 20; numbers are bytes of flash")
    figure.supylabel("rms error, in the unit of the result")
    names = sorted(seen, key=lambda name: name in rivals.NAMES.values())  # ours first
    style.legend_above(figure, [seen[name] for name in names], names, 5)
    return figure


def finding(data):
    """Which implementations form the fronts, in a sentence."""
    shown = panels(data)
    owners = {"ours": 0, "float": 0}
    for operation, rows in shown.items():
        front = pareto([point(row) for row in rows + rivals.rows(data, operation, ("q16_16",))])
        holders = {row["format"] for row in rows if point(row) in front}
        owners["ours"] += bool(holders & {"q16_16", "q8_24"})
        owners["float"] += "float" in holders
    return (f"In {owners['ours']} of {len(shown)} operations with kernels, one of our formats is on the Pareto front (nothing else is both "
            f"faster and more exact); float is in {owners['float']}.")
