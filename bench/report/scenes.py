# SPDX-License-Identifier: GPL-3.0-or-later
"""Error against run time of each scene: one point per scalar, method and time step; the Pareto front."""
import math
import re
import statistics

import matplotlib.pyplot as plt
from matplotlib.lines import Line2D

import style

# The implementation of an arithmetic, as in `style`, if its name differs.
IMPLEMENTATION = {"nearest": "default", "avr-libc": "libc", "ieee": "libc"}
METHODS = {
    "explicit_euler": ("explicit Euler, as published", "X"),
    "semi_implicit_euler": ("semi-implicit Euler", "o"),
    "velocity_verlet": ("velocity Verlet", "^"),
    "implicit_springs": ("implicit springs", "s"),
    "direct_rods": ("Verlet with rods solved directly", "D"),
}
TARGETS = {"1 cm": 1e-2, "1 mm": 1e-3, "0.1 mm": 1e-4, "10 µm": 1e-5}
# Errors that differ by less count as the same error, that of the method.
SAME = 0.05
# An error below the accuracy of the truth has no place on a logarithmic axis.
FLOOR = 1e-12


def title(scene):
    return scene.replace("_", " ")


def is_split(row):
    """A scene's best split of 32 bits, which differs between scenes and has no style of its own."""
    return row["arithmetic"] == "nearest" and row["scalar"].startswith("q") and row["scalar"] not in style.FORMATS


def kind(row):
    """Its format and implementation, as in `style`."""
    return row["scalar"], IMPLEMENTATION.get(row["arithmetic"], row["arithmetic"])


def kinds(rows):
    """Those of the rows in a format that has a style, ours first, each by its range."""
    def place(of):
        number_format, implementation = of
        return (implementation == "published", number_format == "float", implementation == "compensated",
                [int(bits) for bits in re.findall(r"\d+", number_format)], implementation)
    return sorted({kind(row) for row in rows if row["scalar"] in style.FORMATS}, key=place)


def scalar(row):
    return "float" if row["scalar"] == "float" else style.label(*kind(row))


def size(row):
    """The error that runs are ranked by: the larger of the method's and the arithmetic's. Their sum can be smaller than
    either if the two happen to cancel."""
    return max(row["error_method"], row["error_arithmetic"])


def ours(row):
    return row["arithmetic"] in ("nearest", "saturating", "compensated")


def method(row):
    return METHODS[row["integrator"]][0].split(",")[0]


def step(row):
    return f"1/{round(1 / row['dt'])} s"


def measured(data, scene=None):
    """The runs on the chip that held and have a truth to be compared with."""
    return [row for row in data.rows("scenes")
            if row["cycles_per_simulated_second"] is not None and row["error"] is not None
            and row["verdict"] == "held" and scene in (None, row["scene"])]


def names(data):
    return list(dict.fromkeys(row["scene"] for row in data.rows("scenes")))


def judged(data):
    """Scenes with a truth."""
    return list(dict.fromkeys(row["scene"] for row in measured(data)))


def front(rows):
    """The rows that no other row beats in both error and cycles, by cycles."""
    best, kept = float("inf"), []
    for row in sorted(rows, key=lambda row: (row["cycles_per_simulated_second"], size(row))):
        if size(row) < best:
            best = size(row)
            kept.append(row)
    return kept


def cheapest(data, scene, error):
    """The run with the fewest cycles whose error is no larger, or None."""
    fit = [row for row in measured(data, scene) if size(row) <= error]
    return min(fit, key=lambda row: row["cycles_per_simulated_second"], default=None)


def float_wins(data):
    """For each scene the rows of float on its front whose error is smaller, by more than SAME, than that of the best of
    ours at no higher cost."""
    wins = []
    for scene in judged(data):
        rows = measured(data, scene)
        for row in front(rows):
            if row["scalar"] != "float":
                continue
            rivals = [rival for rival in rows if ours(rival)
                      and rival["cycles_per_simulated_second"] <= row["cycles_per_simulated_second"]]
            rival = min(rivals, key=size, default=None)
            if rival is not None and size(row) > (1 - SAME) * size(rival):
                continue
            match = min((other for other in rows if ours(other) and size(other) <= size(row)),
                        key=lambda other: other["cycles_per_simulated_second"], default=None)
            wins.append({"scene": scene, "row": row, "rival": rival, "match": match,
                         "reason": reason(row, rival, match)})
    return wins


