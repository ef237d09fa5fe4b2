# SPDX-License-Identifier: GPL-3.0-or-later
"""The published workload: one step as a logic analyser would show it, and cycles by rounds."""
import matplotlib.pyplot as plt

import style

LANES = ("step", "find contacts", "resolve contacts", "square root", "multiply", "divide", "add")
ARITHMETICS = {
    "fixed_16_16": ("Q16.16 as published", style.colour("published")),
    "q16_16": ("Q16.16, ours", style.colour("default")),
    "float": ("avr-libc float", style.colour("libc")),
}


def draw_trace(data):
    rows = data.rows("workload_trace")
    figure, grid = plt.subplots(len(ARITHMETICS), 1, figsize=(11, 7.2))
    for axes, (arithmetic, (name, colour)) in zip(grid, ARITHMETICS.items()):
        calls = [row for row in rows if row["arithmetic"] == arithmetic]
        lanes = [lane for lane in LANES if any(row["lane"] == lane for row in calls)]
        for height, lane in enumerate(reversed(lanes)):
            spans = [(row["begin_us"], row["end_us"] - row["begin_us"]) for row in calls
                     if row["lane"] == lane]
            axes.broken_barh(spans, (height + 0.1, 0.7), facecolors=colour)
            axes.axhline(height + 0.1, color="#999999", linewidth=0.5)
            share = sum(span[1] for span in spans)
            axes.annotate(f"{len(spans)} × {share / len(spans):.1f} µs", (1.005, height + 0.45),
                          xycoords=("axes fraction", "data"), fontsize=7, va="center")
        longest = max(row["end_us"] for row in calls)
        axes.set(yticks=[height + 0.45 for height in range(len(lanes))], xlim=(0, longest),
                 title=f"{name}: {longest / 1000:.2f} ms")
        axes.set_yticklabels(list(reversed(lanes)))
        axes.grid(False)
    grid[-1].set_xlabel("µs")
    return figure


def draw_rounds(data):
    rows = data.rows("workload_rounds")
    figure, axes = plt.subplots(figsize=(7, 3.6))
    for arithmetic, (name, colour) in ARITHMETICS.items():
        of = [row for row in rows if row["arithmetic"] == arithmetic]
        axes.plot([row["rounds"] for row in of], [row["cycles"] for row in of], marker="o",
                  color=colour, label=name)
        for row in of:
            if row["steps"]:
                axes.annotate(f"{row['steps']} steps", (row["rounds"], row["cycles"]), fontsize=7,
                              xytext=(0, 6), textcoords="offset points", ha="center")
    axes.axhline(4.4e-3 * 16e6, color="#222222", linewidth=1, linestyle="--")
    axes.annotate("published step: 4.4 ms", (10, 4.4e-3 * 16e6), fontsize=7, ha="right",
                  xytext=(0, -9), textcoords="offset points")
    axes.set(xlabel="iterations of the contact solver", ylabel="cycles of a step", ylim=(0, None))
    axes.legend()
    return figure
