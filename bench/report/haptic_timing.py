# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures 4.1 to 4.3 measured again, from the profiling pins: step and rendering over three frames, and contacts, roots
and operations within a step."""
import matplotlib.pyplot as plt

DEVICES = {"published": "as published, rebuilt", "q16_16": "ours, Q16.16"}
# Shades: the colours of number formats are not used here.
COLOURS = {"step": "#222222", "render": "#bbbbbb", "contacts found": "#888888",
           "contacts solved": "#555555", "square_root": "#777777", "operation": "#999999"}
LABELS = {"square_root": "square roots", "operation": "products, quotients"}


def lanes(axes, rows, pins):
    """One lane per pin, with how often and for how long in total it was high."""
    for lane, pin in enumerate(reversed(pins)):
        spans = [(row["begin_ms"], row["end_ms"] - row["begin_ms"]) for row in rows
                 if row["pin"] == pin]
        axes.broken_barh(spans, (lane - 0.35, 0.7), color=COLOURS[pin], linewidth=0)
        high = sum(length for _, length in spans)
        axes.annotate(f"{len(spans)} × {high / max(len(spans), 1):.3g} ms", (1.01, lane),
                      xycoords=("axes fraction", "data"), fontsize=7, va="center")
    axes.set_yticks(range(len(pins)), [LABELS.get(pin, pin) for pin in reversed(pins)])
    axes.set_ylim(-0.6, len(pins) - 0.4)
    axes.grid(axis="y", visible=False)


def with_contacts_told_apart(rows):
    """The pin of the collisions is high twice in each step: while contacts are found, then solved."""
    names = iter(("contacts found", "contacts solved"))
    return [row | {"pin": next(names)} if row["pin"] == "collision" else row for row in rows]


def draw(data):
    rows = data.rows("haptic_pins")
    figure, panels = plt.subplots(2, 2, figsize=(12, 5.2), width_ratios=(1, 1))
    for (device, title), (frames, step) in zip(DEVICES.items(), panels):
        mine = [row for row in rows if row["device"] == device]
        seen = [row for row in mine if row["view"] == "frames"]
        lanes(frames, seen, ("step", "render"))
        frames.set(title=f"{title}: three frames", xlim=(0, 160), xlabel="ms")
        within = with_contacts_told_apart([row for row in mine if row["view"] == "step"])
        lanes(step, within, ("step", "contacts found", "contacts solved", "square_root", "operation"))
        length = max(row["end_ms"] for row in within)
        step.set(title=f"{title}: a step of {length:.2f} ms", xlim=(0, length), xlabel="ms")
    return figure