def reason(row, rival, match):
    """Why none of ours is as good as that row at its cost, from the two parts of the rival's error."""
    if rival is None:
        return "none of ours is as cheap"
    if rival["error_arithmetic"] > rival["error_method"]:
        cause = (f"{scalar(rival)} errs by its resolution there "
                 f"({rival['error_arithmetic']:.1e} m, the method by {rival['error_method']:.1e} m)")
    else:
        cause = (f"{scalar(rival)} pays for {method(rival)} with steps of {step(rival)} there, whose "
                 f"own error is {rival['error_method']:.1e} m (its arithmetic's "
                 f"{rival['error_arithmetic']:.1e} m)")
    if match is None:
        return cause + "; none of ours reaches float's error"
    return (f"{cause}; ours reaches float's error as {scalar(match)}, {method(match)}, at "
            f"{match['cycles_per_simulated_second'] / 1e6:.3g} million cycles")


def total_leads(data):
    """For each scene in which float leads by the total error: the row of float that leads most, the best of ours at no
    higher cost, and the medians of both over the initial states, ours being the best of any run at no higher cost."""
    def run(row):
        return row["scene"], row["scalar"], row["arithmetic"].replace("ieee", "avr-libc"), row["integrator"], row["dt"]
    medians = {run(row): row["error_median"] for row in data.rows("initial_states") if row["held"] == row["states"]}

    def median(row):
        return medians.get(run(row), math.inf)

    found = []
    for scene in judged(data):
        rows = measured(data, scene)
        leads = []
        for row in rows:
            rivals = [rival for rival in rows if ours(rival)
                      and rival["cycles_per_simulated_second"] <= row["cycles_per_simulated_second"]]
            if row["scalar"] == "float" and rivals:
                best = min(rivals, key=lambda rival: rival["error"])
                if row["error"] < (1 - SAME) * best["error"]:
                    leads.append({"row": row, "rival": best, "median": median(row), "rival_median": min(map(median, rivals))})
        if leads:
            found.append(min(leads, key=lambda lead: lead["row"]["error"] / lead["rival"]["error"]))
    return found


def total_finding(data):
    """Where float would lead by the total error, and that it does not from other starts, in a sentence."""
    leads = total_leads(data)
    if not leads:
        return "By their sum float would lead in no scene either."
    told = [f"{title(lead['row']['scene'])} ({method(lead['row'])}, {step(lead['row'])}: {lead['row']['error']:.1e} m, ours "
            f"{lead['rival']['error']:.1e} m; over the initial states below its median is {lead['median']:.1e} m, that of ours at no "
            f"higher cost {lead['rival_median']:.1e} m)" for lead in leads]
    return f"By their sum float would lead from the scene's own start in {' and '.join(told)}."


def spread_finding(data):
    """How far the error of a run depends on where it starts, in a sentence."""
    rows = [row for row in data.rows("initial_states")
            if row["held"] == row["states"] and row["error_min"] > 0]
    ratio = sorted(row["error_max"] / row["error_min"] for row in rows)
    pairs = {(row["scene"], row["integrator"], row["dt"], row["scalar"]): row["error_median"] for row in rows}
    smaller = [pairs[key] <= (1 + SAME) * pairs[(*key[:3], "float")] for key in pairs
               if key[3] == "q8_24" and (*key[:3], "float") in pairs]
    return (f"Over {rows[0]['states']} seeded initial states, the largest error of a run is {ratio[len(ratio) // 2]:.1f} times the smallest "
            f"(median of the {len(rows)} runs that hold from all of them). With the same method and step, the median error over the "
            f"initial states is at most 5% larger in Q8.24 than in float in {sum(smaller)} of the {len(smaller)} runs that hold in both.")


def saturation(data):
    """For each scene the rows of Q16.16, Q16.16 saturating and float at 1/256 s that all took cycles."""
    kinds = [("q16_16", "nearest"), ("q16_16", "saturating"), ("float", "avr-libc")]
    lines = []
    for scene in names(data):
        rows = {(row["scalar"], row["arithmetic"]): row
                for row in data.rows("scenes", scene=scene, integrator="semi_implicit_euler")
                if row["dt"] == 1 / 256 and row["cycles_per_step_mean"] is not None}
        if all(kind in rows for kind in kinds):
            lines.append([rows[kind] for kind in kinds])
    return lines


