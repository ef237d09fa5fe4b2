# SPDX-License-Identifier: GPL-3.0-or-later
"""Where scenes stay stable, by format and method, with theoretical bounds."""
import math
import pathlib
import re

import matplotlib.pyplot as plt

import style

# The default arithmetic of a format.
DEFAULT = ["nearest", "ieee"]
# The cases of the envelope that the page shows.
ENVELOPE = ("far_from_origin", "rod_span", "rod_short", "half_space", "slow", "spring_stiffness", "spring_slow", "light_body",
            "heavy_body", "small_binary_step")
EXAMPLE = "rod_chain_of_8_heavy_end"  # of what it means that a case holds
CASES = pathlib.Path(__file__).parents[1] / "experiments" / "stability" / "cases"
# The chains of rods that bear a load, by the step: the case's name after the number of rods, and the step's exponent.
LOADED_CHAINS = {8: "_heavy_end", 11: "_heavy_end_fine_steps"}
LOADED_LINKS = (4, 8, 16)
LOAD = 1e5  # a mass ratio that steps of 1/256 s do not resolve
LOADED_SPRINGS = (4, 16)
LINK, GRAVITY = map(float, re.search(r"link_length = ([\d.]+), chain_gravity = ([\d.]+);",
                                     (CASES / "links.cpp").read_text(encoding="utf-8")).groups())
# The case `stiffness` fails where a spring's amplitude has grown by this factor in this many steps.
SPRINGS = CASES / "springs.cpp"
GROWTH, STEPS = map(int, re.search(r"growth = (\d+), growth_steps = (\d+);", SPRINGS.read_text(encoding="utf-8")).groups())
METHODS = ["explicit_euler", "semi_implicit_euler", "velocity_verlet", "implicit_springs"]
METHOD_LABELS = {"explicit_euler": "explicit Euler (2016 design)",
                 "semi_implicit_euler": "semi-implicit Euler",
                 "velocity_verlet": "velocity Verlet",
                 "implicit_springs": "springs solved implicitly"}


def formats(rows):
    """The formats of the rows, by their range."""
    return sorted({row["scalar"] for row in rows},
                  key=lambda name: [int(bits) for bits in re.findall(r"\d+", name)] or [math.inf])


def number(cell):
    return math.nan if cell in (None, "none", "") else float(cell)


def whole(value):
    """An integer with its thousands separated."""
    return f"{value:,}".replace(",", "\u202f")


def figure(value):
    """A cell of the page's tables: a number to three significant digits, as a power of ten if it is very small or
    large; a text unchanged."""
    if not isinstance(value, (int, float)):
        return str(value)
    if value == 0:
        return "0"
    mantissa, exponent = f"{value:.2e}".split("e")
    if -3 <= int(exponent) <= 2:
        return f"{float(f'{value:.3g}'):g}"
    if 3 <= int(exponent) <= 5:
        return whole(round(float(f"{value:.2e}")))
    factor = "" if float(mantissa) == 1 else f"{float(mantissa):g}·"
    return f"{factor}10<sup>{int(exponent)}</sup>".replace("-", "−")


def silent(rows, arithmetic):
    """For Q16.16 in the engine's own methods: all rows, those that end because a result wraps within a step, and those
    that end because the format cannot hold a number of the scene."""
    mine = [row for row in rows if row["scalar"] == "q16_16" and row["arithmetic"] == arithmetic
            and row["integrator"] != "explicit_euler"]
    ended = [row for row in mine if row["verdict"] == "overflows"]
    unfit = [row for row in ended if row["first_event"].startswith("overflow convert")]
    return len(mine), len(ended) - len(unfit), len(unfit)


