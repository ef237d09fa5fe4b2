# SPDX-License-Identifier: GPL-3.0-or-later
"""The cost of a step against the number of particles, and its fit."""
import matplotlib.pyplot as plt

import style

SEARCHES = {"brute_force": (style.PALE, "o", "every pair"),
            "sort_and_sweep": (style.INK, "s", "sort and sweep")}


def crossing(rows):
    """The fewest particles from which on sort and sweep is the cheaper."""
    cost = {name: {row["particles"]: row["cost_per_step"] for row in rows
                   if row["broad_phase"] == name} for name in SEARCHES}
    first = None
    for count in sorted(cost["sort_and_sweep"]):
        if cost["sort_and_sweep"][count] < cost["brute_force"].get(count, float("inf")):
            first = count if first is None else first
        else:
            first = None
    return first


def draw(data):
    places = [("growth", "ATmega328P, Q16.16, cycles a step", False)]
    if data.has("growth_host"):
        places.append(("growth_host", "this project's host, nanoseconds a step", True))
    figure, panels = plt.subplots(1, len(places), figsize=(9, 3.8), squeeze=False)
    for axes, (name, title, logarithmic) in zip(panels[0], places):
        rows = data.rows(name)
        for search, (colour, marker, label) in SEARCHES.items():
            mine = sorted((row for row in rows if row["broad_phase"] == search),
                          key=lambda row: row["particles"])
            counts = [row["particles"] for row in mine]
            axes.plot(counts, [row["cost_per_step"] for row in mine], marker, color=colour,
                      label=label)
            axes.plot(counts, [row["fitted"] for row in mine], "-", color=colour, linewidth=1)
        axes.set(title=title, xlabel="particles in a box")
        if logarithmic:
            # The fit of a few particles may be negative: the measured costs set the axis.
            costs = [row["cost_per_step"] for row in rows]
            axes.set(xscale="log", yscale="log", ylim=(min(costs) / 2, max(costs) * 2))
        else:
            axes.set_ylim(bottom=0)
        axes.legend()
    return figure


def finding(data):
    """From how many particles on sort and sweep is cheaper, in this box and in the lever's scene."""
    def told(rows, where):
        count = crossing(rows)
        return f"never cheaper {where}" if count is None else f"cheaper from {count} particles on, {where}"

    parts = [told(data.rows("growth"), "on the chip")]
    if data.has("growth_host"):
        parts.append(told(data.rows("growth_host"), "on the host, whose times vary from run to run"))
    text = "In this box sort and sweep is " + " and ".join(parts) + "."
    if data.has("features"):
        cost = {row["feature"]: row["cycles_per_step_mean"] for row in data.rows("features", scene="lever")
                if row["feature"].startswith("broad phase=") and row["with"] == "yes"}
        brute, sweep = (cost.get(f"broad phase={name}") for name in ("BruteForce", "SortAndSweep"))
        if brute and sweep:
            text += (f" In the lever's scene, where few particles meet, it takes {sweep:.0f} cycles a step "
                     f"and every pair {brute:.0f}.")
    return text