def saturation_finding(data):
    """What saturation costs over the scenes, in a sentence."""
    lines = saturation(data)
    cost = sorted((saturating["cycles_per_step_mean"] / plain["cycles_per_step_mean"], title(plain["scene"]))
                  for plain, saturating, _ in lines)
    to_float = [saturating["cycles_per_step_mean"] / other["cycles_per_step_mean"] for _, saturating, other in lines]
    flash = [saturating["flash_bytes"] - plain["flash_bytes"] for plain, saturating, _ in lines]
    return (f"In {len(lines)} scenes with steps of 1/256 s, saturating Q16.16 takes {cost[0][0]:.3f} ({cost[0][1]}) to "
            f"{cost[-1][0]:.3f} ({cost[-1][1]}) times the cycles of plain Q16.16 and {min(to_float):.3f} to "
            f"{max(to_float):.3f} times those of float. Its flash differs from plain Q16.16's by {min(flash):+d} to {max(flash):+d} bytes.")


def failures(data):
    return [row for row in data.rows("scenes") if row["verdict"] != "held"]


def label_steps(axes, best):
    """Writes the time step next to the points of a front, from the most accurate on, where there is room."""
    axes.autoscale_view()
    used = []
    for row in reversed(best):
        where = axes.transData.transform((row["cycles_per_simulated_second"], max(size(row), FLOOR)))
        if all(abs(where - other).max() > 16 or abs(where - other)[1] > 7 for other in used):
            axes.annotate(step(row).removesuffix(" s"), fontsize=6, xytext=(3, 3), textcoords="offset points",
                          xy=axes.transData.inverted().transform(where))
            used.append(where)