def announced(rows):
    """For plain Q16.16 in the engine's own methods: the rows that wrap and for how many of them the prediction found a
    result beyond the format; the rows that hold up to some limit, and for how many of them it did. None if the data have
    no predictions."""
    mine = [row for row in rows if row["scalar"] == "q16_16" and row["arithmetic"] == "nearest"
            and row["integrator"] != "explicit_euler"]
    if "bits_beyond" not in rows[0]:
        return None
    wraps = [row for row in mine if row["verdict"] == "overflows" and not row["first_event"].startswith("overflow convert")]
    holds = [row for row in mine if isinstance(row["limit"], (int, float)) and isinstance(row["bits_at_limit"], (int, float))]
    return (len(wraps), sum(isinstance(row["bits_beyond"], (int, float)) and row["bits_beyond"] < 0 for row in wraps),
            len(holds), sum(row["bits_at_limit"] < 0 for row in holds))


def has_loaded_chains(rows):
    return any(row["case"].endswith(LOADED_CHAINS[11]) for row in rows)


def load_bound(links, exponent):
    """The largest mass ratio at which a step of 2^-exponent s resolves the vibration of the links of a loaded chain.
    Between the anchor and a weight of R links that hardly moves, n - 1 links of the length L are a string under the tension
    R g: the highest of its frequencies is omega^2 = 2 (1 + cos(pi / n)) R g / L. Steps are stable up to omega h = 2."""
    return 2 * LINK / (GRAVITY * 4.0**-exponent * (1 + math.cos(math.pi / links)))


def steps_for_load(links):
    """The steps per second at which load_bound is LOAD."""
    return math.sqrt(LOAD / load_bound(links, 0))


def loaded_chains(rows):
    """Step, links, format, and the mass ratios borne with ten iterations, with ten that begin where the last step ended,
    with all rods solved together, and with one iteration; the bound."""
    limits = {(row["case"], row["scalar"], row["integrator"]): row for row in rows if row["arithmetic"] in DEFAULT}
    for exponent, ending in LOADED_CHAINS.items():
        for links in LOADED_LINKS:
            for scalar in ("q16_16", "q32_32", "float"):
                found = [limits[f"rod_chain_of_{links}{ending}", scalar, method]
                         for method in ("semi_implicit_euler", "warm_started", "direct_rods", "one_iteration")]
                yield exponent, links, scalar, [row["limit"] for row in found], load_bound(links, exponent)


def cost_of_small_steps(data):
    """Cycles of eight steps of one iteration, in percent of a step of ten iterations, for the loaded chains in Q16.16."""
    fine = data.rows("ablations", ablation="ten iterations in place of one")
    whole = {row["case"]: row["before_cycles"] for row in data.rows("ablations", ablation="iterations begun where the last step ended")}
    shares = [100 * 8 * row["before_cycles"] / whole[row["case"].removesuffix("_fine_steps")] for row in fine]
    return f"{min(shares):.0f} to {max(shares):.0f} %"


def costs(data, ablation, chain="rod_chain", lengths=LOADED_LINKS):
    """Cycles of a step of the loaded chains with a method, in percent of those without it, in Q16.16."""
    rows = {row["case"]: row for row in data.rows("ablations", ablation=ablation)}
    mine = [rows[f"{chain}_of_{links}_heavy_end"] for links in lengths]
    shares = [100 * row["after_cycles"] / row["before_cycles"] for row in mine]
    return f"{min(shares):.0f} to {max(shares):.0f} %"


