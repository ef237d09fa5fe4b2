# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads the data files of the bench as lists of rows with typed cells. What a column holds is said in columns.json, which
follows from the records of the programs (bench/lab/records/record.hpp). A defect in a file is a DataError that names
file, row and column; rows are counted from 1, which is the line of names."""
import csv
import functools
import json
import math
import pathlib
import re


class DataError(Exception):
    """A fault in the data, in one line."""


# Python also converts digits with spaces around them or underscores in between.
NUMBER = re.compile(r"[^\s_]+")


class Row(dict):
    """A row, accessed by the names of its columns; an error names the file."""

    def __init__(self, file, cells):
        super().__init__(cells)
        self.file = file

    def __missing__(self, column):
        raise DataError(f"{self.file}: there is no column '{column}'")


def typed(cell, holds, place):
    """A cell of a column that holds "text", of which some may be numbers, a "number", or an "optional" one."""
    if cell == "":
        if holds == "number":
            raise DataError(f"{place}: the number is missing")
        return None
    for convert in (int, float) if NUMBER.fullmatch(cell) else ():
        try:
            value = convert(cell)
        except ValueError:
            continue
        if isinstance(value, float) and math.isnan(value):
            raise DataError(f"{place}: '{cell}' is not a number")
        return value
    if holds != "text":
        raise DataError(f"{place}: '{cell}' is not a number")
    return cell


HELD = ("text", "number", "optional")


def nearest(columns, headers):
    """Of several headers the one that shares most columns with a list of them, or None if none shares any."""
    best = max(headers, key=lambda header: len(set(header) & set(columns)), default=())
    return best if set(best) & set(columns) else None


def listed(columns):
    return ("column" if len(columns) == 1 else "columns") + " " + ", ".join(f"'{column}'" for column in columns)


def disagreement(file, columns, headers):
    """How the columns of a file differ from those of the record in columns.json that is most like them."""
    header = nearest(columns, headers)
    if header is None:
        return f"columns.json has no record with {listed(columns)}"
    header = list(header)
    lacks = [(other, [column for column in there if column not in here])
             for other, here, there in (("columns.json", header, columns), (file, columns, header))]
    told = [f"{other} lacks {listed(missing)}" for other, missing in lacks if missing]
    if not told:  # the same ones, but not one after the other
        number = next((i for i, (a, b) in enumerate(zip(columns, header)) if a != b), min(len(columns), len(header)))
        a, b = (f"'{names[number]}'" if number < len(names) else "none" for names in (columns, header))
        told = [f"column {number + 1} is {a} in {file} and {b} in columns.json"]
    return ", ".join(told)


def load(path, headers, maker=None):
    """All rows of a CSV file, whose columns are those of one of the headers. `maker` is the command that makes it."""
    try:
        with open(path, newline="", encoding="utf-8") as stream:
            lines = list(csv.reader(stream, strict=True))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise DataError(f"{path}: {error}") from None
    if not lines:
        raise DataError(f"{path}: is empty")
    columns, *cells = lines
    if not cells:
        raise DataError(f"{path}: has no rows below the names of its columns")
    header = next((each for each in headers if list(each) == columns), None)
    if header is None:
        name = pathlib.Path(path).name
        raise DataError(f"{path} and columns.json disagree: {disagreement(name, columns, headers)}; "
                        + (f"`{maker}` writes {name}, " if maker else "") + "`fixbench report` writes columns.json")
    rows = []
    for number, row in enumerate(cells, 2):
        place = f"{path}, row {number}"
        if len(row) != len(columns):
            raise DataError(f"{place}: {len(row)} cells under {len(columns)} columns")
        rows.append(Row(path, ((column, typed(cell, holds, f"{place}, column {column}"))
                               for (column, holds), cell in zip(header.items(), row))))
    return rows


class Data:
    """The folder of data files. `experiments` is the list printed by `fixbench --list --json`: the error for a missing
    file names the command that makes it."""

    def __init__(self, folder, experiments=()):
        self.folder = pathlib.Path(folder)
        self.made_by = {file: experiment["command"] for experiment in experiments
                        for file in experiment["writes"] + experiment["full_only"]}
        self.made_by["columns.json"] = "fixbench report"
        self._loaded = {}

    @functools.cached_property
    def headers(self):
        """Of each kind of data file what its columns hold, in their order."""
        headers = self.json("columns")
        fault = None
        if not isinstance(headers, list) or not all(isinstance(header, dict) for header in headers):
            fault = "is not a list of records, each of which has for every column what it holds"
        else:
            for header in headers:
                for column, holds in header.items():
                    if holds not in HELD:
                        fault = f"column '{column}' holds '{holds}', and allowed are {', '.join(HELD)}"
        if fault:
            raise DataError(f"{self.folder / 'columns.json'}: {fault}; `{self.made_by['columns.json']}` writes it")
        return headers

    def _path(self, name, suffix):
        path = self.folder / (name + suffix)
        if not path.exists():
            maker = self.made_by.get(path.name)
            raise DataError(f"{path} is missing"
                            + (f"; `{maker}` writes it" if maker else ""))
        return path

    def has(self, name):
        return (self.folder / (name + ".csv")).exists()

    def rows(self, name, **wanted):
        """The rows of <name>.csv whose cells equal `wanted`, as dictionaries."""
        if name not in self._loaded:
            self._loaded[name] = load(self._path(name, ".csv"), self.headers, self.made_by.get(name + ".csv"))
        return [row for row in self._loaded[name]
                if all(row[key] == value for key, value in wanted.items())]

    def some(self, name, **wanted):
        """Those rows, which must exist: where a look-up finds nothing, a finding would be missing without a word."""
        found = self.rows(name, **wanted)
        if not found:
            what = ", ".join(f"{key} = {value}" for key, value in wanted.items())
            raise DataError(f"{name}.csv: there is no row with {what}")
        return found

    def json(self, name):
        path = self._path(name, ".json")
        try:
            with open(path, encoding="utf-8") as stream:
                return json.load(stream)
        except (OSError, ValueError) as error:
            maker = self.made_by.get(path.name)
            raise DataError(f"{path}: {error}" + (f"; `{maker}` writes it" if maker else "")) from None
