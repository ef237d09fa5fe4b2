# SPDX-License-Identifier: GPL-3.0-or-later
"""What a feature of the engine costs the lever's scene, and what the engine does."""


def finding(data):
    """The dearest and the cheapest features, in cycles and in flash; the lever without the engine."""
    rows = data.rows("features", scene="lever")
    without = {row["feature"]: row for row in rows if row["with"] == "no"}
    cost = {feature: (row["cycles_per_step_mean"] - without[feature]["cycles_per_step_mean"],
                      row["flash_bytes"] - without[feature]["flash_bytes"])
            for row in rows if row["with"] == "yes" and (feature := row["feature"]) in without}

    def told(feature):
        cycles, flash = cost[feature]
        return f"{feature} {cycles:+.0f} cycles a step and {flash:+d} bytes of flash"
    by_cycles = sorted(cost, key=cost.get)
    text = (f"Of {len(cost)} features the dearest are {told(by_cycles[-1])}, and {told(by_cycles[-2])}; "
            f"the cheapest is {told(by_cycles[0])}.")
    return f"{text} {by_hand(rows)}".rstrip()


def by_hand(rows):
    """What it costs that the engine takes other scenes than the lever's, too."""
    hand = next((row for row in rows if row["feature"] == "by_hand"), None)
    if hand is None:
        return ""
    engine, = (row for row in rows if (row["feature"], row["with"]) == ("arithmetic=Nearest", "yes"))
    cycles, flash = ((engine[name], hand[name]) for name in ("cycles_per_step_mean", "flash_bytes"))
    return (f"Written by hand, with the same result to the bit, the lever's step takes {cycles[1]:.0f} cycles and "
            f"{flash[1]} bytes: the engine, which takes other scenes, too, takes {cycles[0] / cycles[1]:.2f} and "
            f"{flash[0] / flash[1]:.2f} times that.")
