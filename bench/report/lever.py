# SPDX-License-Identifier: GPL-3.0-or-later
"""What the page of the lever tells of the workload: verdicts on the published figures, measured in
the engine alone and in the whole device, and the device in each arithmetic."""
import csv
import math
import pathlib

import haptic_region
from data import DataError

PUBLISHED = pathlib.Path(__file__).resolve().parents[2] / "reference/published/workload.csv"

# Columns of the comparison: arithmetic in the data, heading.
DEVICES = {
    "q16_16": "Q16.16",
    "q16_16_arduino": "Q16.16, Arduino sketch",
    "float": "float",
    "published": "as published, rebuilt",
}


def verdicts(data):
    """Each row of workload.csv and workload_firmware.csv that has a published figure, by quantity."""
    rows = [row | {"measured_in": place} for file, place in (("workload", "engine alone"),
                                                             ("workload_firmware", "whole device"))
            for row in data.rows(file) if row["published"] is not None]
    with open(PUBLISHED, newline="", encoding="utf-8") as stream:
        figures = [(row["quantity"], row["arithmetic"]) for row in csv.DictReader(stream)]
    judged = [(row["quantity"], row["arithmetic"]) for row in rows]
    missing = [" ".join(figure) for figure in figures if figure not in judged]
    if missing:
        raise DataError(f"no verdict on the published {', '.join(missing)}")
    return sorted(rows, key=lambda row: figures.index((row["quantity"], row["arithmetic"])))


def devices(data):
    """Quantity, unit and a value for each device, where all tell of it."""
    told = {}
    for row in data.rows("workload_firmware", verdict="measured"):
        told.setdefault((row["quantity"], row["unit"]), {})[row["arithmetic"]] = row["measured"]
    return [(quantity, unit, [values.get(device) for device in DEVICES])
            for (quantity, unit), values in told.items() if {"q16_16", "q16_16_arduino"} <= values.keys()]


def pins(data):
    """Quantity, unit, value on the published device and on ours, by the profiling pins."""
    rows = [row for row in data.rows("workload_firmware") if str(row["reason"]).startswith("pin D")]
    of = {(row["quantity"], row["arithmetic"]): row for row in rows}
    return [(row["quantity"], row["unit"], of[row["quantity"], "fixed_16_16"]["measured"], row["measured"])
            for row in rows if row["arithmetic"] == "q16_16"]


def finding(data):
    """What the lever does when it is poked, and the time of its fall."""
    swing = {(row["lever"], row["damping"]): row["swing"] for row in haptic_region.oscillation(data)}
    fall = {row["arithmetic"]: row["fall_s"] for row in data.rows("haptic", scenario="release_and_fall")}
    loop = {row["arithmetic"]: row["loop_rate_hz"] for row in data.rows("haptic", scenario="poke_while_held")}
    return (f"Poked while a hand holds it, the lever of the 2016 design swings by "
            f"{swing['2016 design', 'without damping']:.3g} degrees without its selective damping and by "
            f"{swing['2016 design', 'selective damping']:.3g} with it, ours by "
            f"{swing['ours, Q16.16', 'selective damping']:.2g}, at {loop['q16_16']:.0f} steps a second in "
            f"place of {loop['published']:.0f}. Let go, it falls in {fall['q16_16']:.2f} s, the rebuilt one in "
            f"{fall['published']:.2f} s; 0.18 s were published for an arm of 20 cm.")


def share(count, of):
    """A share of plants with its 95% interval (E. B. Wilson, 1927), in percent."""
    z = 1.96
    centre = (count + z * z / 2) / (of + z * z)
    half = z / (of + z * z) * math.sqrt(count * (of - count) / of + z * z / 4)
    return f"{count} of {of} ({max(0, 100 * (centre - half)):.0f} to {min(100, 100 * (centre + half)):.0f} %)"


def others(data):
    """How many scenarios the other levers hold, in a sentence."""
    parts = []
    for arithmetic, name in (("float", "the same firmware in float"), ("published", "the rebuilt 2016 design")):
        rows = data.rows("haptic", arithmetic=arithmetic)
        held = sum(row["verdict"] == "held" for row in rows)
        parts.append(f"{name} holds {held} of {len(rows)}")
    longest = {row["arithmetic"]: row["seconds"] for row in data.rows("haptic", scenario="hours")}
    return (" and ".join(parts) + f". The scenario \"hours\" simulates {longest['q16_16']:.0f} s of ours and "
            f"{longest['float']:.0f} s of the others.")
