# SPDX-License-Identifier: GPL-3.0-or-later
"""Distribution of the error in ulp: the default arithmetic over the 2016 design's."""
import matplotlib.pyplot as plt

import style

PANELS = [("multiply", "q8_8"), ("divide", "q8_8"), ("sqrt", "q16_16"), ("atan2", "q16_16")]


def draw(data):
    figure, grid = plt.subplots(1, len(PANELS), figsize=(11, 2.8))
    for axes, (operation, number_format) in zip(grid, PANELS):
        for implementation in ("published", "default"):
            rows = data.rows("error_histograms", operation=operation, format=number_format,
                             implementation=implementation)
            inside = [row for row in rows
                      if row["low_ulp"] != float("-inf") and row["high_ulp"] != float("inf")]
            total = sum(row["count"] for row in rows)
            if not total:
                continue
            axes.bar([row["low_ulp"] for row in inside], [row["count"] / total for row in inside],
                     width=[row["high_ulp"] - row["low_ulp"] for row in inside], align="edge",
                     color=style.colour(implementation), alpha=0.75,
                     label=style.label(implementation))
        axes.set(title=f"{operation} {number_format}", xlabel="error, ulp", xlim=(-1.6, 1.6),
                 yscale="log")
        axes.axvline(-0.5, color="#444444", linewidth=0.7, linestyle=":")
        axes.axvline(0.5, color="#444444", linewidth=0.7, linestyle=":")
    grid[0].set_ylabel("share of inputs")
    handles, labels = grid[0].get_legend_handles_labels()
    style.legend_above(figure, handles, labels, 2)
    return figure