def load_finding(data):
    """The loads that chains bear with each solver, in one line; nothing if the data have none."""
    rows = data.rows("stability")
    if not has_loaded_chains(rows):
        return ""
    loads, reached = {}, []
    for exponent, _, scalar, limits, bound in loaded_chains(rows):
        if (exponent, scalar) == (8, "q32_32"):
            reached.append(100 * limits[2] / bound)
        for name, load in zip(("iterated", "warm", "direct", "one", "bound"), (*limits, bound)):
            loads.setdefault((exponent, scalar, name), []).append(figure(load))

    def told(*key):
        return ", ".join(loads[key])
    fine = "; ".join(f"in {style.format_label(scalar)} {told(11, scalar, 'warm')} and {told(11, scalar, 'direct')}"
                     for scalar in ("q32_32", "float"))
    return (f"Chains of 4, 8 and 16 rods of 1 kg, pushed sideways, bear a last body of {told(8, 'q16_16', 'iterated')} kg in Q16.16 with "
            f"ten iterations in each step of 1/256 s; {told(8, 'q16_16', 'warm')} kg where these begin with the last step's result "
            f"(`WarmStartedGaussSeidel`, {costs(data, 'iterations begun where the last step ended')} of the cycles); and "
            f"{told(8, 'q16_16', 'direct')} kg with all rods solved together (`DirectRods`, {costs(data, 'rods solved together')}). "
            f"Eight steps of 1/2048 s with one iteration in each bear {told(11, 'q16_16', 'one')} kg, for {cost_of_small_steps(data)}. "
            f"The step itself allows {told(8, 'q16_16', 'bound')} kg in any format: beyond, it no longer resolves the vibration of a link "
            f"under the weight, as no explicit step does where *ω dt* is above 2. In Q32.32 all rods solved together bear "
            f"{min(reached):.1f} to {max(reached):.1f} % of that. {figure(LOAD)} kg take {', '.join(f'{steps_for_load(n):.0f}' for n in LOADED_LINKS)} "
            f"steps a second, or an implicit treatment of that vibration. With steps of 1/2048 s the two solvers bear, {fine}.")


def spring_finding(data):
    """The loads that chains of stiff springs bear with each method, in a sentence; nothing if the data have none."""
    limits = {(row["case"], row["integrator"]): row["limit"] for row in data.rows("stability")
              if row["scalar"] == "q16_16" and row["arithmetic"] == "nearest"}
    if (f"spring_chain_of_{LOADED_SPRINGS[0]}_heavy_end", "direct_springs") not in limits:
        return ""

    def told(method):
        return " and ".join(figure(limits[f"spring_chain_of_{links}_heavy_end", method]) for links in LOADED_SPRINGS)

    def cost(ablation):
        return costs(data, ablation, "spring_chain", LOADED_SPRINGS)
    return (f" On springs too stiff for the step, chains of {' and '.join(map(str, LOADED_SPRINGS))} bodies bear a last one of "
            f"{told('implicit_springs')} times the mass of the others in Q16.16 if the springs are solved one after the other "
            f"(`ImplicitSprings`), {told('gauss_seidel_springs')} times in ten iterations (`GaussSeidelSprings`, "
            f"{cost('springs solved in ten iterations')} of the cycles) and {told('direct_springs')} times together (`DirectSprings`, "
            f"{cost('springs solved together')}).")


def points(rows, name, scalar, method, arithmetic=None):
    """The x and the limits of a map's line, in order of x."""
    mine = [row for row in rows if row["map"] == name and row["scalar"] == scalar
            and row["integrator"] == method
            and row["arithmetic"] in ([arithmetic] if arithmetic else DEFAULT)]
    mine.sort(key=lambda row: number(row["x"]))
    return [number(row["x"]) for row in mine], [number(row["limit"]) for row in mine]


def bound(rows, name):
    mine = {number(row["x"]): number(row["bound"]) for row in rows if row["map"] == name}
    return sorted(mine), [mine[x] for x in sorted(mine)]


def stiffness_bound(rows, method):
    """The stiffness limit of the method in theory, at each step: semi-implicit Euler and Verlet oscillate up to omega
    dt = 2. Explicit Euler grows at any step, by sqrt(1 + (omega dt)^2): its limit is where that reaches GROWTH in
    STEPS. Springs that are solved implicitly have no limit."""
    steps, limits = bound(rows, "stiffness_upper")
    if method == "implicit_springs":
        return [], []
    if method == "explicit_euler":
        limits = [(GROWTH ** (2 / STEPS) - 1) / dt**2 for dt in steps]
    return steps, limits


