# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads the data files of the bench as lists of rows with typed cells."""
import csv
import json
import pathlib


def _typed(cell):
    if cell == "":
        return None
    for convert in (int, float):
        try:
            return convert(cell)
        except ValueError:
            pass
    return cell


class Data:
    """The folder of data files. A missing file is an error that names the command that makes it."""

    MADE_BY = {
        "operations": "fixbench cycles",
        "accuracy": "fixbench accuracy",
        "error_histograms": "fixbench accuracy",
        "error_along_input": "fixbench accuracy",
        "table_3_2": "fixbench table",
        "table_3_2_hypotheses": "fixbench table",
        "division_cycles": "fixbench table",
        "table_3_1": "fixbench table",
        "kernels": "fixbench verify",
        "exhaustive": "fixbench exhaustive",
        "host_throughput": "host_throughput",
        "features": "fixbench features",
        "growth": "fixbench growth",
        "growth_host": "fixbench growth --host",
        "stability": "fixbench stability",
        "stability_map": "fixbench stability",
        "envelope": "fixbench stability",
        "ablations": "fixbench stability",
        "calibration": "fixbench calibrate",
        "calibration_candidates": "fixbench calibrate",
        "calibration_verdicts": "fixbench calibrate",
        "suitability": "fixbench stability",
        "haptic": "fixbench haptic",
        "haptic_pins": "fixbench haptic",
        "workload_firmware": "fixbench haptic",
        "stable_region": "fixbench region",
        "stable_limits": "fixbench region",
        "stable_changes": "fixbench region",
        "stable_on_chip": "fixbench region",
        "oscillation": "fixbench region",
        "profile_lever": "fixbench profile lever.elf --scenario poke_while_held",
        "interrupts_lever": "fixbench profile lever.elf --scenario poke_while_held",
        "stack_lever": "fixbench profile lever.elf --scenario poke_while_held",
        "replay": "fixbench lever",
        "scenes": "fixbench scenes",
        "workload": "fixbench workload",
        "workload_rounds": "fixbench workload",
        "workload_trace": "fixbench workload",
    }

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)

    def _path(self, name, suffix):
        path = self.folder / (name + suffix)
        if not path.exists():
            raise SystemExit(f"report: {path} is missing; {self.MADE_BY[name]} writes it")
        return path

    def has(self, name):
        return (self.folder / (name + ".csv")).exists()

    def rows(self, name, **wanted):
        """The rows of <name>.csv whose cells equal `wanted`, as dictionaries."""
        with open(self._path(name, ".csv"), newline="", encoding="utf-8") as stream:
            rows = [{key: _typed(cell) for key, cell in row.items()}
                    for row in csv.DictReader(stream)]
        return [row for row in rows if all(row[key] == value for key, value in wanted.items())]

    def json(self, name):
        with open(self._path(name, ".json"), encoding="utf-8") as stream:
            return json.load(stream)
