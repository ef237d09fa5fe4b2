#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page to explore the data with: what it holds against the data files, and the page itself in
Chromium (explorer/tests/page_test.mjs). Usage: explorer_test.py DATA_FOLDER SCRATCH_FOLDER"""
import contextlib
import csv
import functools
import io
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

DATA, SCRATCH = map(pathlib.Path, sys.argv[1:3])
sys.dont_write_bytecode = True
REPORT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(REPORT))
import explorer  # noqa: E402
import report  # noqa: E402
from data import Data, DataError  # noqa: E402

PAGE = SCRATCH / "index.html"
COMMITTED = Data(DATA)


@functools.cache
def gathered():
    return json.loads(explorer.gather(COMMITTED))


def changed(name, change):
    """The data, with one table changed."""
    data = Data(DATA)
    data._loaded = COMMITTED._loaded | {name: [change(row) for row in COMMITTED.rows(name)]}
    return data


class Encoding(unittest.TestCase):
    def test_cells(self):
        cells = [(None, "null"), (1, "1"), (0.1, "0.1"), ("a\"b", '"a\\"b"'), (2 ** 53, str(2 ** 53)),
                 (2 ** 53 + 1, f'"{2 ** 53 + 1}"'), (-2 ** 63, f'"{-2 ** 63}"'),
                 (math.inf, "1e999"), (-math.inf, "-1e999")]
        self.assertEqual([explorer.literal(value) for value, _ in cells], [text for _, text in cells])
        with self.assertRaises(ValueError):
            explorer.literal(math.nan)

    def test_a_column_is_its_cells_or_its_few_values(self):
        self.assertEqual(explorer.column([1, 2, 3]), "[1,2,3]")
        coded = json.loads(explorer.column(["velocity_verlet"] * 3 + [None, "x", "velocity_verlet"]))
        self.assertEqual(coded, {"values": ["velocity_verlet", None, "x"], "index": [0, 0, 0, 1, 2, 0]})

    def test_the_page_holds_every_cell_of_its_tables(self):
        for name, table in gathered()["tables"].items():
            with open(DATA / f"{name}.csv", newline="", encoding="utf-8") as stream:
                rows = list(csv.DictReader(stream))
            self.assertEqual(list(table["columns"]), list(rows[0]), name)
            for column, cells in table["columns"].items():
                if isinstance(cells, dict):
                    cells = [cells["values"][index] for index in cells["index"]]
                for cell, row in zip(cells, rows, strict=True):
                    text = row[column]
                    same = (cell is None and text == "" or str(cell) == text
                            or isinstance(cell, (int, float)) and float(text) == cell)
                    self.assertTrue(same, f"{name}.csv, {column}: {text} became {cell}")


class Facts(unittest.TestCase):
    def test_formats_are_those_of_the_published_table(self):
        formats = gathered()["formats"]
        for row in COMMITTED.rows("table_3_1"):
            facts = formats[row["format"]]
            self.assertAlmostEqual(facts["maximum"] / row["maximum"], 1, places=15)
            if row["format"] != "float":
                self.assertLess(abs(facts["resolution"] / row["resolution"] - 1), 1e-5)
        # TR 18037: 16 integer bits of _Accum beside the sign; C: INT32_MAX.
        self.assertEqual((formats["s16_15"]["maximum"], formats["int32"]["maximum"]),
                         (65536 - 2.0 ** -15, 2 ** 31 - 1))

    def test_the_largest_result_is_that_of_the_worst_operands(self):
        least, greatest = explorer.physics_operands()
        self.assertEqual((least, greatest, explorer.physics_operands("exp")), (0.01, 20, (0.01, 10)))
        ends = [sign * end for sign in (1, -1) for end in (least, 1, greatest)]
        binary = {"add": lambda a, b: a + b, "subtract": lambda a, b: a - b,
                  "multiply": lambda a, b: a * b, "divide": lambda a, b: a / b,
                  "atan2": math.atan2, "length2": math.hypot,
                  "dot2": lambda a, b: a * b + a * b, "dot3": lambda a, b: a * b + a * b + a * b,
                  "multiply_add": lambda a, b: a * b + a, "length3": lambda a, b: math.hypot(a, a, b)}
        for operation, function in binary.items():
            found = max(abs(function(a, b)) for a in ends for b in ends)
            self.assertLessEqual(found, explorer.LARGEST[operation](least, greatest) * (1 + 1e-15))
            self.assertGreater(found, 0.7 * explorer.LARGEST[operation](least, greatest), operation)
        unary = {"sqrt": math.sqrt, "exp": math.exp, "log": math.log,
                 "reciprocal_sqrt": lambda a: 1 / math.sqrt(a)}
        for operation, function in unary.items():
            self.assertEqual(max(abs(function(a)) for a in (least, 1, greatest)),
                             explorer.LARGEST[operation](least, greatest), operation)

    def test_exp_is_compared_where_no_format_saturates(self):
        compared = gathered()["compared"]
        # e^10 is 22026.
        self.assertEqual([name for name in compared["exp"] if name[0] in "qf"],
                         ["q16_16", "q32_32", "float", "q24_8", "float64"])
        self.assertIn("q16_16", compared["multiply"])
        self.assertNotIn("q8_24", compared["multiply"])
        # Plain integers round their operands.
        self.assertFalse([name for formats in compared.values() for name in formats if name.startswith("int")])


class Damage(unittest.TestCase):
    def refused(self, data, message):
        with self.assertRaisesRegex(DataError, message) as raised:
            explorer.gather(data)
        self.assertNotIn("\n", str(raised.exception))

    def test_what_the_page_does_not_know_fails_the_report(self):
        for name, column, value, message in (
                ("operations", "format", "q1_1", r"operations.csv, column format: .* know q1_1"),
                ("operations", "implementation", "mine", "column implementation: .* know mine"),
                ("stability", "verdict", "explodes (at once)", "column verdict: .* know explodes"),
                ("stability_map", "scalar", "q1_1", "stability_map.csv, column scalar: .* know q1_1")):
            self.refused(changed(name, lambda row: row | {column: value}), message)

    def test_an_operation_of_unknown_range_is_not_compared(self):
        formats = {name: explorer.number_format(name, COMMITTED) for name in explorer.style.FORMATS}
        self.assertEqual(explorer.compared(formats, ["cube"]), {"cube": []})

    def test_a_missing_file_fails_the_report(self):
        data = changed("operations", lambda row: row)
        path = data._path
        data._loaded.pop("error_histograms", None)
        data._path = lambda name, suffix: path("gone" if name == "error_histograms" else name, suffix)
        self.refused(data, "gone.csv is missing")


class NoRegistry(unittest.TestCase):
    def test_without_the_packages_the_page_stays_and_a_line_says_so(self):
        errors = io.StringIO()
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stderr(errors), \
                unittest.mock.patch("explorer.install", side_effect=explorer.NoRegistry("no way")):
            page = pathlib.Path(folder) / "index.html"
            page.write_text("as it was", encoding="utf-8")
            explorer.write(page, report.templates(), COMMITTED, report.write_whole)
            self.assertEqual(page.read_text(encoding="utf-8"), "as it was")
        self.assertEqual(errors.getvalue(), "report: index.html is not written: no way\n")


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(SCRATCH, ignore_errors=True)
        SCRATCH.mkdir(parents=True)
        # Twice: equal data give equal bytes.
        cls.pages = [explorer.page(report.templates(), COMMITTED) for _ in range(2)]
        report.write_whole(PAGE, cls.pages[0])
        (SCRATCH / "data").symlink_to(DATA.resolve())

    def test_equal_data_give_equal_bytes(self):
        self.assertEqual(*self.pages)

    def test_it_is_one_file_of_at_most_3_mb(self):
        self.assertLess(PAGE.stat().st_size, 3_000_000)
        shell = re.sub(r"<script.*?</script>|<pre>.*?</pre>", "", self.pages[0], flags=re.DOTALL)
        self.assertNotRegex(shell, r"https?:|<link|src=|@import|url\(")

    def test_it_names_the_licence_of_each_package(self):
        for name in ("@observablehq/plot", "d3-scale", "interval-tree-1d", "isoformat"):
            self.assertRegex(self.pages[0], re.escape(name) + r" \d[\d.]* \([\w.-]+\)")
        self.assertNotIn("esbuild 0", self.pages[0])
        self.assertIn("Permission to use, copy, modify", self.pages[0])

    def test_in_chromium(self):
        done = subprocess.run(["node", "--test", "--test-reporter=spec",
                               REPORT / "explorer" / "tests" / "page_test.mjs"],
                              env={**os.environ, "PAGE": str(PAGE.resolve()),
                                   "DATA": str(DATA.resolve())},
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    try:
        explorer.install()
    except explorer.NoRegistry as reason:
        print(f"SKIPPED: {reason}")
        sys.exit(0)
    unittest.main(argv=sys.argv[:1])