def panels(methods, x_label, y_label):
    """One panel per method, two in a row, outer axes labelled."""
    lines = len(methods) // 2
    figure, grid = plt.subplots(lines, 2, figsize=(9, 3.5 * lines), sharex=True, sharey=True)
    for axes, method in zip(grid.flat, methods):
        axes.set(xscale="log", yscale="log", title=METHOD_LABELS[method], xlabel=x_label, ylabel=y_label)
        axes.label_outer()
    return figure, grid


def finish(figure, grid):
    handles, labels = grid.flat[0].get_legend_handles_labels()
    style.legend_above(figure, handles, labels, len(labels))
    return figure


def draw_stiffness(data):
    """The band of stiffness in which a spring of 1 kg oscillates, against the step."""
    rows = data.rows("stability_map")
    shown = formats(rows)
    figure, grid = panels(METHODS, "step, s", "stiffness, N/m")
    for axes, method in zip(grid.flat, METHODS):
        for scalar in shown:
            x, high = points(rows, "stiffness_upper", scalar, method)
            low = points(rows, "stiffness_lower", scalar, method)[1]
            colour = style.colour(scalar)
            # Markers below others are drawn larger, since formats with the same limit cover each other.
            look = {"color": colour, "marker": style.marker(scalar), "markersize": 3,
                    "linewidth": 1 + 0.6 * (len(shown) - 1 - shown.index(scalar))}
            axes.plot(x, high, label=style.format_label(scalar), **look)
            axes.plot(x, low, linestyle=":", **look)
            axes.fill_between(x, low, high, color=colour, alpha=0.06, linewidth=0)
        axes.plot(*stiffness_bound(rows, method), color="black", linewidth=1, linestyle="--",
                  label="the method's own bound")
    return finish(figure, grid)


def energy_gained(rows, system, scalar, method):
    """The steps after which the energy of a motion was measured, the fraction that it had gained or lost, and the one that
    theory predicts where it predicts a change; nan for a run that wrapped."""
    mine = sorted((row for row in rows if row["measure"] == "energy" and row["system"] == system and row["scalar"] == scalar
                   and row["integrator"] == method and row["arithmetic"] in DEFAULT), key=lambda row: row["at"])
    return ([row["at"] for row in mine], [abs(number(row["measured"])) for row in mine],
            [abs(number(row["theory"])) or math.nan for row in mine])


def draw_energy(axes, rows, system):
    """The energy that a motion gains or loses, against the steps: a colour for each format, a line for each method."""
    for method, line in zip(METHODS, (":", "-", "--", "-.")):
        for scalar in formats(rows):
            steps, gained, theory = energy_gained(rows, system, scalar, method)
            axes.plot(steps, gained, linestyle=line, color=style.colour(scalar), marker=style.marker(scalar), markersize=3,
                      linewidth=1)
        axes.plot(steps, theory, linestyle=line, color="black", linewidth=1)
        axes.plot([], [], linestyle=line, color=style.PALE, label=METHOD_LABELS[method])
    axes.set(xscale="log", yscale="log", ylim=(1e-9, 1e3), title=system, xlabel="steps")


def draw_speed(data):
    """The speed on a rod that keeps its length, against that length. All methods but explicit Euler share a panel: see
    speed_finding. Below, the energy that motions gain over many steps, and in black what theory predicts."""
    rows = data.rows("stability_map")
    shown = formats(rows)
    systems = ("spring", "orbit", "pendulum") if data.has("dynamics") else ()
    figure = plt.figure(figsize=(9, 6.5 if systems else 3.5))
    grid = figure.add_gridspec(2 if systems else 1, 6)
    speeds = [figure.add_subplot(grid[0, :3])]
    speeds.append(figure.add_subplot(grid[0, 3:], sharex=speeds[0], sharey=speeds[0]))
    for axes, method in zip(speeds, METHODS):
        for scalar in shown:
            x, y = points(rows, "speed", scalar, method)
            axes.plot(x, y, color=style.colour(scalar), marker=style.marker(scalar), markersize=4,
                      linewidth=1 + 0.6 * (len(shown) - 1 - shown.index(scalar)), label=style.format_label(scalar))
        axes.plot(*bound(rows, "speed"), color="black", linewidth=1, linestyle="--",
                  label="v dt = r")
        axes.set(xscale="log", yscale="log", title=METHOD_LABELS[method], xlabel="radius, m")
    speeds[0].set_ylabel("largest speed, m/s")
    for column, system in enumerate(systems):
        draw_energy(figure.add_subplot(grid[1, 2 * column:2 * column + 2]), data.rows("dynamics"), system)
    if systems:
        figure.axes[2].set_ylabel("change of energy / energy")
        figure.axes[2].legend(fontsize=6, loc="lower left")
    handles, labels = speeds[0].get_legend_handles_labels()
    style.legend_above(figure, handles, labels, len(labels))
    return figure


