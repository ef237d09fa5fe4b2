# SPDX-License-Identifier: GPL-3.0-or-later
"""What the page of the lever tells of the workload: verdicts on the published figures, measured in
the engine alone and in the whole device, and the device in each arithmetic."""
import csv
import pathlib

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
