# SPDX-License-Identifier: GPL-3.0-or-later
"""What Figures 4.1 to 4.3 show, again: the profiling pins over three frames, and within a step."""
import matplotlib.pyplot as plt

DEVICES = {"published": "as published, rebuilt", "q16_16": "ours, Q16.16"}
COLOURS = {"step": "#0072b2", "render": "#e69f00", "square_root": "#d55e00", "operation": "#009e73"}
LABELS = {"step": "step", "render": "render", "square_root": "square roots",
          "operation": "products,\nquotients"}


def lanes(axes, rows, pins):
    for lane, pin in enumerate(reversed(pins)):
        spans = [(row["begin_ms"], row["end_ms"] - row["begin_ms"]) for row in rows
                 if row["pin"] == pin]
        axes.broken_barh(spans, (lane - 0.35, 0.7), color=COLOURS[pin], linewidth=0)
    axes.set_yticks(range(len(pins)), [LABELS[pin] for pin in reversed(pins)])
    axes.set_ylim(-0.6, len(pins) - 0.4)
    axes.grid(axis="y", visible=False)


def draw(data):
    rows = data.rows("haptic_pins")
    figure, panels = plt.subplots(2, 2, figsize=(11, 4.6), width_ratios=(3, 2))
    for (device, title), (frames, step) in zip(DEVICES.items(), panels):
        mine = [row for row in rows if row["device"] == device]
        seen = [row for row in mine if row["view"] == "frames"]
        lanes(frames, seen, ("step", "render"))
        frames.set(title=f"{title}: three frames", xlim=(0, 160), xlabel="ms")
        within = [row for row in mine if row["view"] == "step"]
        lanes(step, within, ("step", "square_root", "operation"))
        length = max(row["end_ms"] for row in within)
        step.set(title=f"{title}: a step of {length:.2f} ms", xlim=(0, length), xlabel="ms")
    return figure