def speed_finding(data):
    """How far the methods whose speed on a circle is not drawn are from the one that is, in a sentence."""
    rows = data.rows("stability_map")
    drawn, others = METHODS[1], METHODS[2:]
    apart = 0.0
    for scalar in formats(rows):
        limits = dict(zip(*points(rows, "speed", scalar, drawn)))
        for method in others:
            alike = dict(zip(*points(rows, "speed", scalar, method)))
            if alike.keys() != limits.keys():
                raise ValueError(f"{method} has other radii than {drawn} in {scalar}")
            apart = max([apart] + [abs(alike[x] / limits[x] - 1) for x in limits if not math.isnan(limits[x])])
    names = " and ".join(METHOD_LABELS[method] for method in others)
    told = f"differ by up to {100 * apart:.2g} %" if apart else "are the same"
    return (f"The second figure shows the speed on a circle with {METHOD_LABELS[drawn]} and with the 2016 design's explicit Euler. The "
            f"limits of {names} {told}.")


def with_end(row):
    """A limit, marked if it is only the end of the search."""
    return ("beyond " if str(row["limited_by"]).startswith("stable") else "") + figure(row["limit"])


def by_gsl(rows):
    """How many cases are judged by an integration of GSL."""
    return len({row["case"] for row in rows if str(row["reference"]).startswith("GSL")})


def finding(data):
    """What the engine's methods and formats withstand, in a sentence or two."""
    rows = data.rows("stability")
    held = {scalar: sum(row["verdict"] == "stable" for row in rows if row["scalar"] == scalar
                        and row["arithmetic"] in DEFAULT and row["integrator"] == "semi_implicit_euler")
            for scalar in ("q16_16", "float")}
    cases = len({row["case"] for row in rows})
    plain, wraps, _ = silent(rows, "nearest")
    saturating, saturating_wraps, _ = silent(rows, "saturating")
    told = announced(rows)
    beforehand = (f" (of which `fixbench advise` announces {told[1]} before the scene runs on the chip, and {told[3]} of the "
                  f"{told[2]} runs that hold)" if told else "")
    return (f"{cases} cases are driven until they break. With the semi-implicit step, {held['q16_16']} of them still hold in "
            f"Q16.16 where the search ends, and {held['float']} in float. Over all methods of the engine, plain Q16.16 wraps "
            f"silently in {wraps} of {plain} runs{beforehand}, saturating Q16.16 in {saturating_wraps} of {saturating}.")


def again(row):
    """How many times the limit a value beyond it is that holds again, or its inverse where small values are hard; 1 if none
    does."""
    if row["holds_again"] is None:
        return 1
    ratio = row["holds_again"] / row["limit"]
    return max(ratio, 1 / ratio)


def named(row, in_format=True):
    """A row of stability.csv in words: case, format and method."""
    method = METHOD_LABELS.get(row["integrator"], row["integrator"].replace("_", " "))
    return row["case"].replace("_", " ") + (f" in {style.format_label(row['scalar'])}" if in_format else "") + f" ({method})"


