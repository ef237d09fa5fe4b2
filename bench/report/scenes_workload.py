# SPDX-License-Identifier: GPL-3.0-or-later
"""The published workload: one step as a logic analyser would show it, and cycles by iterations."""
import matplotlib.pyplot as plt

import style

LANES = ("step", "find contacts", "resolve contacts", "square root", "multiply", "divide", "add")
ARITHMETICS = {
    "fixed_16_16": ("2016 design", style.colour("q16_16", "published")),
    "q16_16": ("Q16.16", style.colour("q16_16")),
    "float": ("avr-libc float", style.colour("float")),
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
                axes.annotate(f"{row['steps']} step{'s' if row['steps'] > 1 else ''}", (row["rounds"], row["cycles"]),
                              fontsize=7, color=colour, xytext=(7, -3), textcoords="offset points")
    axes.axhline(4.4e-3 * 16e6, color="#222222", linewidth=1, linestyle="--")
    axes.annotate("published step: 4.4 ms", (10, 4.4e-3 * 16e6), fontsize=7, ha="right",
                  xytext=(0, -9), textcoords="offset points")
    axes.set(xlabel="iterations of the contact solver", ylabel="cycles of a step", xlim=(-0.4, 11.2), ylim=(0, None))
    axes.legend()
    return figure


def lever_steps(data):
    """A step of the lever in Q16.16 and float in each program that contains it: number format, source of the figure,
    what distinguishes the program, mean cycles, flash."""
    table = []
    for row in data.some("features", scene="lever", feature="arithmetic=Nearest", **{"with": "yes"}):
        table.append(("Q16.16", "features", "-O2, --relax; a particle on an anchored rod, pushed in each step",
                      row["cycles_per_step_mean"], row["flash_bytes"]))
    for scalar, arithmetic in (("q16_16", "nearest"), ("float", "avr-libc")):
        for row in data.some("scenes", scene="lever", scalar=scalar, arithmetic=arithmetic, integrator="semi_implicit_euler",
                             dt=1 / 256):
            table.append((style.format_label(row["scalar"]), "scenes",
                          "-O2, --relax; steps of 1/256 s, positions sent as they are reached",
                          row["cycles_per_step_mean"], row["flash_bytes"]))
    for number_format in ("q16_16", "float"):
        flash = {row["reason"]: row["measured"] for row in data.rows("workload", arithmetic=number_format, quantity="lever_flash")}
        table += [(style.format_label(number_format), "workload",
                   f"{row['reason']}; parts of the step are separate functions, so that they can be traced",
                   row["measured"], flash[row["reason"]])
                  for row in data.some("workload", arithmetic=number_format, quantity="lever_step")]
    return table