def draw(data):
    scenes = judged(data)
    columns = 3
    lines = -(-len(scenes) // columns)
    figure, grid = plt.subplots(lines, columns, figsize=(11, 2.7 * lines + 0.9), squeeze=False)
    for axes, scene in zip(grid.flat, scenes):
        rows = measured(data, scene)
        for row in rows:
            axes.scatter(row["cycles_per_simulated_second"], max(size(row), FLOOR), s=22, zorder=3,
                         marker=METHODS[row["integrator"]][1], linewidths=0.8,
                         facecolors=style.face(*kind(row)), edgecolors=style.colour(*kind(row)))
        curves = {}
        for row in sorted(rows, key=lambda row: row["dt"]):
            curves.setdefault((kind(row), row["integrator"]), []).append(row)
        for (of, _), curve in curves.items():
            axes.plot([row["cycles_per_simulated_second"] for row in curve],
                      [max(size(row), FLOOR) for row in curve], linewidth=0.5, zorder=2,
                      color=style.colour(*of))
        best = front(rows)
        right = max(row["cycles_per_simulated_second"] for row in rows) * 1.3
        axes.step([row["cycles_per_simulated_second"] for row in best] + [right],
                  [max(size(row), FLOOR) for row in best] + [max(size(best[-1]), FLOOR)],
                  where="post", color="#888888", linewidth=1, zorder=2)
        axes.axvline(16e6, color=style.INK, linewidth=0.8, linestyle=":", zorder=1)
        axes.set(xscale="log", yscale="log", title=title(scene))
        label_steps(axes, best)
    for axes in list(grid.flat)[len(scenes):]:
        axes.set_axis_off()
    figure.supxlabel("cycles per simulated second (dotted: the chip's 16 million)")
    figure.supylabel("the larger of the method's and the arithmetic's error, m")
    drawn = kinds(measured(data))
    handles = [Line2D([], [], linestyle="", marker="o", markeredgecolor=style.colour(*of),
                      markerfacecolor=style.face(*of)) for of in drawn]
    handles.append(Line2D([], [], linestyle="", marker="o", color=style.OTHER[0]))
    handles += [Line2D([], [], linestyle="", marker=marker, color="#666666")
                for _, marker in METHODS.values()]
    labels = [style.label(*of) for of in drawn] + ["best split of 32 bits"]
    labels += [name for name, _ in METHODS.values()]
    style.legend_above(figure, handles, labels, 5)
    return figure


def draw_time_steps(data):
    """The errors of the method and of the arithmetic, against the time step."""
    scenes, drawn = judged(data), []
    columns = 3
    lines = -(-len(scenes) // columns)
    figure, grid = plt.subplots(lines, columns, figsize=(11, 2.5 * lines + 0.9), squeeze=False,
                                sharex=True)
    for axes, scene in zip(grid.flat, scenes):
        rows = [row for row in data.rows("scenes", scene=scene, integrator="velocity_verlet")
                if row["verdict"] == "held"]
        wide = [row for row in rows if row["scalar"] == "fifty_digits"]
        axes.plot([row["dt"] for row in wide], [max(row["error"], FLOOR) for row in wide],
                  color=style.INK, linewidth=1.2)
        for of in kinds(rows):
            points = [row for row in rows if kind(row) == of]
            drawn += points
            axes.plot([row["dt"] for row in points],
                      [max(row["error_arithmetic"], FLOOR) for row in points],
                      color=style.colour(*of), markerfacecolor=style.face(*of),
                      marker=style.marker(*of), markersize=3, linewidth=0.8)
        axes.set(xscale="log", yscale="log", title=title(scene))
    for axes in list(grid.flat)[len(scenes):]:
        axes.set_axis_off()
    figure.supxlabel("time step, s")
    figure.supylabel("error, m")
    shown = kinds(drawn)
    handles = [Line2D([], [], color=style.INK)]
    handles += [Line2D([], [], marker=style.marker(*of), color=style.colour(*of),
                       markerfacecolor=style.face(*of)) for of in shown]
    labels = ["error of velocity Verlet itself"] + ["arithmetic, " + style.label(*of) for of in shown]
    style.legend_above(figure, handles, labels, 3)
    return figure


def finding(data):
    """In how many scenes some point of float beats all of ours, in a sentence."""
    wins = {win["scene"] for win in float_wins(data)}
    return (f"In {len(judged(data)) - len(wins)} of {len(judged(data))} scenes, for every choice of float there is a choice of ours "
            f"that costs no more and errs no more (within {100 * SAME:.0f}%)"
            + (f"; not in {', '.join(sorted(map(title, wins)))}." if wins else "."))


def splits_finding(data):
    """On how many fronts the best split of 32 bits is, in a sentence; empty if none was run."""
    rows = [row for row in measured(data) if is_split(row)]
    on_front = {row["scene"] for scene in judged(data) for row in front(measured(data, scene)) if is_split(row)}
    used = sorted({row["scalar"] for row in rows}, key=lambda name: int(name[1:].split("_")[0]))
    return rows and (f"Each scene was also run in its best split of 32 bits: the one with the most fraction bits in which "
                     f"every number of its runs on the chip fits ({', '.join(map(style.format_label, used))}). It is on the "
                     f"front in {len(on_front)} of {len(judged(data))} scenes.")


def compensated_finding(data):
    """What compensated integration costs, gains, and on how many fronts it is, in a sentence; empty if none was run."""
    rows = [row for row in measured(data) if row["arithmetic"] == "compensated"]
    if not rows:
        return ""

    def told(name):
        mine = [row for row in rows if row["scalar"] == name]
        pairs = [(row, plain) for row in mine for plain in data.some("scenes", **{
            key: row[key] for key in ("scene", "scalar", "integrator", "dt")}, arithmetic="nearest")]
        cycles = [row["cycles_per_step_mean"] / plain["cycles_per_step_mean"] for row, plain in pairs]
        errors = statistics.median(plain["error_arithmetic"] / row["error_arithmetic"] for row, plain in pairs)
        on_front = {row["scene"] for row in mine if row in front(measured(data, row["scene"]))}
        return (f"in {style.format_label(name)} it takes {min(cycles):.2f} to {max(cycles):.2f} times the cycles, the arithmetic's "
                f"error is {errors:.2g} times smaller (median), and it is on {len(on_front)} fronts")
    names = dict.fromkeys(row["scalar"] for row in rows)
    return f"With compensated integration: {'; '.join(map(told, names))}."


def turning(data):
    """In how many scenes a shorter step makes Q16.16's velocity Verlet worse, in a sentence."""
    worse = []
    for scene in judged(data):
        rows = sorted((row for row in measured(data, scene) if row["scalar"] == "q16_16"
                       and row["arithmetic"] == "nearest" and row["integrator"] == "velocity_verlet"),
                      key=lambda row: row["dt"])
        if size(rows[0]) > min(map(size, rows)):
            worse.append(title(scene))
    return (f"In {len(worse)} of {len(judged(data))} scenes the shortest step that was run on the chip is "
            "not the best one for Q16.16 with velocity Verlet: the arithmetic's error, which grows with "
            "the number of steps, then outweighs what the method gains.")