def sweep_finding(rows):
    """Whether what breaks at one value also breaks beyond it, in some sentences."""
    swept = [row for row in rows if row["swept"] is not None]
    contradicted = [row for row in swept if row["contradicting"]]
    values = [row["swept"] for row in swept]
    told = (f"In {len(swept)} rows, {min(values)} to {max(values)} values from the easy end to the hard one are swept; the first that fails, "
            f"and a bisection next to it, give the limit. ")
    if not contradicted:
        return told + "No value of any sweep contradicts it."

    def of_worst(some, in_format):
        worst = max(some, key=lambda row: (again(row), row["integrator"] == "semi_implicit_euler"))
        return f"{named(worst, in_format)}, which fails beyond {figure(worst['limit'])} {worst['unit']} and holds again at {figure(worst['holds_again'])}"
    plain = [row for row in contradicted if row["arithmetic"] in DEFAULT]
    ours = [row for row in plain if row["scalar"] == "q16_16" and again(row) > 1]
    return (f"{told}{len(contradicted)} of them are not monotone: values beyond the limit hold, or easier ones fail (`contradicting` counts "
            f"them)." + (f" The worst is {of_worst(plain, True)}" if plain else "")
            + (f"; in Q16.16 it is {of_worst(ours, False)}." if ours else "." if plain else ""))


def horizon_finding(rows):
    """What a case that holds does, and over which horizons, in two sentences."""
    steps, seconds = [row["steps"] for row in rows], [row["steps"] * row["dt"] for row in rows]
    example = next(row for row in rows if row["case"] == EXAMPLE)
    return (f"*Stable* means within the tolerance of the case until the end of its horizon: {whole(min(steps))} to "
            f"{whole(max(steps))} steps, {figure(min(seconds))} to {figure(max(seconds))} s. Each row has both at its limit, and the "
            f"tolerance in words: columns `dt`, `steps` and `holds`; of {EXAMPLE.replace('_', ' ')} {example['steps']} steps of "
            f"1/{1 / example['dt']:g} s, \"{example['holds']}\".")


def chain_finding(data):
    """Whether the format matters for the load that a chain of rods withstands, in a sentence."""
    rows = [row for row in data.rows("stability_map", map="mass_ratio")
            if row["integrator"] == "semi_implicit_euler" and row["arithmetic"] in DEFAULT]
    shortest = min(number(row["x"]) for row in rows)
    longest = max(number(row["x"]) for row in rows)

    def limits(x):
        return [number(row["limit"]) for row in rows if number(row["x"]) == x]
    return (f"At its end, a hanging chain of {shortest:.0f} rods bears a mass of {min(limits(shortest)):.3g} to "
            f"{max(limits(shortest)):.3g} links, one of {longest:.0f} rods {min(limits(longest)):.3g} to "
            f"{max(limits(longest)):.3g}. The format changes this by a factor of up to "
            f"{max(max(limits(row['x'])) / min(limits(row['x'])) for row in rows):.2g}, the length by a factor of "
            f"{max(limits(shortest)) / max(limits(longest)):.2g}.")


def dynamics(data, scalar, integrator):
    """For a scalar and a method: the largest distance of the growth per step from theory, the energy gained after the
    most steps by system, the distance from the start after a reversal, the dead band with its bound, and the period of
    the limit cycle; None if a run does not fit or wraps."""
    rows = [row for row in data.rows("dynamics", scalar=scalar, integrator=integrator)
            if row["arithmetic"] in DEFAULT]

    def of(measure, system=None):
        return [row for row in rows if row["measure"] == measure and system in (None, row["system"])]
    growth = [abs(row["measured"] - row["theory"]) for row in of("growth") if row["measured"] is not None]
    energy = {row["system"]: row["measured"] for row in sorted(of("energy"), key=lambda row: row["at"])}
    band, cycle = of("dead_band")[0], of("limit_cycle")[0]
    return {"growth": max(growth, default=None), "energy": energy,
            "reversal": of("reversal", "orbit")[0]["measured"], "band": band["measured"],
            "bound": band["theory"], "period": cycle["measured"]}


