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
    """The folder of data files. `experiments` is the list that `fixbench --list --json` prints: a
    missing file is an error that names the command which makes it."""

    def __init__(self, folder, experiments=()):
        self.folder = pathlib.Path(folder)
        self.made_by = {file: experiment["command"] for experiment in experiments
                        for file in experiment["writes"] + experiment["full_only"]}

    def _path(self, name, suffix):
        path = self.folder / (name + suffix)
        if not path.exists():
            maker = self.made_by.get(path.name)
            raise SystemExit(f"report: {path} is missing"
                             + (f"; `{maker}` writes it" if maker else ""))
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
