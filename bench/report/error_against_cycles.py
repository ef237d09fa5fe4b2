# SPDX-License-Identifier: GPL-3.0-or-later
"""Error against cycles, a panel an operation, a point an implementation, the Pareto front drawn."""
import matplotlib.pyplot as plt
from matplotlib.ticker import LogLocator, NullFormatter, ScalarFormatter

import style

# Formats of one size compete: a caller who has four bytes a number chooses among these.
FAMILIES = {
    "32 bits": ("q16_16", "s16_15", "float"),
    "16 bits": ("q8_8", "s8_7"),
    "64 bits": ("q32_32", "s32_31", "s16_47"),
}
# An exact result has no place on a logarithmic axis; it is drawn at this floor.
FLOOR = 1e-11


def pareto(points):
    """The points that no other beats in both coordinates, by cycles."""
    front, best = [], float("inf")
    for point in sorted(points):
        if point[1] < best:
            front.append(point)
            best = point[1]
    return front


def draw(data, family):
    formats = FAMILIES[family]
    rows = [row for row in data.rows("operations", operands="physics")
            if row["format"] in formats and row["rms_error"] is not None]
    operations = []
    for row in rows:
        if row["operation"] not in operations:
            operations.append(row["operation"])
    rivals = {operation: {(row["format"], row["implementation"]) for row in rows
                          if row["operation"] == operation} for operation in operations}
    operations = [operation for operation in operations if len(rivals[operation]) > 1]
    columns = 4
    lines = -(-len(operations) // columns)
    figure, grid = plt.subplots(lines, columns, figsize=(11, 2.5 * lines + 0.6), squeeze=False)
    seen = {}
    for axes, operation in zip(grid.flat, operations):
        points = []
        for row in rows:
            if row["operation"] != operation:
                continue
            implementation = row["implementation"]
            point = (row["cycles_mean"], max(row["rms_error"], FLOOR))
            points.append(point)
            handle = axes.scatter(*point, marker=style.marker(implementation), s=42, zorder=3,
                                  color=style.colour(implementation), edgecolors="white",
                                  linewidths=0.5)
            name = style.label(implementation)
            if implementation == "accum":
                axes.annotate(row["format"], point, fontsize=6, xytext=(4, 4),
                              textcoords="offset points")
            seen.setdefault(name, handle)
        front = pareto(points)
        right = max(point[0] for point in points) * 1.3
        axes.step([point[0] for point in front] + [right],
                  [point[1] for point in front] + [front[-1][1]], where="post", color="#888888",
                  linewidth=1, zorder=2)
        axes.set(xscale="log", yscale="log", title=operation)
        wide = right > 12 * min(point[0] for point in points)
        axes.xaxis.set_major_locator(LogLocator(subs=(1, 3) if wide else (1, 1.5, 2, 3, 5, 7)))
        axes.xaxis.set_major_formatter(ScalarFormatter())
        axes.xaxis.set_minor_formatter(NullFormatter())
        low = min(point[1] for point in points)
        axes.set_ylim(low / 3, max(max(point[1] for point in points) * 3, low * 30))
        axes.yaxis.set_minor_formatter(NullFormatter())
    for axes in list(grid.flat)[len(operations):]:
        axes.set_axis_off()
    figure.supxlabel("cycles, mean over operands of 0.01 to 20 (call and return included)")
    figure.supylabel("rms error, in the unit of the result")
    style.legend_above(figure, list(seen.values()), list(seen.keys()), 5)
    return figure