def cycle_finding(data):
    """What swings for ever on springs that are solved implicitly, in two sentences; nothing if nothing does."""
    rows = {(row["measure"], row["scalar"]): row for row in data.rows("dynamics", integrator="implicit_springs", arithmetic="nearest")
            if row["measure"] in ("dead_band", "limit_cycle")}
    swinging = [scalar for measure, scalar in rows if measure == "limit_cycle" and (rows[measure, scalar]["theory"] or 1) > 1]
    if not swinging:
        return ""
    row = rows["limit_cycle", swinging[0]]
    unrounded = 2 * math.pi / (math.sqrt(row["at"]) * row["dt"])
    return (f"With springs solved implicitly the body swings for ever in {', '.join(map(style.format_label, swinging))}: the step divides "
            f"its velocity by so little that the quotient rounds to the same number, and nothing is damped. In "
            f"{style.format_label(swinging[0])} it swings by {figure(rows['dead_band', swinging[0]]['measured'])} m in {row['measured']:g} "
            f"steps; the period of rounded products is {row['theory']:.0f}, without rounding it would be {unrounded:.0f}. ")


def heap_finding(data, scalar="q16_16"):
    """What a heap and a struck chain bear with one iteration, with ten, and with ten that begin where the last step ended, in a
    sentence; nothing if the data have none."""
    limits = {(row["case"], row["integrator"]): row["limit"] for row in data.rows("stability", scalar=scalar, arithmetic="nearest")}
    methods = ("one_iteration", "semi_implicit_euler", "warm_started")
    if ("wedge_heavy_top", methods[-1]) not in limits:
        return ""

    def told(case):
        one, ten, warm = (figure(limits[case, method]) for method in methods)
        return f"{ten} (with one iteration {one}, warm started {warm})"
    return (f" Two balls of 1 kg in a V bear a third of {told('wedge_heavy_top')} kg; the end of a chain of 8 bodies of 1 kg withstands a "
            f"blow of 10 kg at {told('impact_on_chain_of_8')} m/s.")


def search_of_two(data, scalar, integrator):
    """The largest omega dt that holds in the search, to four digits, next to the 2 at which the growth begins in theory; None if none does."""
    found = [row["limit"] for row in data.rows("stability", case="spring_coarse_step", scalar=scalar, integrator=integrator)
             if row["arithmetic"] in DEFAULT]
    return None if found == ["none"] else f"{found[0]:.4g}"


def orders(data, integrator):
    """By system and format: the distance between runs that differ in the order of their links, measured and in double."""
    return {(row["system"], row["scalar"]): (row["measured"], row["theory"])
            for row in data.rows("dynamics", measure="order", integrator=integrator) if row["arithmetic"] in DEFAULT}


def order_finding(data):
    """What depends on the order in which links are added, in a sentence."""
    rods, springs = ({scalar: apart for (of, scalar), apart in orders(data, method).items() if of == system}
                     for system, method in (("chain of rods", "semi_implicit_euler"), ("chain of springs", "implicit_springs")))
    sums = [apart for (system, _), (apart, _) in orders(data, "semi_implicit_euler").items() if system == "chain of springs"]
    accumulated = ("Forces of springs are sums, and leave none in any format" if not any(sums) else
                   f"Forces of springs leave up to {figure(max(sums))} m")
    return (f"{figure(rods['q32_32'][1])} m in double, because the iterations end before they converge. {accumulated}; springs solved "
            f"implicitly, one after the other, leave {figure(springs['q16_16'][0])} m in Q16.16 and {figure(springs['q16_16'][1])} m in double.")


