# SPDX-License-Identifier: GPL-3.0-or-later
"""The cost of a step against the number of particles, and the work that determines it."""
import statistics

import matplotlib.pyplot as plt

import style

SEARCHES = {"brute_force": (style.PALE, "o", "every pair"),
            "sort_and_sweep": (style.INK, "s", "sort and sweep"),
            "box2d": (style.RIVAL[1], "^", "Box2D")}


def crossing(rows):
    """The smallest number of particles from which sort and sweep is cheaper."""
    cost = {name: {row["particles"]: row["cost_per_step"] for row in rows
                   if row["broad_phase"] == name} for name in SEARCHES}
    first = None
    for count in sorted(cost["sort_and_sweep"]):
        if cost["sort_and_sweep"][count] < cost["brute_force"].get(count, float("inf")):
            first = count if first is None else first
        else:
            first = None
    return first


def beside_box2d(rows):
    """The cost of a step of the most discs in Box2D and in our engine."""
    most = max(row["particles"] for row in rows)
    ours, theirs = (row["cost_per_step"] for name in ("sort_and_sweep", "box2d") for row in rows
                    if (row["broad_phase"], row["particles"]) == (name, most))
    ratios = [row["cost_per_step"] / own["cost_per_step"] for row in rows for own in rows
              if row["broad_phase"] == "box2d" and own["broad_phase"] == "sort_and_sweep"
              and row["particles"] == own["particles"]]
    return (f"There {most} discs take {ours / 1e6:.2f} ms a step in Q16.16 and {theirs / 1e6:.2f} ms in Box2D's float; "
            f"over all numbers of discs Box2D takes {min(ratios):.2f} to {max(ratios):.2f} times as long as ours.")


def fits(rows):
    """For either broad phase: what is fitted, by which term, and the largest deviation."""
    told = {row["broad_phase"]: (row["fit_of"], row["fit_term"], row["fit_worst_percent"]) for row in rows if row["fit_of"]}
    of, = {of for of, _, _ in told.values()}
    terms = {search: term if term.startswith("N^") else f"the {term} tested" for search, (_, term, _) in told.items()}
    missed = {}
    for search, (_, _, miss) in told.items():
        missed.setdefault(terms[search], []).append(f"{SEARCHES[search][2]}: within {miss:.1f}%")
    return (f"the {of} of a step follow a + b N + c times "
            + " and ".join(f"{term} ({'; '.join(misses)})" for term, misses in missed.items()) + ".")


def times_of_tests(rows):
    """The smallest, the median and the largest time of a test, by broad phase."""
    times = {}
    for row in rows:
        if row["ns_per_test"]:
            times.setdefault(row["broad_phase"], []).append(row["ns_per_test"])
    return {search: (min(found), statistics.median(found), max(found)) for search, found in times.items()}


def time_of_a_test(rows):
    """The sentence that says what the time is, and that it does not follow one line."""
    spread = " and ".join(f"{least:.2f} to {most:.2f} ns ({SEARCHES[search][2]}, median {middle:.2f})"
                          for search, (least, middle, most) in times_of_tests(rows).items())
    return (f"Times are reported, not bounded: a test, including its share of everything else in a step, takes {spread}. The times do not "
            "follow one line; the reason was not measured.")


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
            if not mine:
                continue  # Box2D does not run on the chip
            counts = [row["particles"] for row in mine]
            axes.plot(counts, [row["cost_per_step"] for row in mine], marker, color=colour,
                      label=label)
            if mine[0]["fit_of"]:
                # On the host the tests are fitted: they are scaled by the median time of one.
                scale = times_of_tests(mine)[search][1] if logarithmic else 1
                axes.plot(counts, [scale * row["fitted"] for row in mine], "-", color=colour, linewidth=1)
        axes.set(title=title, xlabel="particles in a box")
        if logarithmic:
            # The fit may be negative for few particles: the measured costs determine the axis.
            costs = [row["cost_per_step"] for row in rows]
            axes.set(xscale="log", yscale="log", ylim=(min(costs) / 2, max(costs) * 2))
        else:
            axes.set_ylim(bottom=0)
        axes.legend()
    return figure


def finding(data):
    """From what number of particles sort and sweep is cheaper, in this box and in the lever's scene."""
    def told(rows, where):
        count = crossing(rows)
        return f"never cheaper {where}" if count is None else f"cheaper from {count} particles upwards {where}"

    parts = [told(data.rows("growth"), "on the chip")]
    if data.has("growth_host"):
        parts.append(told(data.rows("growth_host"), "on the host"))
    text = "In this box sort and sweep is " + " and ".join(parts) + "."
    if data.has("growth_host"):
        text += " " + beside_box2d(data.rows("growth_host"))
    text += " On the chip " + fits(data.rows("growth"))
    if data.has("growth_host"):
        rows = data.rows("growth_host")
        text += f" On the host, where the four walls are tested as well, {fits(rows)} {time_of_a_test(rows)}"
    if data.has("features"):
        cost = {row["feature"]: row["cycles_per_step_mean"] for row in data.rows("features", scene="lever")
                if row["feature"].startswith("broad phase=") and row["with"] == "yes"}
        brute, sweep = (cost.get(f"broad phase={name}") for name in ("BruteForce", "SortAndSweep"))
        if brute and sweep:
            text += (f" In the lever's scene, where few particles meet, it takes {sweep:.0f} cycles a step "
                     f"and every pair {brute:.0f}.")
    return text
