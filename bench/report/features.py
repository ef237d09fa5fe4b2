# SPDX-License-Identifier: GPL-3.0-or-later
"""What a feature of the engine costs the lever's scene."""


def finding(data):
    """The dearest and the cheapest features, in cycles and in flash."""
    rows = data.rows("features", scene="lever")
    without = {row["feature"]: row for row in rows if row["with"] == "no"}
    cost = {feature: (row["cycles_per_step_mean"] - without[feature]["cycles_per_step_mean"],
                      row["flash_bytes"] - without[feature]["flash_bytes"])
            for row in rows if row["with"] == "yes" and (feature := row["feature"]) in without}

    def told(feature):
        cycles, flash = cost[feature]
        return f"{feature} {cycles:+.0f} cycles a step and {flash:+d} bytes of flash"
    by_cycles = sorted(cost, key=cost.get)
    return (f"Of {len(cost)} features the dearest are {told(by_cycles[-1])}, and {told(by_cycles[-2])}; "
            f"the cheapest is {told(by_cycles[0])}.")
