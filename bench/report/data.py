# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads the data files of the bench as lists of rows with typed cells. A defect in one is a DataError
that names file, row and column; rows are counted from 1, which is the line of names."""
import csv
import json
import math
import pathlib


class DataError(Exception):
    """A fault in the data, in one line."""


# Columns that hold text in at least one file. All others hold numbers.
TEXT = frozenset("""
ablation as_published after_cause after_method arithmetic before_cause before_error before_method best_format block bound
broad_phase case change cheapest chip clock coefficient coefficients commit curve cycles_max_witness damping
device edges elf_sha256 failure fault feature first_event first_mismatch
fitted_to flags form format formats formula
function handler hand_n_per_m holds host implementation inputs integrator interrupt kernel_sha256 kind lane
limit limited_by loop map max_ulp_witness measure measured measured_with note operands operation operations operators origin parameter pin quantity
readings reason reference rival scalar scenario scene shift standard_errors at_rest_at_shortest symbol system type
unbounded unit variant vector verdict version view where widening with x_name y_name
""".split())
# Numbers that a row may lack: a program that does not fit the chip has no cycles, an exact result no error.
OPTIONAL = frozenset("""
bits_at_limit bits_beyond chip_frequency_hz contradicting count cycles cycles_max cycles_mean cycles_min cycles_per_simulated_second
cycles_per_step_max cycles_per_step_mean error error_arithmetic error_by_extent error_max error_median error_method error_min
evaluation_error_g fall_damped_s fall_s fall_undamped_s fit_constant fit_linear fit_per_pair
fit_worst_percent fitted flash_bytes frame_bytes_bound frame_bytes_measured hardest_hand_n_per_m holds_again
late_steps leave_one_out_rms_g linear_shortest_arm_m max_error max_ulp mean_ulp pairs_tested published ram_bytes
ratio refitted rms_error rms_ulp runs runs_rejected shortest_arm_m softest_hand_n_per_m square_sum_excess stack_bytes swept
stack_bytes_bound stack_bytes_measured standard_error step swing_deg swing_undamped_deg theory value worst_frequency_hz
within_1_ulp within_8_ulp within_half_ulp worst_lateness_ms worst_released_frequency_hz
""".split())


class Row(dict):
    """A row, accessed by the names of its columns; an error names the file."""

    def __init__(self, file, cells):
        super().__init__(cells)
        self.file = file

    def __missing__(self, column):
        raise DataError(f"{self.file}: there is no column '{column}'")


def _typed(cell, column, place):
    if cell == "":
        if column in TEXT or column in OPTIONAL:
            return None
        raise DataError(f"{place}, column {column}: the number is missing")
    for convert in (int, float):
        try:
            value = convert(cell)
        except ValueError:
            continue
        if isinstance(value, float) and math.isnan(value):
            raise DataError(f"{place}, column {column}: '{cell}' is not a number")
        return value
    if column not in TEXT:
        raise DataError(f"{place}, column {column}: '{cell}' is not a number")
    return cell


def load(path):
    """All rows of a CSV file."""
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
    rows = []
    for number, row in enumerate(cells, 2):
        place = f"{path}, row {number}"
        if len(row) != len(columns):
            raise DataError(f"{place}: {len(row)} cells under {len(columns)} columns")
        rows.append(Row(path, ((column, _typed(cell, column, place))
                               for column, cell in zip(columns, row))))
    return rows


class Data:
    """The folder of data files. `experiments` is the list printed by `fixbench --list --json`: the error for a missing
    file names the command that makes it."""

    def __init__(self, folder, experiments=()):
        self.folder = pathlib.Path(folder)
        self.made_by = {file: experiment["command"] for experiment in experiments
                        for file in experiment["writes"] + experiment["full_only"]}
        self._loaded = {}

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
            self._loaded[name] = load(self._path(name, ".csv"))
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
            raise DataError(f"{path}: {error}") from None
