# SPDX-License-Identifier: GPL-3.0-or-later
"""The result in one picture: cycles of the 2016 design's fixed point, of emulated float and of ours."""
import matplotlib.pyplot as plt

import style

OPERATIONS = ("add", "multiply", "divide", "sqrt", "reciprocal_sqrt", "atan2", "sin", "exp", "log",
              "dot3", "length3", "normalise3")
CONTENDERS = (("q16_16", "published"), ("float", "libc"), ("q16_16", "default"))


def draw(data):
    cycles = {(row["operation"], row["format"], row["implementation"]): row["cycles_mean"]
              for row in data.rows("operations", operands="physics")}
    operations = [name for name in OPERATIONS if (name, "q16_16", "default") in cycles]
    figure, axes = plt.subplots(figsize=(10, 3.6))
    for shift, (number_format, implementation) in zip((-0.27, 0, 0.27), CONTENDERS):
        bars = [(position + shift, cycles[operation, number_format, implementation])
                for position, operation in enumerate(operations)
                if (operation, number_format, implementation) in cycles]
        drawn = axes.bar([x for x, _ in bars], [height for _, height in bars], width=0.25,
                         color=style.colour(implementation),
                         label=f"{style.label(implementation)}"
                               + ("" if number_format == "float" else " Q16.16"))
        axes.bar_label(drawn, fmt="%.0f", fontsize=6.5, padding=1)
    axes.set_xticks(range(len(operations)), operations)
    axes.set(yscale="log", ylabel="cycles at 16 MHz", ylim=(8, 20000))
    axes.grid(axis="x", visible=False)
    axes.legend(loc="upper left", ncols=3)
    return figure
