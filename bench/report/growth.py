# SPDX-License-Identifier: GPL-3.0-or-later
"""The cost of a step against the number of particles, and its fit."""
import matplotlib.pyplot as plt

SEARCHES = {"brute_force": ("#d55e00", "o", "every pair"),
            "sort_and_sweep": ("#0072b2", "s", "sort and sweep")}


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
