# SPDX-License-Identifier: GPL-3.0-or-later
"""The largest and the rms error along the input of the functions of one operand."""
import matplotlib.pyplot as plt

import style


def draw(data):
    rows = data.rows("error_along_input")
    operations = list(dict.fromkeys(row["operation"] for row in rows))
    figure, grid = plt.subplots(len(operations), 1, figsize=(9, 1.9 * len(operations) + 0.6),
                                sharex=True, squeeze=False)
    for axes, operation in zip(grid.flat, operations):
        for implementation in ("published", "default"):
            mine = [row for row in rows if row["operation"] == operation
                    and row["implementation"] == implementation]
            if not mine:
                continue
            middle = [(row["low"] * row["high"]) ** 0.5 for row in mine]
            colour = style.colour(implementation)
            axes.plot(middle, [row["max_ulp"] for row in mine], color=colour, linewidth=1.2,
                      label=style.label(implementation) + ", largest")
            axes.plot(middle, [row["rms_ulp"] for row in mine], color=colour, linewidth=1,
                      linestyle="--", label=style.label(implementation) + ", rms")
        axes.set(xscale="log", title=f"{operation} q16_16", ylabel="error, ulp")
        axes.set_ylim(bottom=0)
    grid.flat[-1].set_xlabel("input (positive)")
    handles, labels = grid.flat[0].get_legend_handles_labels()
    style.legend_above(figure, handles, labels, 4)
    return figure
