# SPDX-License-Identifier: GPL-3.0-or-later
"""Distribution of the error in ulp: the default arithmetic over the 2016 design's."""
import matplotlib.pyplot as plt
from matplotlib.lines import Line2D

import bounds
import style

WIDEST = 2.1  # ulp; the bins end at 2
PANELS = [("multiply", "q8_8"), ("divide", "q8_8"), ("sqrt", "q16_16"), ("atan2", "q16_16")]


def draw(data):
    figure, grid = plt.subplots(1, len(PANELS), figsize=(11, 2.8), sharex=True)
    for axes, (operation, number_format) in zip(grid, PANELS):
        for implementation in ("published", "default"):
            rows = data.some("error_histograms", operation=operation, format=number_format,
                             implementation=implementation)
            inside = [row for row in rows
                      if row["low_ulp"] != float("-inf") and row["high_ulp"] != float("inf")]
            total = sum(row["count"] for row in rows)
            # A bin that contains nothing has no row.
            edges = sorted({row[edge] for row in inside for edge in ("low_ulp", "high_ulp")})
            share = {row["low_ulp"]: row["count"] / total for row in inside}
            axes.stairs([share.get(edge, 0) for edge in edges[:-1]], edges, linewidth=1.2,
                        color=style.colour(number_format, implementation))
            beyond = sum(row["count"] for row in rows) - sum(row["count"] for row in inside)
            if beyond:
                axes.annotate(f"beyond: {100 * beyond / total:.2g} %", (0.02, 0.9), xycoords="axes fraction", fontsize=7,
                              color=style.colour(number_format, implementation))
        axes.set(title=f"{operation} {style.format_label(number_format)}", xlabel="error, ulp", xlim=(-WIDEST, WIDEST),
                 ylim=(0, None))
        axes.axvline(-0.5, color="#444444", linewidth=0.7, linestyle=":")
        axes.axvline(0.5, color="#444444", linewidth=0.7, linestyle=":")
    grid[0].set_ylabel("share of inputs")
    kinds = [("q16_16", "published")] + [(name, "default") for name in dict.fromkeys(
        number_format for _, number_format in PANELS)]
    handles = [Line2D([], [], color=style.colour(*kind)) for kind in kinds]
    style.legend_above(figure, handles, ["2016 design"] + [style.label(*kind) for kind in kinds[1:]],
                       len(kinds))
    return figure


def finding(data):
    """By how much the largest errors of the two differ, over the panels' operations."""
    pairs = [tuple(bounds.known(data, operation, number_format, implementation)["max_ulp"]
                   for implementation in ("published", "default")) for operation, number_format in PANELS]
    return ("The 2016 design truncates. Its largest errors in these four operations are "
            + ", ".join(f"{published:.3g}" for published, _ in pairs) + " ulp, ours "
            + ", ".join(f"{ours:.3g}" for _, ours in pairs) + ".")
