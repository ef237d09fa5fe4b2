# SPDX-License-Identifier: GPL-3.0-or-later
"""What a feature of the engine costs the lever's scene, and what the engine does."""


def finding(data):
    """The most expensive and the cheapest features, in cycles and in flash; the lever without the engine."""
    rows = data.rows("features", scene="lever")
    without = {row["feature"]: row for row in rows if row["with"] == "no"}
    cost = {feature: (row["cycles_per_step_mean"] - without[feature]["cycles_per_step_mean"],
                      row["flash_bytes"] - without[feature]["flash_bytes"])
            for row in rows if row["with"] == "yes" and (feature := row["feature"]) in without}

    def told(feature):
        cycles, flash = cost[feature]
        return f"{feature} ({cycles:+.0f} cycles a step, {flash:+d} bytes of flash)"
    by_cycles = sorted(cost, key=cost.get)
    text = (f"Of {len(cost)} features the most expensive are {told(by_cycles[-1])} and {told(by_cycles[-2])}; "
            f"the cheapest is {told(by_cycles[0])}.")
    return f"{text} {by_hand(data)}"


def by_hand(data):
    """What the engine's generality costs the lever."""
    hand, = data.some("features", scene="lever", feature="by_hand")
    engine, = data.some("features", scene="lever", feature="arithmetic=Nearest", **{"with": "yes"})
    cycles, flash = ((engine[name], hand[name]) for name in ("cycles_per_step_mean", "flash_bytes"))
    return (f"Written by hand, with bit-identical results, the lever's step takes {cycles[1]:.0f} cycles and "
            f"{flash[1]} bytes. The engine, which also runs other scenes, takes {cycles[0] / cycles[1]:.2f} times the cycles and "
            f"{flash[0] / flash[1]:.2f} times the flash.")


def tiers(data):
    """Which of the two arithmetics is the default, and why: each scene's step, and a program with nine functions."""
    rows = {(row["scene"], row["feature"]): row for row in data.rows("features")}

    def told(scene, name):
        nearest, small = (rows[scene, f"arithmetic={arithmetic}"] for arithmetic in ("Nearest", "Small"))
        times = small["cycles_per_step_mean"] / nearest["cycles_per_step_mean"]
        return (f"{name} takes {times:.2f} times the cycles and {small['flash_bytes']} bytes instead of "
                f"{nearest['flash_bytes']}")

    nearest, small = (next(row["flash_bytes"] for row in data.rows("flash", operations="nine", format="q16_16",
                                                                 implementation=implementation))
                      for implementation in ("default", "small"))
    return (f"With `Small` instead of `Nearest`, {told('lever', 'the lever')}, {told('everything', 'a scene with all features')}; "
            f"a program with the nine functions takes {small} bytes instead of {nearest}. Sums and products are the same code in "
            "both, and so is everything made of them, such as a PID controller or a biquad filter. `Nearest` is the default, since "
            "a step runs out of cycles before these programs run out of flash, and a table is linked only if it is used. `Small` "
            "is for a program that calls many functions, or for a single function, such as the firmware's arc tangent.")
