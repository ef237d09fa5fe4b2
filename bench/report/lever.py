# SPDX-License-Identifier: GPL-3.0-or-later
"""What the lever's page says about the workload: verdicts on the published figures, measured in the
engine alone and in the whole device, and the device in each arithmetic."""
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
# Rows of the comparison; the cost of rendering is in the data.
QUANTITIES = ("loop_rate", "loop_step", "loop_step_max", "worst_lateness", "cpu_share", "flash_bytes",
              "static_ram_bytes", "stack_measured", "stack_bound")

# m: the arm whose fall was published.
PUBLISHED_ARM = 0.2


def published(quantity):
    """A published figure of the running device."""
    with open(PUBLISHED, newline="", encoding="utf-8") as stream:
        return next(float(row["value"]) for row in csv.DictReader(stream) if row["quantity"] == quantity)


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
    """Quantity, unit and a value for each device, for the page's comparison."""
    told = {}
    for row in data.rows("workload_firmware", verdict="measured"):
        told.setdefault((row["quantity"], row["unit"]), {})[row["arithmetic"]] = row["measured"]
    return [(quantity, unit, [values.get(device) for device in DEVICES])
            for (quantity, unit), values in told.items() if quantity in QUANTITIES]


def finding(data):
    """The reaction of the lever to a poke, and the time of its fall."""
    swing = {(row["lever"], row["damping"]): row["swing"] for row in haptic_region.oscillation(data)}
    fall = {row["arithmetic"]: row["fall_s"] for row in data.rows("haptic", scenario="release_and_fall")}
    loop = {row["arithmetic"]: row["loop_rate_hz"] for row in data.rows("haptic", scenario="poke_while_held")}
    return (f"Poked while a hand holds it, the lever of the 2016 design swings by "
            f"{swing['2016 design', 'without damping']:.3g} degrees without its selective damping and by "
            f"{swing['2016 design', 'selective damping']:.3g} with it. Ours swings by "
            f"{swing['ours, Q16.16', 'selective damping']:.2g} degrees, at {loop['q16_16']:.0f} steps a second instead of "
            f"{loop['published']:.0f}. When let go, ours falls in {fall['q16_16']:.2f} s and the rebuilt design in "
            f"{fall['published']:.2f} s; {published('fall_time'):g} s were published for an arm of 20 cm.")


def share(count, of, plural=""):
    """A share of plants with its 95% interval (E. B. Wilson, 1927), in percent."""
    z = 1.96
    centre = (count + z * z / 2) / (of + z * z)
    half = z / (of + z * z) * math.sqrt(count * (of - count) / of + z * z / 4)
    return f"{count} of {of}{plural} ({max(0, 100 * (centre - half)):.0f} to {min(100, 100 * (centre + half)):.0f} %)"


def others(data):
    """How many scenarios the other levers pass, in a sentence."""
    parts = []
    for arithmetic, name in (("float", "The same firmware in float passes"), ("published", "the rebuilt 2016 design")):
        rows = data.rows("haptic", arithmetic=arithmetic)
        held = sum(row["verdict"] == "held" for row in rows)
        parts.append(f"{name} {held} of {len(rows)}")
    longest = {row["arithmetic"]: row["seconds"] for row in data.rows("haptic", scenario="hours")}
    return (f"{' and '.join(parts)}. The scenario \"hours\" simulates {longest['q16_16']:.0f} s of ours and "
            f"{longest['float']:.0f} s of the others.")


def scenarios_finding(data):
    """What our lever keeps over all scenarios, in a sentence or two, and where it fails."""
    rows = data.rows("haptic", arithmetic="q16_16")
    broken = [f"{row['scenario'].replace('_', ' ')} ({row['reason']})" for row in rows if row["verdict"] != "held"]
    late = max(rows, key=lambda row: row["worst_lateness_ms"])
    return (f"As flashed, in Q16.16, the lever passes {len(rows) - len(broken)} of {len(rows)} scenarios"
            + (f", not {', '.join(broken)}" if broken else "")
            + f", at {min(row['loop_rate_hz'] for row in rows):.0f} steps a second or more. A step takes at most "
            f"{max(row['step_max_ms'] for row in rows):.2f} ms and begins at most {late['worst_lateness_ms']:.2f} ms late "
            f"(scenario \"{late['scenario'].replace('_', ' ')}\"). The processor is busy for at most "
            f"{max(row['cpu_percent'] for row in rows):.0f} % of its time, and the stack is at most "
            f"{max(row['stack_bytes'] for row in rows)} bytes deep.")


def profile_finding(data):
    """Where the cycles go: sleep, the lever's own code, and the kernels that follow."""
    rows = data.rows("profile_lever")
    asleep = next(row for row in rows if row["function"] == "(asleep)")
    busiest = [row for row in rows if row is not asleep][:4]
    return (f"The processor sleeps for {100 * asleep['self_share']:.0f} % of them. Most of the rest goes to "
            + ", ".join(f"`{row['function']}` ({100 * row['self_share']:.1f} %)" for row in busiest)
            + ": [the whole profile](data/profile_lever.csv).")


def calibration_finding(data):
    """The curve that was chosen, and the published one."""
    rows = data.rows("calibration_candidates")
    chosen = next(row for row in rows if row["verdict"] == "chosen")
    published = next(row for row in rows if row["fitted_to"] == "as published")
    return (f"The curve chosen is {chosen['formula']}: {chosen['rms_g']:.3g} g rms over the readings ({chosen['leave_one_out_rms_g']:.3g} g "
            f"with each reading left out of its own fit), {chosen['cycles_mean']:.0f} cycles and "
            f"{chosen['flash_bytes']} bytes. The published {published['formula']}, with its coefficients, has "
            f"{published['rms_g']:.3g} g, {published['cycles_mean']:.0f} cycles and {published['flash_bytes']} bytes.")
