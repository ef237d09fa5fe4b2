# SPDX-License-Identifier: GPL-3.0-or-later
"""The result in one picture: cycles and flash of Q16.16, the 2016 design's and emulated float."""
import matplotlib.pyplot as plt

import operations
import style

OPERATIONS = ("add", "multiply", "divide", "sqrt", "reciprocal_sqrt", "atan2", "sin", "exp", "log",
              "dot3", "length3", "normalise3")
CONTENDERS = (operations.PUBLISHED, operations.FLOAT, ("q8_8", "default"), ("q16_16", "small"),
              ("q16_16", "default"))


def draw(data):
    shown = [name for name in OPERATIONS if operations.row(data, name, "q16_16")]
    figure, panels = plt.subplots(1, 2, figsize=(10, 4.4), sharey=True)
    for axes, column, unit in zip(panels, ("cycles_mean", "flash_bytes"),
                                  ("cycles, mean over operands of 0.01 to 20",
                                   "flash of a program that uses it alone, bytes")):
        for contender in CONTENDERS:
            points = [(found[column], height) for height, name in enumerate(reversed(shown))
                      if (found := operations.row(data, name, *contender)) and found[column]]
            axes.scatter([x for x, _ in points], [y for _, y in points], s=40, zorder=3,
                         marker=style.marker(*contender), facecolors=style.face(*contender),
                         edgecolors=style.colour(*contender), label=style.label(*contender))
        axes.set(xscale="log", xlabel=unit)
    panels[0].set_yticks(range(len(shown)), reversed(shown))
    handles, labels = panels[0].get_legend_handles_labels()
    style.legend_above(figure, handles, labels, len(labels))
    return figure


def finding(data):
    """What the picture shows, in a sentence."""
    ratios = operations.ratios_to_float(data, "q16_16")
    faster = sum(ratio < 1 for ratio in ratios.values())
    flash = [name for name in ratios
             if operations.row(data, name, "q16_16")["flash_bytes"]
             > operations.row(data, name, *operations.FLOAT)["flash_bytes"]]
    return (f"Q16.16 takes fewer cycles than float in {faster} of {len(ratios)} operations "
            f"({operations.geometric_mean(ratios.values()):.3f} times as many in the geometric mean) "
            f"and more flash in {len(flash)}.")
