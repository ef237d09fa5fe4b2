# SPDX-License-Identifier: GPL-3.0-or-later
"""The cost of the 2016 design's Q16.16 division by operand class, its two published figures, and ours."""
import matplotlib.pyplot as plt

import operations
import style

BIN = 16  # cycles, as division_cycles.csv counts them
# What the classes of operands hold (bench/lab/operands/operand_class.hpp).
CLASSES = {"small": "below 1", "physics": "0.01 to 20", "full": "all magnitudes equally likely",
           "published": "those of the published timing loop, rebuilt"}


def draw(data):
    rows = data.rows("division_cycles")
    classes = [operands for operands in dict.fromkeys(row["operands"] for row in rows)
               if operands and any(row["operands"] == operands
                                   and row["kind"] == "fixed_16_16_histogram" for row in rows)]
    figure, grid = plt.subplots(len(classes), 1, figsize=(9, 1.5 * len(classes) + 1), sharex=True,
                                squeeze=False)
    ours = {row["operands"]: row["cycles_mean"]
            for row in data.rows("operations", operation="divide", format="q16_16",
                                 implementation="default")}
    for axes, operands in zip(grid.flat, classes):
        for kind, subject, name in (("fixed_16_16_histogram", operations.PUBLISHED, "2016 design"),
                                    ("float_histogram", operations.FLOAT, "avr-libc float")):
            bins = [row for row in rows if row["kind"] == kind and row["operands"] == operands]
            total = sum(row["count"] for row in bins)
            axes.bar([row["cycles"] for row in bins], [row["count"] / total for row in bins],
                     width=BIN, align="edge", color=style.colour(*subject), label=name)
        if operands in ours:
            axes.axvline(ours[operands], color=style.colour("q16_16"), linewidth=2,
                         label="Q16.16, mean")
        for row in rows:
            if row["kind"] == "published":
                axes.axvline(row["cycles"], color=style.INK, linewidth=1, linestyle="--")
        axes.set(title=f"operands: {CLASSES[operands]}", ylabel="share", xlim=(0, None))
        axes.set_yticks([])
    top = grid.flat[0]
    for row, side in zip((row for row in rows if row["kind"] == "published"),
                         ((2, "left"), (-2, "right"), (2, "left"))):
        name = "engine: 62 µs" if "engine" in row["note"] else (
            "Table 3.2 minus loop" if "less" in row["note"] else "Table 3.2")
        top.annotate(name, (row["cycles"], 0.86), xycoords=("data", "axes fraction"), fontsize=7,
                     xytext=(side[0], 0), textcoords="offset points", ha=side[1])
    grid.flat[-1].set_xlabel("cycles, including call and return")
    handles, labels = top.get_legend_handles_labels()
    style.legend_above(figure, handles, labels, 3)
    return figure


def finding(data):
    """The cost of divisions of physics operands, and of those in the rebuilt engine."""
    published, floats, ours = (operations.row(data, "divide", *kind)
                               for kind in (operations.PUBLISHED, operations.FLOAT, ("q16_16", "default")))
    text = (f"On operands of 0.01 to 20 a division takes {published['cycles_mean'] / 16:.0f} µs in the 2016 design, "
            f"{floats['cycles_mean'] / 16:.0f} µs in float and {ours['cycles_mean'] / 16:.1f} µs in ours")
    engine = data.rows("workload", quantity="divide") if data.has("workload") else []
    if engine:
        text += (f". Within the rebuilt engine of 2016 it takes {engine[0]['measured']:.0f} µs on average; "
                 f"{engine[0]['published']:.0f} µs were published")
    return text + "."