def tunnelling_finding(data):
    """How fast particles of continuous contacts may be, in a sentence; nothing if the data have none."""
    rows = [row for row in data.rows("stability", integrator="continuous_contacts") if row["case"] in ("thin_wall", "thin_target")]
    if not rows:
        return ""
    passed = [row for row in rows if row["verdict"].split()[0] not in ("stable", "overflows")]
    if passed:
        return "With continuous contacts something passes: " + "; ".join(f"{named(row)} beyond {figure(row['limit'])} m/s" for row in passed) + "."
    fastest = {}
    for row in rows:
        fastest.setdefault(row["scalar"], []).append((row["limit"], row["verdict"] == "stable"))
    told = ", ".join(f"{figure(min(limits)[0])} m/s in {style.format_label(scalar)}{' (the end of the search)' if min(limits)[1] else ''}"
                     for scalar, limits in sorted(fastest.items(), key=lambda item: min(item[1])[0]))
    return f"With continuous contacts nothing passes a fixed wall or a free target at any speed that the format holds: {told}."


def divergence_finding(data, integrator="velocity_verlet"):
    """When a chaotic motion is lost to rounding, by format, and the value of a bit, in a sentence."""
    rows = [row for row in data.rows("dynamics", integrator=integrator) if row["arithmetic"] in DEFAULT]
    times = {row["scalar"]: row for row in rows if row["measure"] == "divergence" and row["measured"] is not None}
    rates = {row["scalar"]: row for row in rows if row["measure"] == "divergence_rate"}
    told = ", ".join(f"{row['measured']:.3g} s in {style.format_label(scalar)}"
                     for scalar, row in sorted(times.items(), key=lambda item: item[1]["measured"]))
    coarse, fine = times["q16_16"]["measured"], times["q32_32"]["measured"]
    rate = rates["q32_32"]
    return (f"A chaotic double pendulum departs by {times['q16_16']['at']:g} m from the same method's run in double after {told} "
            f"(means over seeded starts). In Q32.32 the distance grows at {rate['measured']:.3g}/s; the Lyapunov exponent of the "
            f"equations of motion is {rate['theory']:.3g}/s. From Q16.16 to Q32.32 each bit buys {(fine - coarse) / 16:.3g} s; ln 2 "
            f"over that exponent is {math.log(2) / rate['theory']:.3g} s.")


def float_finding(data):
    """Where the device's float differs from the host's, in a sentence."""
    rows = data.rows("float_extremes")
    apart = [row for row in rows if row["differ"]]
    told = "; ".join(f"{row['operation'].replace('_', ' ')}, {row['operands']}: {row['differ']} of {row['pairs']} pairs, of which the first is "
                     f"{row['first_mismatch'].replace(' ', ' and ')}: IEEE 754 requires {row['host']}, the device returns {row['device']}"
                     for row in apart)
    return (f"The rows for float ran on the host. On the simulated chip avr-libc returns the same bits in "
            f"{len(rows) - len(apart)} of {len(rows)} classes of operands (including subnormals, infinities and NaNs) of "
            f"{len({row['operation'] for row in rows})} operations, {sum(row['pairs'] for row in rows)} pairs in all"
            + (f". It differs in {told}." if apart else "."))


def ablations_finding(data):
    """What the measures of the engine gain and cost, in a sentence."""
    rows = [row for row in data.rows("ablations") if number(row["before"]) > 0 and number(row["after"]) > 0]

    def gain(row):  # a limit that should be small as well as one that should be large
        ratio = number(row["after"]) / number(row["before"])
        return max(ratio, 1 / ratio)

    def cost(row):
        return 100 * (row["after_cycles"] / row["before_cycles"] - 1)

    def told(row):
        return f"{row['ablation']} in {row['case'].replace('_', ' ')}"
    best, costliest, cheapest = max(rows, key=gain), max(rows, key=cost), min(rows, key=cost)
    return (f"Over {len({row['ablation'] for row in rows})} measures in {len(rows)} cases, a measure moves the limit by a factor of up to "
            f"{figure(gain(best))} ({told(best)}); in {sum(gain(row) < 1.05 for row in rows)} cases it is less than 5 %. It changes the "
            f"step's cycles by {cost(cheapest):+.0f} % ({told(cheapest)}) to {cost(costliest):+.0f} % ({told(costliest)}).").replace(" -", " −")
