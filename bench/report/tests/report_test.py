#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The report on small made-up data whose results are known by hand: the values behind each figure,
each computation of the pages, and what is told of damaged data."""

import contextlib
import csv
import io
import json
import math
import pathlib
import re
import sys
import tempfile
import unittest
import unittest.mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import blocks  # noqa: E402
import bounds  # noqa: E402
import choose_a_format  # noqa: E402
import data as data_module  # noqa: E402
import division_cycles  # noqa: E402
import error_against_cycles  # noqa: E402
import error_histograms  # noqa: E402
import features  # noqa: E402
import growth  # noqa: E402
import haptic_region  # noqa: E402
import haptic_timing  # noqa: E402
import headline  # noqa: E402
import identification  # noqa: E402
import lever  # noqa: E402
import operations  # noqa: E402
import replay  # noqa: E402
import report  # noqa: E402
import rivals  # noqa: E402
import scenes  # noqa: E402
import scenes_workload  # noqa: E402
import stability  # noqa: E402
import style  # noqa: E402
import table_3_2  # noqa: E402
import matplotlib.pyplot as plt  # noqa: E402
from data import Data, DataError  # noqa: E402

from matplotlib.colors import to_hex  # noqa: E402


def golden(**files):
    """Data of rows that stand here: of each file the names of its columns, then a row a line."""
    made = Data("nowhere")
    for name, text in files.items():
        columns, *lines = [line.split() for line in text.strip().splitlines()]
        made._loaded[name] = [
            data_module.Row(name, {column: data_module.typed("" if cell == "-" else cell, "text", name)
                                   for column, cell in zip(columns, line)}) for line in lines]
        if any(len(line) != len(columns) for line in lines):
            raise ValueError(f"{name}: a row of another length than its columns")
    made.has = lambda name: name in files
    return made


def points(axes):
    """The points of each scatter of the axes, with its colour."""
    return [(tuple(map(float, collection.get_offsets()[0])), to_hex(collection.get_facecolor()[0]))
            for collection in axes.collections if len(collection.get_offsets())]


def curves(axes):
    return [(list(map(float, line.get_xdata())), list(map(float, line.get_ydata())))
            for line in axes.lines]


def spans(collection):
    """Begin and length of the bars of a broken_barh."""
    return [(round(path.vertices[:, 0].min(), 6), round(path.vertices[:, 0].max()
                                                        - path.vertices[:, 0].min(), 6))
            for path in collection.get_paths()]


def texts(axes):
    return [text.get_text() for text in axes.texts]


class Figures(unittest.TestCase):
    """A test of figures, each of which must show all that was put into it."""

    def tearDown(self):
        figures = [plt.figure(number) for number in plt.get_fignums()]
        plt.close("all")
        for axes in (axes for figure in figures for axes in figure.axes):
            self.check_that_all_is_shown(axes)
            if not any(panel.images for panel in axes.figure.axes):  # their ticks are indices
                self.check_ticks(axes)

    def check_that_all_is_shown(self, axes):
        shown = axes.viewLim
        for line in axes.lines:
            if line.get_transform() != axes.transData:  # one across the axes
                continue
            for x, y in zip(line.get_xdata(), line.get_ydata()):
                self.assertTrue(x != x or y != y or shown.x0 <= x <= shown.x1 and shown.y0 <= y <= shown.y1,
                                f"({x}, {y}) lies outside of {axes.get_title()}: {shown}")
        for bars in axes.collections:
            for path in bars.get_paths() if type(bars).__name__ == "PolyCollection" else []:
                low, high = path.vertices[:, 1].min(), path.vertices[:, 1].max()
                self.assertTrue(shown.y0 <= low and high <= shown.y1, axes.get_title())

    def check_ticks(self, axes):
        """A tick whose text is a number stands at that number; one of a lane within its bars."""
        for axis in (axes.xaxis, axes.yaxis):
            if type(axis.get_major_locator()).__name__ != "FixedLocator":
                continue
            places = list(axis.get_majorticklocs())
            self.assertEqual(len(set(places)), len(places), axes.get_title())
            for place, label in zip(places, axis.get_ticklabels()):
                if label.get_text().replace(".", "", 1).isdigit():
                    self.assertEqual(float(label.get_text()), place, axes.get_title())
        lanes = [path for bars in axes.collections if type(bars).__name__ == "PolyCollection"
                 for path in bars.get_paths() if len(path.vertices) == 5]
        for lane in lanes:
            low, high = lane.vertices[:, 1].min(), lane.vertices[:, 1].max()
            self.assertTrue(any(low < tick < high for tick in axes.get_yticks()), axes.get_title())


OPERATIONS = """
operation format implementation operands samples regular cycles_mean cycles_max cycles_max_witness max_ulp max_ulp_witness rms_error flash_bytes kernel_sha256
add q16_16 default physics 9 9 10 12 1 0.5 1 0.001 10 aa
add q16_16 published physics 9 9 40 12 1 1 2 0.001 20 bb
add float libc physics 9 9 100 112 1 0.5 1 0.0001 30 cc
add q16_16 default full 9 9 77 99 3 0.25 4 0.7 10 aa
add q8_8 default physics 9 9 5 12 1 0.5 1 0.02 40 dd
add q16_16 small physics 9 9 70 90 1 - - - 5 ee
sqrt q16_16 default physics 9 9 300 999 1 0.5 1 0 50 ff
sqrt float libc physics 9 9 600 999 1 0.5 1 0.01 20 gg
exp float libc physics 9 9 500 999 1 0.5 1 0.01 - hh
"""


class Operations(Figures):
    def test_headline_shows_cycles_and_flash_of_physics_operands(self):
        cycles, flash = headline.draw(golden(operations=OPERATIONS)).axes
        self.assertEqual([label.get_text() for label in cycles.get_yticklabels()], ["sqrt", "add"])
        drawn = {collection.get_label(): collection.get_offsets().tolist()
                 for collection in cycles.collections}
        self.assertEqual(drawn, {"Q16.16, 2016 design": [[40, 1]],
                                 "avr-libc float": [[600, 0], [100, 1]], "Q8.8": [[5, 1]],
                                 "Q16.16, small tables": [[70, 1]], "Q16.16": [[300, 0], [10, 1]]})
        self.assertEqual(flash.collections[1].get_offsets().tolist(), [[20, 0], [30, 1]])
        self.assertEqual(headline.finding(golden(operations=OPERATIONS)),
                         "Q16.16 takes fewer cycles than float in 2 of 2 operations (0.224 times as many in "
                         "the geometric mean) and more flash in 1.")

    @unittest.mock.patch.dict(bounds.PROOFS, clear=True)
    def test_the_bound_is_that_of_any_run_of_the_same_code(self):
        def known(data, *kind):
            return list(bounds.known(data, "add", "q16_16", *kind).values())[3:]

        header = "operation format implementation operands cycles_max cycles_max_witness max_ulp max_ulp_witness kernel_sha256\n"
        accuracy = ("operation format implementation operands max_ulp max_ulp_witness\n"
                    "add q16_16 default search 0.75 9\n")
        sampled = golden(operations=OPERATIONS, accuracy=accuracy)
        of_samples = [99, 3, "lower bound", "operations.csv, full", 0.75, 9, "lower bound", "accuracy.csv, search", None]
        self.assertEqual(known(sampled), of_samples)
        with unittest.mock.patch.dict(bounds.PROOFS, {("add", "q16_16", "default"): "a proof"}):
            with self.assertRaisesRegex(DataError, "0.75 in max_ulp, but a proof proves at most half"):
                known(sampled)
            self.assertEqual(known(golden(operations=OPERATIONS, accuracy=accuracy.replace("0.75", "0.5"))),
                             of_samples[:4] + [0.5, 1, "proven", "operations.csv, physics", "a proof"])
        with unittest.mock.patch.dict(bounds.LIMITS, {("add", "q16_16", "default"): (0.8, "a proof")}):
            self.assertEqual(known(sampled), of_samples[:6] + ["proven below 0.8", "accuracy.csv, search", "a proof"])
        with unittest.mock.patch.dict(bounds.LIMITS, {("add", "q16_16", "default"): (0.7, "a proof")}):
            with self.assertRaisesRegex(DataError, "0.75 in max_ulp, but a proof proves less than 0.7"):
                known(sampled)
        self.assertEqual(known(sampled, "small"), [90, 1, "lower bound", "operations.csv, physics", *[None] * 5])
        self.assertIsNone(bounds.known(sampled, "exp", "q16_16"))
        whole = header + "add q16_16 default all 120 7 0.875 8 aa\n"
        made = golden(operations=OPERATIONS, accuracy=accuracy, exhaustive=whole)
        self.assertEqual(known(made), [120, 7, "exact", "exhaustive.csv, all", 0.875, 8, "exact", "exhaustive.csv, all", None])
        for damaged, message in ((whole.replace("8 aa", "8 ab"), "different machine code"),
                                 (whole.replace("120 7", "98 7"), "add_q16_16_default: 99 in cycles_max, but"),
                                 (whole.replace("0.875", "0.625"), "0.75 in max_ulp, but")):
            made = golden(operations=OPERATIONS, accuracy=accuracy, exhaustive=damaged)
            with self.assertRaisesRegex(DataError, message):
                bounds.known(made, "add", "q16_16")

    @unittest.mock.patch.dict(bounds.CALLS, {("sincos", "q16_16", "default"): (("sin", "cos"), "a proof")}, clear=True)
    def test_what_is_shown_to_call_others_errs_as_they_do(self):
        columns = "operation format implementation operands cycles_max cycles_max_witness max_ulp max_ulp_witness kernel_sha256\n"
        sampled = columns + "".join(f"{name} q16_16 default full 9 1 0.5 1 {name}\n" for name in ("sin", "cos", "sincos"))
        whole = columns + "sin q16_16 default all 9 1 0.625 2 sin\ncos q16_16 default all 9 1 0.75 3 cos\n"

        def known(operations, exhaustive):
            return list(bounds.known(golden(operations=operations, exhaustive=exhaustive), "sincos", "q16_16").values())[7:]
        self.assertEqual(known(sampled, whole), [0.75, 3, "exact", "exhaustive.csv, all", "a proof"])
        only_sine = whole[:whole.index("cos q16_16")]
        self.assertEqual(known(sampled, only_sine), [0.5, 1, "lower bound", "operations.csv, full", None])
        with self.assertRaisesRegex(DataError, "0.875 in max_ulp, but sin and cos err by at most 0.75"):
            known(sampled.replace("0.5 1 sincos", "0.875 1 sincos"), whole)

    def test_portable_code_errs_as_the_default_does(self):
        made = golden(operations=OPERATIONS.replace("default full", "portable full"),
                      accuracy="operation format implementation operands max_ulp max_ulp_witness\nadd q16_16 default search 0.75 9\n")
        self.assertEqual(bounds.known(made, "add", "q16_16", "portable")["max_ulp"], 0.75)

    def test_a_proof_is_a_test(self):
        rooms = "fixedpoint", "bench/experiments/exhaustive"
        tests = "".join((pathlib.Path(report.HERE).parents[1] / room / "CMakeLists.txt").read_text() for room in rooms)
        for proof in (*bounds.PROOFS.values(), *(proof for _, proof in (*bounds.LIMITS.values(), *bounds.CALLS.values()))):
            self.assertIn(f"test_command({proof}", tests)

    def test_against_float(self):
        made = golden(operations=OPERATIONS)
        self.assertEqual(operations.ratios_to_float(made, "q16_16"), {"add": 0.1, "sqrt": 0.5})
        self.assertAlmostEqual(operations.geometric_mean([1, 4, 2]), 2)
        slow = OPERATIONS.replace("300 999", "1500 999")
        self.assertEqual(operations.slower_than_float(golden(operations=slow), "q16_16"), [("sqrt", 2.5)])
        self.assertEqual(operations.losses(golden(operations=slow), "q16_16", "default"),
                         "sqrt 2.5 times float's cycles")
        self.assertEqual(operations.losses(made, "q16_16", "default"),
                         "none of 2 takes more cycles than float")

    def test_the_cheapest_format_for_a_range_and_a_step(self):
        made = golden(table_3_1="""
format bits maximum resolution
q8_8 16 127.99 0.004
q16_16 32 32768 0.000015
q8_24 32 127.99 0.00000006
float 32 3e38 1e-45
""", operations="""
operation format implementation operands cycles_mean
multiply q8_8 default physics 25
multiply q16_16 default physics 79
multiply q8_24 default physics 108
""")
        for largest, step, cheapest in ((20, 0.004, "q8_8"), (20, 0.0039, "q16_16"), (128, 1, "q16_16"),
                                        (127.99, 1e-6, "q8_24")):
            self.assertEqual(operations.cheapest_format(made, largest, step)["format"], cheapest)

    def test_the_table_of_formats(self):
        made = golden(operations=OPERATIONS, table_3_1="""
format maximum resolution
q8_8 127.99 0.004
q16_16 32768 0.000015
float 3e38 1e-45
""", flash="""
operations format implementation flash_bytes
nine float libc 2388
nine q16_16 default 9000
""")
        rows = {row["kind"]: row for row in operations.format_table(made)}
        self.assertEqual(list(rows), [("q8_8", "default"), ("q16_16", "default"), operations.FLOAT,
                                      operations.PUBLISHED])
        self.assertEqual([round(row["ratio"], 4) for row in rows.values()], [0.05, 0.2236, 1, 0.4])
        self.assertEqual([row["flash"] for row in rows.values()], [None, 9000, 2388, None])
        ours = rows["q16_16", "default"]
        self.assertEqual((ours["range"], ours["resolution"], ours["ulp"]),
                         ("32\u202f768", "1.5e-05", "0.5 (sqrt)"))
        self.assertEqual(ours["cycles"], [10, None, None, 300, None, None])
        self.assertEqual(rows[operations.FLOAT]["losses"], "slower than Q16.16 in 2 of 2")
        self.assertEqual(operations.power(0.25), "0.25")
        self.assertEqual(operations.power(2.0**31), "2\u202f147\u202f483\u202f648")

    def test_flash_of_a_program_with_several(self):
        made = golden(flash="""
operations format implementation flash_bytes
nine float libc 2388
nine q16_16 small 2500
nine q16_16 default 9000
own q16_16 default 900
own q8_8 small 90
""")
        self.assertEqual(operations.flash_together(made, "q16_16"), 9000)
        self.assertIsNone(operations.flash_together(made, "q8_8"))
        self.assertEqual(operations.least_flash(made),
                         "A program with the nine operations takes the least flash in avr-libc float: 2388 bytes; the "
                         "smallest of ours takes 2500 (Q16.16, small tables).")

    def test_what_correct_rounding_costs(self):
        made = golden(operations=OPERATIONS)
        self.assertEqual(operations.correctly_rounded_finding(made), "")
        made = golden(operations=OPERATIONS + """\
sqrt q16_16 correctly_rounded physics 9 9 750 999 1 0.49 1 0.001 50 ll
add q16_16 correctly_rounded physics 9 9 15 2000 1 0.5 1 0.001 50 mm
""")
        self.assertEqual(operations.correctly_rounded_finding(made),
                         "If you need correct rounding, in Q16.16 `CorrectlyRounded` errs by at most 0.5 ulp in 2 functions (bound: "
                         "lower bound in 2). It takes 1.5 (add) to 2.5 (sqrt) times the default's mean cycles, and up to 2000 "
                         "cycles near a tie.")

    def test_a_pareto_front_is_what_no_other_beats(self):
        front = error_against_cycles.pareto([(3, 5), (1, 9), (2, 9), (4, 5), (5, 1), (3, 6)])
        self.assertEqual(front, [(1, 9), (3, 5), (5, 1)])
        self.assertEqual(error_against_cycles.pareto([(1, 2), (1, 1), (0, 3)]), [(0, 3), (1, 1)])

    def test_error_against_cycles(self):
        plain = OPERATIONS.replace("exp float", "dot2 q16_16 default physics 9 9 9 9 1 0.5 1 0.1 9 ii\ndot2 float")
        contested = "".join(f"{operation} q16_16 small physics 9 9 {cycles} 999 1 0.5 1 0.001 5 kk\n"
                            for operation, cycles in (("add", 50), ("sqrt", 700)))
        made = golden(operations=plain + contested)
        shown = [axes for axes in error_against_cycles.draw(made).axes if axes.axison]
        # Of dot2 there is nothing beside ours and float.
        self.assertEqual([axes.get_title() for axes in shown], ["add", "sqrt"])
        self.assertEqual([point for point, _ in points(shown[0])],
                         [(10, 0.001), (40, 0.001), (100, 0.0001), (50, 0.001)])
        self.assertEqual(points(shown[1])[0][0], (300, error_against_cycles.FLOOR))
        self.assertEqual(curves(shown[0]), [([10, 100, 130], [0.001, 0.0001, 0.0001])])
        self.assertEqual(texts(shown[0]), ["10", "20", "30", "5"])
        self.assertAlmostEqual(shown[0].get_ylim()[0], 0.0001 / 3)
        self.assertAlmostEqual(shown[0].get_ylim()[1], 0.003)
        self.assertEqual(error_against_cycles.finding(made),
                         "In 3 of 3 operations with kernels, one of our formats is on the Pareto front (nothing else is "
                         "both faster and more exact); float is in 2.")

    RIVALS = """
rival variant version commit measured operation format operands regular cycles_mean rms_error flash_bytes failure
libfixmath libfixmath - abc 2026-01-02 sqrt q16_16 physics 9 500 0.00002 49 -
libfixmath libfixmath - abc 2026-01-02 sqrt q16_16 full 9 1 0.00002 49 -
libfixmath libfixmath_bytes - abc 2026-01-02 sqrt q16_16 physics 9 1 0.00002 49 hangs
avrfix avrfix 1.1 - 2026-01-03 add q16_16 physics 9 10 0 10 -
avrfix avrfix 1.1 - 2026-01-03 add q8_24 physics 9 1 0 9 -
fp64lib fp_double 1.1 - 2026-01-03 add float64 physics 9 123 0.0000001 9 -
"""

    def test_rivals_stand_beside_ours(self):
        made = golden(operations=OPERATIONS, rivals=self.RIVALS)
        self.assertEqual(rivals.finding(made, "q16_16"),
                         "Of 2 functions of other libraries, compared with Q16.16, none takes fewer cycles than ours; "
                         "some take as many for add. 1 has a smaller error than ours, 1 takes less flash.")
        self.assertEqual(rivals.finding(made, "q32_32"), "")  # none of ours was measured
        self.assertEqual([(row["operation"], row["cycles_mean"]) for row in rivals.rows(made)],
                         [("sqrt", 500), ("add", 10), ("add", 123)])
        wide = golden(operations=OPERATIONS.replace("q8_8", "q32_32"), rivals=self.RIVALS)
        self.assertEqual(rivals.finding(wide, "q32_32"),
                         "Of 1 functions of other libraries, compared with Q32.32, none takes fewer cycles than ours. "
                         "1 has a smaller error than ours, 1 takes less flash.")
        compilers = golden(operations=OPERATIONS, rivals=self.RIVALS.replace("avrfix avrfix", "GCC gcc_accum"))
        self.assertEqual({row["variant"] for row in rivals.judged(compilers)}, {"libfixmath", "gcc_accum", "fp_double"})
        self.assertEqual({row["variant"] for row in rivals.comparable(compilers)}, {"libfixmath", "fp_double"})
        self.assertEqual(rivals.origins(made), "Measured on 2026-01-02: libfixmath at abc. "
                                               "Measured on 2026-01-03: avrfix 1.1; fp64lib 1.1.")
        shown = [axes for axes in error_against_cycles.draw(made).axes if axes.axison]
        self.assertIn((500, 0.00002), [point for point, _ in points(shown[1])])
        self.assertNotIn(123, [cycles for (cycles, _), _ in points(shown[0])])  # of 64 bits

    def test_another_librarys_lead_is_told(self):
        made = golden(operations=OPERATIONS, rivals=self.RIVALS.replace(" 500 ", " 5 "))
        self.assertIn("1 takes fewer cycles than ours: sqrt of libfixmath", rivals.finding(made, "q16_16"))

    def test_errors_are_compared_over_one_range(self):
        """Of an operand whose result ours cannot hold, the other's error says nothing beside ours."""
        made = golden(operations=OPERATIONS.replace("physics 9 9 10", "physics 9 8 10"), rivals=self.RIVALS)
        self.assertIn(" 0 have a smaller error than ours", rivals.finding(made, "q16_16"))

    def test_a_rival_without_a_name_is_refused(self):
        made = golden(operations=OPERATIONS, rivals=self.RIVALS.replace("libfixmath_bytes", "another"))
        with self.assertRaisesRegex(DataError, "another"):
            rivals.rows(made)

    def test_histograms_are_shares_of_all_inputs(self):
        rows = "operation format implementation low_ulp high_ulp count\n"
        for operation, number_format in error_histograms.PANELS:
            for implementation in ("published", "default"):
                rows += f"""{operation} {number_format} {implementation} -inf -1 10
{operation} {number_format} {implementation} -1 -0.5 20
{operation} {number_format} {implementation} -0.5 0.5 65
{operation} {number_format} {implementation} 1 inf 5
"""
        for axes in error_histograms.draw(golden(error_histograms=rows)).axes:
            steps = [patch.get_data() for patch in axes.patches]
            self.assertEqual([(list(step.edges), list(step.values)) for step in steps], 2 * [([-1, -0.5, 0.5], [0.2, 0.65])])
            self.assertEqual(texts(axes), 2 * ["beyond: 15 %"])
            self.assertEqual([line.get_xdata()[0] for line in axes.lines], [-0.5, 0.5])

    def test_division_cycles(self):
        figure = division_cycles.draw(golden(operations="""
operation format implementation operands cycles_mean
divide q16_16 default small 481
divide q16_16 default physics 480
""", division_cycles="""
kind operands cycles count value note
fixed_16_16_histogram small 1600 3 - -
fixed_16_16_histogram small 1616 1 - -
float_histogram small 480 4 - -
float_histogram full 480 4 - -
published - 992 - 62 engine
published - 1920 - 120 Table
published - 1900 - 120 less
law - - - 2 constant
"""))
        self.assertEqual([axes.get_title() for axes in figure.axes], ["operands: below 1"])
        axes = figure.axes[0]
        self.assertEqual([(bar.get_x(), bar.get_width(), bar.get_height()) for bar in axes.patches],
                         [(1600, 16, 0.75), (1616, 16, 0.25), (480, 16, 1)])
        self.assertEqual([line.get_xdata()[0] for line in axes.lines], [481, 992, 1920, 1900])
        self.assertEqual([(text.get_text(), text.xy[0]) for text in axes.texts],
                         [("engine: 62 µs", 992), ("Table 3.2", 1920), ("Table 3.2 minus loop", 1900)])

    def test_table_3_2_has_the_published_cells(self):
        with open(pathlib.Path(__file__).parents[3] / "reference/published/table_3_2.csv", encoding="utf-8") as stream:
            names, *rows = list(csv.reader(stream))
        self.assertEqual(table_3_2.CELLS, sum(len(row) - 1 for row in rows), names)

    def test_table_3_2(self):
        made = golden(table_3_2="""
type operation published_ms measured_ms ratio verdict reason
int16_t add 44 45 1.02 reproduced -
int16_t divide 34 45 1.32 explained -
float add 30 31 1.03 reproduced -
""", table_3_2_hypotheses="""
rank measured_with log_ratio_sum within_10_percent
1 no 3.5 6
2 yes 3.75 9
""")
        axes = table_3_2.draw(made).axes[0]
        drawn = {collection.get_label(): collection.get_offsets().tolist()
                 for collection in axes.collections}
        self.assertEqual(drawn, {"reproduced: 2 + 0": [[0, 1.02], [2, 1.03]], "explained: 1 + 0": [[1, 1.32]]})
        self.assertEqual(axes.get_xlim(), (-0.7, 2.7))
        self.assertEqual(table_3_2.verdicts(made),
                         {"reproduced": 2, "explained": 1, "not reproducible": 0})
        chosen, chance = table_3_2.hypothesis(made)
        self.assertEqual((chosen["rank"], chance), (2, 7.5))


GROWTH = """
where broad_phase particles cost_per_step fitted fit_worst_percent
chip brute_force 2 50 51 3.84
chip brute_force 4 200 199 3.84
chip brute_force 3 100 101 3.84
chip brute_force 8 800 801 3.84
chip sort_and_sweep 2 40 41 1.57
chip sort_and_sweep 3 100 101 1.57
chip sort_and_sweep 4 199 198 1.57
chip sort_and_sweep 8 300 301 1.57
"""
PLANE = """
where broad_phase particles cost_per_step fitted fit_worst_percent
host brute_force 16 1e6 1.1e6 3.84
host sort_and_sweep 16 2e6 2.5e6 3.04
host sort_and_sweep 36 4e6 5e6 3.04
host sort_and_sweep 64 9e6 7.5e6 3.04
host box2d 16 3e6 - -
host box2d 64 18e6 - -
"""


class Growth(Figures):
    def test_the_crossing_is_where_it_stays_cheaper(self):
        self.assertEqual(growth.crossing(golden(growth=GROWTH).rows("growth")), 4)
        dearer = GROWTH.replace("sort_and_sweep 8 300", "sort_and_sweep 8 800")
        self.assertIsNone(growth.crossing(golden(growth=dearer).rows("growth")))
        alone = GROWTH + "chip sort_and_sweep 16 9 9 1.57"
        self.assertEqual(growth.crossing(golden(growth=alone).rows("growth")), 4)

    def test_what_is_told_of_it(self):
        phases = """
scene feature with cycles_per_step_mean
lever broad_phase=BruteForce yes 5438
lever broad_phase=SortAndSweep yes 5562
"""
        made = golden(growth=GROWTH, features=phases)
        self.assertEqual(growth.finding(made), "In this box sort and sweep is cheaper from 4 particles upwards "
                         "on the chip. A step costs a + b N + c times the pairs tested: on the chip within 3.8% (every pair) "
                         "and 1.6% (sort and sweep). With the two particles of the lever's scene, sort and sweep takes 5562 "
                         "cycles a step and every pair 5438.")
        with self.assertRaisesRegex(DataError, "no row with scene = lever, feature = broad_phase=SortAndSweep"):
            growth.finding(golden(growth=GROWTH, features=phases.replace("SortAndSweep", "SweepAndSort")))

    def test_the_plane_is_held_against_box2d(self):
        self.assertEqual(growth.beside_box2d(golden(growth_host=PLANE).rows("growth_host")),
                         "There 64 discs take 9.00 ms a step in Q16.16 and 18.00 ms in Box2D's float; over all numbers of "
                         "discs Box2D takes 1.50 to 2.00 times as long as ours.")

    def test_what_is_told_of_the_host(self):
        rows = golden(growth_host=PLANE).rows("growth_host")
        told = growth.finding(golden(growth=GROWTH, growth_host=PLANE))
        self.assertIn(growth.beside_box2d(rows), told)
        self.assertIn("on the chip within 3.8% (every pair) and 1.6% (sort and sweep), on the host within 3.8% (every pair) and "
                      "3.0% (sort and sweep). There sort and sweep", told)

    def test_points_are_measured_and_lines_fitted_by_particles(self):
        chip, host = growth.draw(golden(growth=GROWTH, growth_host=PLANE)).axes
        self.assertEqual(curves(chip), [([2, 3, 4, 8], [50, 100, 200, 800]),
                                        ([2, 3, 4, 8], [51, 101, 199, 801]),
                                        ([2, 3, 4, 8], [40, 100, 199, 300]),
                                        ([2, 3, 4, 8], [41, 101, 198, 301])])
        # Nothing is fitted to Box2D.
        self.assertEqual(curves(host), [([16], [1e6]), ([16], [1.1e6]),
                                        ([16, 36, 64], [2e6, 4e6, 9e6]), ([16, 36, 64], [2.5e6, 5e6, 7.5e6]),
                                        ([16, 64], [3e6, 18e6])])
        self.assertEqual(chip.get_ylim()[0], 0)
        self.assertEqual(host.get_ylim(), (5e5, 3.6e7))
        self.assertEqual(host.get_xscale(), "log")


SCENES = """
scene scalar arithmetic integrator dt steps cycles_per_step_mean cycles_per_simulated_second error error_method error_arithmetic flash_bytes verdict
fall q16_16 nearest semi_implicit_euler 0.00390625 9 100 25600 0.01 0.009 0.001 500 held
fall q16_16 saturating semi_implicit_euler 0.00390625 9 110 28160 0.01 0.009 0.001 520 held
fall float avr-libc semi_implicit_euler 0.00390625 9 400 102400 0.004 0.003 0.001 900 held
fall q16_16 nearest velocity_verlet 0.0078125 9 150 19200 0.02 0.001 0.019 500 held
fall q32_32 nearest velocity_verlet 0.0078125 9 900 115200 0.001 0.001 0 500 held
fall q16_16 published explicit_euler 0.0078125 9 90 11520 0.5 0.4 0.1 500 held
fall fifty_digits nearest velocity_verlet 0.0078125 9 - - 0.001 0.001 0 - held
fall q8_8 nearest velocity_verlet 0.0078125 9 80 10240 9 0.001 9 400 failed:
rope q16_16 nearest velocity_verlet 0.5 9 80 160 - - - 400 held
"""


STATES = """
scene scalar integrator dt states held error_min error_median error_max
fall q8_24 velocity_verlet 0.5 8 8 1 2 4
fall float velocity_verlet 0.5 8 8 2 3 4
fall q8_24 velocity_verlet 0.25 8 7 1 2 90
fall float velocity_verlet 0.25 8 8 1 2 9
"""


class Scenes(Figures):
    def setUp(self):
        self.data = golden(scenes=SCENES)

    def test_the_spread_over_starts(self):
        self.assertIn("the largest error of a run is 4.0 times the smallest (median of the 3 runs", scenes.spread_finding(golden(
            initial_states=STATES)))
        self.assertIn("than in float in 1 of the 1 runs", scenes.spread_finding(golden(
            initial_states=STATES)))

    def test_what_held_on_the_chip_and_can_be_judged_counts(self):
        self.assertEqual(len(scenes.measured(self.data)), 6)
        self.assertEqual(scenes.judged(self.data), ["fall"])
        self.assertEqual(scenes.names(self.data), ["fall", "rope"])
        self.assertEqual(scenes.measured(self.data, "rope"), [])
        self.assertEqual([row["scalar"] for row in scenes.failures(self.data)], ["q8_8"])

    def test_names(self):
        row = self.data.rows("scenes")[5]
        self.assertEqual((scenes.scalar(row), scenes.method(row), scenes.step(row), scenes.ours(row)),
                         ("Q16.16, 2016 design", "explicit Euler", "1/128 s", False))
        self.assertEqual(scenes.step({"dt": 1 / 3}), "1/3 s")
        self.assertEqual(scenes.title("two_words"), "two words")
        self.assertTrue(scenes.ours({"arithmetic": "saturating"}))

    def test_the_best_split_stands_beside_the_formats(self):
        data = golden(scenes=SCENES + "fall q5_27 nearest velocity_verlet 0.0078125 9 170 50000 0.003 0.002 0 600 held\n"
                              "fall q6_26 nearest velocity_verlet 0.0078125 9 170 200000 0.2 0.2 0 600 held\n")
        row = data.rows("scenes")[-2]
        self.assertEqual((scenes.kind(row), scenes.scalar(row), scenes.ours(row)),
                         (("q5_27", "default"), "Q5.27", True))
        self.assertIn("(Q5.27, Q6.26). It is on the front in 1 of 1 scenes.", scenes.splits_finding(data))
        self.assertFalse(scenes.splits_finding(self.data))
        self.assertFalse(any(map(scenes.is_split, self.data.rows("scenes"))))
        scenes.draw(data)

    def test_compensated_integration_is_ours_and_beside_its_twin(self):
        rows = ("fall q16_16 compensated velocity_verlet 0.0078125 9 180 23040 0.003 0.001 0.0019 520 held\n"
                "fall q16_16 compensated velocity_verlet 0.00390625 9 200 51200 0.9 0.001 0.8 520 held\n"
                "fall q16_16 nearest velocity_verlet 0.00390625 9 160 40960 0.9 0.001 0.8 520 held\n")
        data = golden(scenes=SCENES + rows)
        row = data.rows("scenes")[-3]
        self.assertEqual((scenes.kind(row), scenes.scalar(row), scenes.ours(row)),
                         (("q16_16", "compensated"), "Q16.16, compensated", True))
        self.assertEqual(scenes.compensated_finding(data),
                         "With compensated integration: in Q16.16 it takes 1.20 to 1.25 times the cycles, the arithmetic's error is "
                         "5.5 times smaller (median), and it is on 1 fronts.")
        self.assertEqual(scenes.compensated_finding(self.data), "")
        with self.assertRaisesRegex(DataError, "there is no row with scene = fall, scalar = q16_16"):
            scenes.compensated_finding(golden(scenes=SCENES + rows.replace("q16_16 nearest", "q8_8 nearest")))
        scenes.draw(data)

    def test_the_total_error_is_compared_from_other_starts(self):
        states = """
scene scalar arithmetic integrator dt states held error_median
fall float ieee semi_implicit_euler 0.00390625 8 8 0.005
fall q16_16 nearest semi_implicit_euler 0.00390625 8 8 0.006
fall q16_16 nearest velocity_verlet 0.0078125 8 8 0.0045
fall q32_32 nearest velocity_verlet 0.0078125 8 8 0.0001
fall q16_16 saturating semi_implicit_euler 0.00390625 8 7 0.0001
"""
        cancelling = SCENES.replace("102400 0.004 0.003", "102400 0.004 0.03")
        lead, = scenes.total_leads(golden(scenes=cancelling, initial_states=states))
        self.assertEqual((lead["row"]["scalar"], lead["rival"]["error"], lead["median"], lead["rival_median"]),
                         ("float", 0.01, 0.005, 0.0045))
        self.assertIn("float would lead from the scene's own start in fall (semi-implicit Euler, 1/256 s: 4.0e-03 m, ours 1.0e-02 m; "
                      "over the initial states below its median is 5.0e-03 m, that of ours at no higher cost 4.5e-03 m).",
                      scenes.total_finding(golden(scenes=cancelling, initial_states=states)))
        none = SCENES.replace("102400 0.004 0.003", "102400 0.01 0.003")
        self.assertEqual(scenes.total_finding(golden(scenes=none, initial_states=states)),
                         "By their sum float would lead in no scene either.")

    def test_targets_are_the_errors_that_their_names_say(self):
        units = {"cm": 1e-2, "mm": 1e-3, "µm": 1e-6}
        self.assertGreater(len(scenes.TARGETS), 0)
        for name, error in scenes.TARGETS.items():
            number, unit = name.split()
            self.assertAlmostEqual(error / (float(number) * units[unit]), 1)

    def test_the_front(self):
        front = scenes.front(scenes.measured(self.data))
        self.assertEqual([(row["cycles_per_simulated_second"], row["error"]) for row in front],
                         [(11520, 0.5), (19200, 0.02), (25600, 0.01), (102400, 0.004),
                          (115200, 0.001)])

    def test_the_cheapest_for_an_error_may_have_that_error(self):
        def cost(error):
            row = scenes.cheapest(self.data, "fall", error)
            return row and row["cycles_per_simulated_second"]
        self.assertEqual([cost(e) for e in (1, 0.4, 0.019, 0.0189, 0.009, 0.003, 0.001, 0.0009)],
                         [11520, 11520, 19200, 25600, 25600, 102400, 115200, None])

    def test_float_wins_where_none_of_ours_is_as_good_at_that_cost(self):
        win, = scenes.float_wins(self.data)
        self.assertEqual((win["row"]["error"], win["rival"]["error"], win["match"]["error"]),
                         (0.004, 0.01, 0.001))
        self.assertEqual(win["reason"],
                         "Q16.16 pays for semi-implicit Euler with steps of 1/256 s there, whose own error "
                         "is 9.0e-03 m (its arithmetic's 1.0e-03 m); ours reaches float's error as Q32.32, "
                         "velocity Verlet, at 0.115 million cycles")
        self.assertEqual(scenes.finding(self.data), "In 0 of 1 scenes, for every choice of float there is a choice "
                         "of ours that costs no more and errs no more (within 5%); not in fall.")

    def test_errors_that_cancel_rank_by_the_larger(self):
        row = {"error": 0.001, "error_method": 0.004, "error_arithmetic": 0.005}
        self.assertEqual(scenes.size(row), 0.005)

    def test_where_a_shorter_step_is_worse(self):
        rows = SCENES + "fall q16_16 nearest velocity_verlet 0.00390625 9 150 38400 0.03 0.001 0.029 500 held\n"
        self.assertTrue(scenes.turning(golden(scenes=SCENES)).startswith("In 0 of 1 scenes"))
        self.assertTrue(scenes.turning(golden(scenes=rows)).startswith("In 1 of 1 scenes"))

    def test_an_error_that_differs_by_five_percent_is_the_same(self):
        def wins(error):
            changed = SCENES.replace("102400 0.004 0.003", f"102400 0.004 {error}")
            return len(scenes.float_wins(golden(scenes=changed)))
        self.assertEqual([wins(error) for error in (0.0085, 0.00854, 0.0086, 0.009)], [1, 1, 0, 0])

    def test_the_reason_is_what_the_data_say(self):
        row = {"dt": 0.25}

        def reason(dt, method, arithmetic):
            rival = {"scalar": "q8_8", "arithmetic": "nearest", "integrator": "velocity_verlet",
                     "dt": dt, "error_method": method, "error_arithmetic": arithmetic}
            return scenes.reason(row, rival, None)
        self.assertEqual(reason(0.25, 1, 2), "Q8.8 errs by its resolution there (2.0e+00 m, the method "
                         "by 1.0e+00 m); none of ours reaches float's error")
        self.assertIn("Q8.8 pays for velocity Verlet with steps of 1/2 s there, whose own error is "
                      "1.0e+00 m", reason(0.5, 1, 1))
        self.assertEqual(scenes.reason(row, None, None), "none of ours is as cheap")

    def test_saturation(self):
        (plain, saturating, real), = scenes.saturation(self.data)
        self.assertEqual([row["cycles_per_step_mean"] for row in (plain, saturating, real)],
                         [100, 110, 400])

    def test_figures(self):
        axes = scenes.draw(self.data).axes[0]
        lines = curves(axes)
        self.assertEqual([point for point, _ in points(axes)],
                         [(25600, 0.009), (28160, 0.009), (102400, 0.003), (19200, 0.019),
                          (115200, 0.001), (11520, 0.4)])
        right = 115200 * 1.3
        self.assertEqual(lines[-2], ([11520, 19200, 25600, 102400, 115200, right],
                                     [0.4, 0.019, 0.009, 0.003, 0.001, 0.001]))
        self.assertEqual(lines[-1][0], [16e6, 16e6])
        self.assertEqual(texts(axes), ["1/128", "1/256", "1/256", "1/128", "1/128"])
        near = SCENES.replace(" 115200 ", " 102500 ").replace(" 0.001 0.001 ", " 0.0029 0.0029 ")
        self.assertEqual(len(texts(scenes.draw(golden(scenes=near)).axes[0])), 4)  # one label has no room
        steps = curves(scenes.draw_time_steps(self.data).axes[0])
        self.assertEqual(steps[0], ([0.0078125], [0.001]))
        self.assertEqual([line for line in steps[1:] if line[0]],
                         [([0.0078125], [0.019]), ([0.0078125], [scenes.FLOOR])])


class Workload(Figures):
    def test_trace(self):
        rows = "arithmetic lane begin_us end_us\n"
        for factor, arithmetic in enumerate(scenes_workload.ARITHMETICS, 1):
            rows += f"{arithmetic} step 0 {1000 * factor}\n"
            rows += f"{arithmetic} divide 10 {10 + 40 * factor}\n{arithmetic} divide 100 {100 + 20 * factor}\n"
        for factor, axes in enumerate(
                scenes_workload.draw_trace(golden(workload_trace=rows)).axes, 1):
            self.assertTrue(axes.get_title().endswith(f": {factor}.00 ms"))
            self.assertEqual([spans(lane) for lane in axes.collections],
                             [[(10, 40 * factor), (100, 20 * factor)], [(0, 1000 * factor)]])
            self.assertEqual(texts(axes), [f"2 × {30 * factor:.1f} µs", f"1 × {1000 * factor:.1f} µs"])
            self.assertEqual([label.get_text() for label in axes.get_yticklabels()],
                             ["divide", "step"])
            self.assertEqual(axes.get_xlim(), (0, 1000 * factor))

    def test_the_steps_of_the_lever(self):
        made = golden(features="""
scene feature with cycles_per_step_mean flash_bytes
lever arithmetic=Nearest yes 2335 6690
lever arithmetic=Small yes 9266 5292
everything arithmetic=Nearest yes 61402 15442
""", scenes="""
scene scalar arithmetic integrator dt cycles_per_step_mean flash_bytes
lever q16_16 nearest semi_implicit_euler 0.00390625 2681 6798
lever q16_16 nearest semi_implicit_euler 0.0078125 2682 6799
lever q16_16 saturating semi_implicit_euler 0.00390625 2802 7134
lever q16_16 nearest velocity_verlet 0.00390625 2900 7000
lever q32_32 nearest semi_implicit_euler 0.00390625 9000 9000
lever float avr-libc semi_implicit_euler 0.00390625 7657 3212
""", workload="""
quantity arithmetic measured reason
lever_step q16_16 2676 -O2
lever_flash q16_16 6850 -O2
lever_step float 7760 -O2
lever_flash float 3348 -O2
""")
        self.assertEqual([(name, command, cycles, flash) for name, command, _, cycles, flash
                          in scenes_workload.lever_steps(made)],
                         [("Q16.16", "features", 2335, 6690), ("Q16.16", "scenes", 2681, 6798),
                          ("float", "scenes", 7657, 3212), ("Q16.16", "workload", 2676, 6850),
                          ("float", "workload", 7760, 3348)])

    def test_a_step_of_the_lever_without_a_row_is_not_passed_over(self):
        feature = "scene feature with cycles_per_step_mean flash_bytes\nlever arithmetic=Nearest yes 2335 6690"
        scene = "scene scalar arithmetic integrator dt cycles_per_step_mean flash_bytes\n"
        step = "lever {} semi_implicit_euler 0.00390625 2681 6798\n"
        with self.assertRaisesRegex(DataError, "scenes.csv: there is no row with scene = lever, scalar = float"):
            scenes_workload.lever_steps(golden(features=feature, scenes=scene + step.format("q16_16 nearest")))
        both = scene + step.format("q16_16 nearest") + step.format("float avr-libc")
        with self.assertRaisesRegex(DataError, "workload.csv: there is no row with arithmetic = q16_16, quantity = lever_step"):
            scenes_workload.lever_steps(golden(features=feature, scenes=both, workload="quantity arithmetic measured reason\n"
                                                                                        "lever_flash q16_16 6850 -O2"))

    def test_rounds(self):
        axes = scenes_workload.draw_rounds(golden(workload_rounds="""
arithmetic rounds cycles steps
fixed_16_16 0 100 0
fixed_16_16 1 300 7
q16_16 0 50 3
""")).axes[0]
        self.assertEqual(curves(axes)[:2], [([0, 1], [100, 300]), ([0], [50])])
        self.assertEqual(curves(axes)[3][1], [70400, 70400])  # 4.4 ms of 16 MHz
        self.assertEqual(texts(axes), ["7 steps", "3 steps", "published step: 4.4 ms"])
        self.assertEqual(axes.get_ylim()[0], 0)


class Stability(Figures):
    def test_numbers(self):
        self.assertEqual([stability.figure(x) for x in (0, 0.5, 0.00123456, 999, 1000, 123456, 1234567,
                                                        0.000999, 1e-5, -2.5e-7, "none")],
                         ["0", "0.5", "0.00123", "999", "1\u202f000", "123\u202f000",
                          "1.23·10<sup>6</sup>", "9.99·10<sup>−4</sup>", "10<sup>−5</sup>",
                          "−2.5·10<sup>−7</sup>", "none"])
        self.assertEqual(stability.whole(1234567), "1\u202f234\u202f567")
        self.assertEqual(stability.number("2.5"), 2.5)
        for gap in (None, "none", ""):
            self.assertNotEqual(stability.number(gap), stability.number(gap))

    ROWS = """
case scalar arithmetic integrator limit verdict first_event
a q16_16 nearest velocity_verlet 1 overflows overflow_add
b q16_16 nearest velocity_verlet 1 overflows overflow_convert
c q16_16 nearest velocity_verlet 1 drifts -
d q16_16 nearest explicit_euler 1 overflows overflow_add
e q16_16 saturating velocity_verlet 1 overflows overflow_convert
f q8_8 nearest velocity_verlet 1 overflows overflow_add
"""

    def rows(self):
        made = golden(stability=self.ROWS)
        for row in made.rows("stability"):
            row["first_event"] = (row["first_event"] or "").replace("_", " ")
        return made

    def test_what_fails_in_silence(self):
        rows = self.rows().rows("stability")
        self.assertEqual(stability.silent(rows, "nearest"), (3, 1, 1))
        self.assertEqual(stability.silent(rows, "saturating"), (1, 0, 1))

    def test_wraps_that_were_announced(self):
        self.assertIsNone(stability.announced(self.rows().rows("stability")))
        made = golden(stability="""
case scalar arithmetic integrator limit verdict first_event bits_at_limit bits_beyond
a q16_16 nearest velocity_verlet 1 overflows overflow_add 0.5 -0.001
b q16_16 nearest velocity_verlet 1 overflows overflow_add 0 0
c q16_16 nearest velocity_verlet none overflows overflow_add - -2
d q16_16 nearest velocity_verlet 1 overflows overflow_add 1 -
e q16_16 nearest velocity_verlet 1 overflows overflow_convert 1 -
f q16_16 nearest velocity_verlet 1 drifts - -0.25 -1
g q16_16 nearest explicit_euler 1 overflows overflow_add -1 1
h q16_16 saturating velocity_verlet 1 saturates overflow_add - -
i q8_8 nearest velocity_verlet 1 overflows overflow_add -1 1
""")
        rows = made.rows("stability")
        for row in rows:
            row["first_event"] = (row["first_event"] or "").replace("_", " ")
        self.assertEqual(stability.announced(rows), (4, 2, 5, 1))

    def test_what_it_means_to_hold(self):
        rows = golden(stability="""
case dt steps holds
a 0.5 8 rods
rod_chain_of_8_heavy_end 0.25 2000 rods_within_20_%
b 0.001 300 planes
""").rows("stability")
        self.assertEqual(stability.horizon_finding(rows),
                         "*Stable* means within the tolerance of the case until the end of its horizon: 8 to 2\u202f000 steps, 0.3 to 500 s. "
                         "Each row has both at its limit, and the tolerance in words: columns `dt`, `steps` and `holds`; of rod chain of 8 "
                         "heavy end 2000 steps of 1/4 s, \"rods_within_20_%\".")

    SWEPT = """
case scalar arithmetic integrator unit limit swept contradicting holds_again
a q16_16 nearest velocity_verlet m 10 25 0 -
b_c float ieee warm_started m 10 33 2 30
d q8_8 nearest velocity_verlet m 8 41 1 1
d q8_8 nearest semi_implicit_euler m 8 41 1 1
e q16_16 nearest implicit_springs m 10 41 3 -
f q8_8 nearest implicit_springs m 10 - - -
"""

    def test_rows_that_are_not_monotone(self):
        told = ("In 5 rows, 25 to 41 values from the easy end to the hard one are swept; the first that fails, and a bisection next to it, "
                "give the limit. ")
        self.assertEqual(stability.sweep_finding(golden(stability=self.SWEPT).rows("stability")),
                         told + "4 of them are not monotone: values beyond the limit hold, or easier ones fail (`contradicting` counts them). "
                         "The worst is d in Q8.8 (semi-implicit Euler), which fails beyond 8 m and holds again at 1.")
        more = self.SWEPT + "g q16_16 nearest warm_started m 2 41 1 3\nh q16_16 saturating warm_started m 2 41 1 999\n"
        self.assertTrue(stability.sweep_finding(golden(stability=more).rows("stability")).endswith(
            "holds again at 1; in Q16.16 it is g (warm started), which fails beyond 2 m and holds again at 3."))
        for row in (rows := golden(stability=self.SWEPT).rows("stability")):
            row["arithmetic"] = "saturating"  # counted, not named
        self.assertTrue(stability.sweep_finding(rows).endswith("(`contradicting` counts them)."))
        flat = [row for row in golden(stability=self.SWEPT).rows("stability") if row["case"] in "af"]
        self.assertTrue(stability.sweep_finding(flat).endswith("No value of any sweep contradicts it."))

    def test_loads_that_chains_bear(self):
        rows = "case scalar arithmetic integrator limit verdict first_event\n"
        for i, links in enumerate((4, 8, 16)):
            for j, steps in enumerate(("", "_fine_steps")):
                for k, scalar in enumerate(("q16_16", "q32_32", "float")):
                    for m, method in enumerate(("semi_implicit_euler", "warm_started", "direct_rods", "one_iteration", "velocity_verlet")):
                        arithmetic = "ieee" if scalar == "float" else "nearest"
                        rows += (f"rod_chain_of_{links}_heavy_end{steps} {scalar} {arithmetic} {method} "
                                 f"{1000 * i + 100 * j + 10 * k + m} drifts -\n")
        found = golden(stability=rows + "rod_chain_of_4_heavy_end q16_16 saturating semi_implicit_euler 7 drifts -\n").rows("stability")
        self.assertTrue(stability.has_loaded_chains(found))
        self.assertFalse(stability.has_loaded_chains(self.rows().rows("stability")))
        lines = list(stability.loaded_chains(found))
        self.assertEqual([line[:3] for line in lines[:4]],
                         [(8, 4, "q16_16"), (8, 4, "q32_32"), (8, 4, "float"), (8, 8, "q16_16")])
        self.assertEqual([line[3] for line in lines[:2] + lines[-1:]], [[0, 1, 2, 3], [10, 11, 12, 13], [2120, 2121, 2122, 2123]])
        # One light body between two rods: the tension R g acts on it through 2 / L.
        self.assertAlmostEqual(math.sqrt(2 * 9.81 * stability.load_bound(2, 8) / 0.5) / 2**8, 2)
        self.assertAlmostEqual(stability.load_bound(4, 11) / stability.load_bound(4, 8), 64)
        # omega h = 2 for that body under 10^5 times its mass.
        self.assertAlmostEqual(math.sqrt(2 * 9.81 * 1e5 / 0.5) / stability.steps_for_load(2), 2)
        self.assertEqual(stability.load_finding(self.rows()), "")

    def test_what_the_solvers_of_chains_cost(self):
        ablations = "ablation case before_cycles after_cycles\n"
        for links, direct in ((4, 40), (8, 45), (16, 48)):
            ablations += f"direct rod_chain_of_{links}_heavy_end 100 {direct}\nother rod_chain_of_{links}_heavy_end 100 1\n"
        self.assertEqual(stability.costs(golden(ablations=ablations), "direct"), "40 to 48 %")

    def test_loads_that_chains_of_springs_bear(self):
        rows = "case scalar arithmetic integrator limit verdict first_event\n"
        ablations = "ablation case before_cycles after_cycles\n"
        for links in (4, 16):
            for i, method in enumerate(("implicit_springs", "gauss_seidel_springs", "direct_springs")):
                rows += f"spring_chain_of_{links}_heavy_end q16_16 nearest {method} {100 * i + links} drifts -\n"
            rows += f"spring_chain_of_{links}_heavy_end q16_16 saturating direct_springs 7 drifts -\n"
            ablations += f"together spring_chain_of_{links}_heavy_end 100 {150 + links}\n"
            ablations += f"iterated spring_chain_of_{links}_heavy_end 100 {400 + links}\n"
        made = golden(stability=rows, ablations=ablations)
        for row in made.rows("ablations"):
            row["ablation"] = {"together": "springs solved together", "iterated": "springs solved in ten iterations"}[row["ablation"]]
        self.assertEqual(stability.spring_finding(made),
                         " On springs too stiff for the step, chains of 4 and 16 bodies bear a last one of 4 and 16 times the mass of the "
                         "others in Q16.16 if the springs are solved one after the other (`ImplicitSprings`), 104 and 116 times in ten "
                         "iterations (`GaussSeidelSprings`, 404 to 416 % of the cycles) and 204 and 216 times together (`DirectSprings`, "
                         "154 to 166 %).")
        self.assertEqual(stability.spring_finding(self.rows()), "")

    def test_what_small_steps_of_one_iteration_cost(self):
        ablations = "ablation case before_cycles after_cycles\n"
        for links, whole, one in ((4, 100, 10), (8, 200, 20), (16, 400, 60)):
            ablations += f"warm rod_chain_of_{links}_heavy_end {whole} 1\nten rod_chain_of_{links}_heavy_end_fine_steps {one} 1\n"
        made = golden(ablations=ablations + "warm stack_of_20 7 1\n")
        names = {"warm": "iterations begun where the last step ended", "ten": "ten iterations in place of one"}
        for row in made.rows("ablations"):
            row["ablation"] = names[row["ablation"]]
        self.assertEqual(stability.cost_of_small_steps(made), "80 to 120 %")

    def test_where_the_devices_float_differs(self):
        table = """
operation operands pairs differ first_mismatch host device
add normal 10 0 - - -
divide result_is_subnormal 5 {} 0x1p-126 0x1p-127 0x0p+0
"""
        finding = stability.float_finding(golden(float_extremes=table.format(2)))
        self.assertIn("in 1 of 2 classes of operands", finding)
        self.assertIn("of 2 operations, 15 pairs in all. It differs in divide, result_is_subnormal: 2 of 5 pairs, of which the first is "
                      "0x1p-126: IEEE 754 requires 0x1p-127, the device returns 0x0p+0.", finding)
        self.assertTrue(stability.float_finding(golden(float_extremes=table.format(0))).endswith("15 pairs in all."))

    def test_what_a_bit_buys_of_a_chaotic_motion(self):
        finding = stability.divergence_finding(golden(dynamics="""
measure scalar arithmetic integrator at measured theory
divergence q8_8 nearest velocity_verlet 0.1 - 2
divergence q16_16 nearest velocity_verlet 0.1 4 6
divergence q16_16 saturating velocity_verlet 0.1 9 6
divergence q32_32 nearest velocity_verlet 0.1 12 14
divergence q32_32 nearest explicit_euler 0.1 99 14
divergence_rate q32_32 nearest velocity_verlet 0.1 1.25 1.386294361
"""))
        self.assertIn("by 0.1 m from the same method's run in double after 4 s in Q16.16, 12 s in Q32.32 (", finding)
        self.assertIn("In Q32.32 the distance grows at 1.25/s", finding)
        self.assertIn("each bit buys 0.5 s; ln 2 over that exponent is 0.5 s.", finding)

    def test_what_swings_for_ever(self):
        table = """
measure system scalar arithmetic integrator at measured theory dt
dead_band spring q8_8 nearest implicit_springs 4 0 0.5 0.00390625
limit_cycle spring q8_8 nearest implicit_springs 4 1 1 0.00390625
dead_band spring q16_16 nearest implicit_springs 4 0.002 0.003 0.00390625
limit_cycle spring q16_16 nearest implicit_springs 4 750 {} 0.00390625
limit_cycle spring float ieee implicit_springs 4 1 - 0.00390625
limit_cycle spring q16_16 nearest velocity_verlet 4 1 9 0.00390625
"""
        self.assertEqual(stability.cycle_finding(golden(dynamics=table.format(760.2))),
                         "With springs solved implicitly the body swings for ever in Q16.16: the step divides its velocity by so little "
                         "that the quotient rounds to the same number, and nothing is damped. In Q16.16 it swings by 0.002 m in 750 "
                         "steps; the period of rounded products is 760, without rounding it would be 804. ")
        self.assertEqual(stability.cycle_finding(golden(dynamics=table.format(1))), "")

    def test_what_a_heap_and_a_struck_chain_bear(self):
        table = """
case scalar arithmetic integrator limit
wedge_heavy_top q16_16 nearest semi_implicit_euler 20
wedge_heavy_top q16_16 nearest one_iteration 10
wedge_heavy_top q16_16 nearest warm_started 400
wedge_heavy_top q16_16 saturating semi_implicit_euler 9
impact_on_chain_of_8 q16_16 nearest semi_implicit_euler 3
impact_on_chain_of_8 q16_16 nearest one_iteration none
impact_on_chain_of_8 q16_16 nearest warm_started 4
impact_on_chain_of_8 float ieee warm_started 7
"""
        self.assertEqual(stability.heap_finding(golden(stability=table)),
                         " Two balls of 1 kg in a V bear a third of 20 (with one iteration 10, warm started 400) kg; the end of a chain of 8 "
                         "bodies of 1 kg withstands a blow of 10 kg at 3 (with one iteration none, warm started 4) m/s.")
        self.assertEqual(stability.heap_finding(golden(stability=table.replace("wedge", "stack"))), "")

    def test_the_search_next_to_the_theory_of_growth(self):
        made = golden(stability="""
case scalar arithmetic integrator limit
spring_coarse_step q16_16 nearest semi_implicit_euler 1.998
spring_coarse_step q16_16 saturating semi_implicit_euler 1.5
spring_coarse_step q8_8 nearest semi_implicit_euler none
spring_frame_step q16_16 nearest semi_implicit_euler 1
""")
        self.assertEqual(stability.search_of_two(made, "q16_16", "semi_implicit_euler"), "1.998")
        self.assertIsNone(stability.search_of_two(made, "q8_8", "semi_implicit_euler"))

    def test_what_depends_on_the_order_of_links(self):
        table = """
measure system scalar arithmetic integrator measured theory
order chain_of_rods q16_16 nearest semi_implicit_euler 0.25 0.5
order chain_of_rods q16_16 saturating semi_implicit_euler 9 9
order chain_of_rods q32_32 nearest semi_implicit_euler 0.5 0.5
order chain_of_springs q16_16 nearest semi_implicit_euler {} 0
order chain_of_springs q16_16 nearest implicit_springs 0.125 0.0625
"""

        def made(sums):
            data = golden(dynamics=table.format(sums))
            for row in data.rows("dynamics"):
                row["system"] = row["system"].replace("_", " ")
            return data
        self.assertEqual(stability.orders(made(0), "semi_implicit_euler")["chain of rods", "q16_16"], (0.25, 0.5))
        self.assertEqual(stability.order_finding(made(0)),
                         "0.5 m in double, because the iterations end before they converge. Forces of springs are sums, and leave none in "
                         "any format; springs solved implicitly, one after the other, leave 0.125 m in Q16.16 and 0.0625 m in double.")
        self.assertIn("Forces of springs leave up to 0.75 m;", stability.order_finding(made(0.75)))

    def test_how_fast_particles_may_be(self):
        table = """
case scalar integrator limit verdict
thin_wall q16_16 continuous_contacts 20000 overflows
thin_target q16_16 continuous_contacts 500 overflows
thin_wall float continuous_contacts 1000000 stable
thin_wall q16_16 velocity_verlet 7 drifts
stack q16_16 continuous_contacts 6 drifts
"""
        self.assertEqual(stability.tunnelling_finding(golden(stability=table)),
                         "With continuous contacts nothing passes a fixed wall or a free target at any speed that the format holds: 500 m/s in Q16.16, "
                         "10<sup>6</sup> m/s in float (the end of the search).")
        self.assertEqual(stability.tunnelling_finding(golden(stability=table.replace("500 overflows", "400 diverges"))),
                         "With continuous contacts something passes: thin target in Q16.16 (continuous contacts) beyond 400 m/s.")
        self.assertEqual(stability.tunnelling_finding(golden(stability=table.replace("continuous_contacts", "velocity_verlet"))), "")

    def test_the_long_run_of_a_format(self):
        found = stability.dynamics(golden(dynamics="""
measure system scalar arithmetic integrator at measured theory
growth spring q8_8 nearest velocity_verlet 1 1.25 1
growth spring q8_8 nearest velocity_verlet 2 0.5 1
growth spring q8_8 nearest velocity_verlet 2 - 1
growth spring q8_8 saturating velocity_verlet 2 9 1
energy orbit q8_8 nearest velocity_verlet 100000 7 0
energy orbit q8_8 nearest velocity_verlet 10000 3 0
reversal orbit q8_8 nearest velocity_verlet 10 0.125 0
dead_band spring q8_8 nearest velocity_verlet 4 0.5 0.75
limit_cycle spring q8_8 nearest velocity_verlet 4 12 1
"""), "q8_8", "velocity_verlet")
        self.assertEqual(found, {"growth": 0.5, "energy": {"orbit": 7}, "reversal": 0.125, "band": 0.5, "bound": 0.75,
                                 "period": 12})

    def test_limits_that_the_search_ended_are_marked(self):
        self.assertEqual(stability.with_end({"limit": 5.0, "limited_by": "stable"}), "beyond 5")
        self.assertEqual(stability.with_end({"limit": 5.0, "limited_by": "drifts"}), "5")

    def test_what_the_chain_bears(self):
        made = golden(stability_map="""
map x limit scalar arithmetic integrator
mass_ratio 2 100 q16_16 nearest semi_implicit_euler
mass_ratio 2 110 float ieee semi_implicit_euler
mass_ratio 16 7 q16_16 nearest semi_implicit_euler
mass_ratio 16 8 float ieee semi_implicit_euler
mass_ratio 16 1 float ieee explicit_euler
""")
        self.assertIn("of 2 rods bears a mass of 100 to 110 links, one of 16 rods 7 to 8. The format changes this by a factor of up to 1.1, "
                      "the length by a factor of 14.",
                      stability.chain_finding(made))

    MAP = """
map x limit scalar arithmetic integrator bound
{0} 0.5 20 q16_16 nearest explicit_euler 16
{0} 0.25 10 q16_16 nearest explicit_euler 64
{0} 0.25 11 q16_16 saturating explicit_euler 64
{0} 0.25 none float ieee semi_implicit_euler 64
{1} 0.25 1 q16_16 nearest explicit_euler 64
{1} 0.5 2 q16_16 nearest explicit_euler 16
{1} 0.25 none float ieee semi_implicit_euler 64
"""

    def test_maps_are_in_order_of_x_with_their_bound(self):
        rows = golden(stability_map=self.MAP.format("up", "low")).rows("stability_map")
        self.assertEqual(stability.points(rows, "up", "q16_16", "explicit_euler"),
                         ([0.25, 0.5], [10, 20]))
        self.assertEqual(stability.points(rows, "up", "q16_16", "explicit_euler", "saturating"),
                         ([0.25], [11]))
        self.assertEqual(stability.points(rows, "up", "q8_8", "explicit_euler"), ([], []))
        self.assertEqual(stability.bound(rows, "up"), ([0.25, 0.5], [64, 16]))

    def test_map_figures(self):
        made = golden(stability_map=self.MAP.format("stiffness_upper", "stiffness_lower"))
        panels = stability.draw_stiffness(made).axes
        shown = [[line for line in curves(axes) if line[0]] for axes in panels]
        self.assertEqual(shown[0][:2], [([0.25, 0.5], [10, 20]), ([0.25, 0.5], [1, 2])])
        # Explicit Euler: after 300 steps of sqrt(1 + k dt^2) the amplitude is 50 times the first.
        steps, limits = shown[0][2]
        for dt, limit in zip(steps, limits):
            self.assertAlmostEqual((1 + limit * dt**2)**150, 50)
        self.assertEqual(shown[1][-1], ([0.25, 0.5], [64, 16]))  # omega dt = 2
        self.assertEqual(shown[3], [])  # solved implicitly: no bound
        made = golden(stability_map=self.MAP.format("speed", "mass_ratio"))
        shown = [line for line in curves(stability.draw_speed(made).axes[0]) if line[0]]
        self.assertEqual(shown, [([0.25, 0.5], [10, 20]), ([0.25, 0.5], [64, 16])])

    def test_the_energy_that_a_motion_gains(self):
        made = golden(stability_map=self.MAP.format("speed", "mass_ratio"), dynamics="""
measure system scalar arithmetic integrator at measured theory
energy spring q16_16 nearest velocity_verlet 100 -0.5 0
energy spring q16_16 nearest velocity_verlet 10 0.25 0
energy spring q16_16 published velocity_verlet 10 9 9
energy spring q16_16 nearest explicit_euler 10 2 -3
energy spring q16_16 nearest explicit_euler 100 - 30
order spring q16_16 nearest velocity_verlet 10 7 7
energy orbit q16_16 nearest velocity_verlet 10 7 7
""")
        rows = made.rows("dynamics")
        steps, gained, theory = stability.energy_gained(rows, "spring", "q16_16", "velocity_verlet")
        self.assertEqual((steps, gained), ([10, 100], [0.25, 0.5]))
        self.assertTrue(all(map(math.isnan, theory)))
        steps, gained, theory = stability.energy_gained(rows, "spring", "q16_16", "explicit_euler")
        self.assertEqual((steps, gained[0], theory), ([10, 100], 2, [3, 30]))
        self.assertTrue(math.isnan(gained[1]))
        self.assertEqual([axes.get_title() for axes in stability.draw_speed(made).axes[2:]], ["spring", "orbit", "pendulum"])

    def test_the_speed_of_methods_that_are_not_drawn(self):
        rows = [f"speed {radius} {limit} q16_16 nearest {method} 9" for method, limits in
                (("semi_implicit_euler", (10, 20)), ("velocity_verlet", (10, 20)), ("implicit_springs", (10, 20)))
                for radius, limit in zip((1, 2), limits)]

        def told():
            return stability.speed_finding(golden(stability_map="\n".join(["map x limit scalar arithmetic integrator bound", *rows])))
        self.assertIn("velocity Verlet and springs solved implicitly are the same.", told())
        rows[3] = rows[3].replace(" 20 ", " 15 ")
        self.assertIn("differ by up to 25 %.", told())
        del rows[5]
        self.assertRaises(ValueError, told)


REGION = """
arithmetic damping clock loop_rate_hz arm_m hand_n_per_m plants at_rest released_at_rest linear_stable
q16_16 yes fixed 1000 0.23 30 4 4 2 1
q16_16 yes fixed 1000 0.48 30 4 3 4 2
q16_16 yes fixed 1000 0.23 60 4 1 4 3
q16_16 yes fixed 1000 0.48 60 4 0 0 4
published no published 100 0.23 30 4 1 0 0
"""


class Region(Figures):
    def data(self):
        return golden(stable_region=REGION, stable_limits="""
arithmetic damping clock loop_rate_hz plant at_rest_at_shortest hardest_hand_n_per_m linear_shortest_arm_m
q16_16 yes fixed 1000 1 yes 500 0.2
q16_16 yes fixed 1000 2 no 400 0.3
published no published 100 1 no - -
published no published 100 2 no 100 0.1
""", stable_on_chip="""
arithmetic damping clock loop_rate_hz chip host
q16_16 yes fixed 1000 at_rest at_rest
q16_16 yes fixed 1000 at_rest swings
q16_16 yes fixed 1000 swings swings
""")

    def test_grid(self):
        rows = self.data().rows("stable_region")[:4]
        arms, hands, shares = haptic_region.grid(rows, "at_rest")
        self.assertEqual((arms, hands, shares.tolist()),
                         ([0.23, 0.48], [30, 60], [[1, 0.75], [0.25, 0]]))

    def test_summary(self):
        ours, published = haptic_region.summary(self.data())
        self.assertEqual(ours, {"lever": "ours, Q16.16", "damping": "yes", "rate": "1000",
                                "grasped": 50, "released": 62.5, "theory": 62.5, "hardest": 400, "theory_arm": 0.3, "chip": "2 of 3"})
        self.assertEqual(published, {"lever": "2016 design", "damping": "no",
                                     "rate": "100, its own clock", "grasped": 25, "released": 0,
                                     "theory": 0, "hardest": None,
                                     "theory_arm": None, "chip": None})

    def test_the_rate_that_a_lever_runs_at(self):
        made, data = golden(haptic="""
scenario arithmetic loop_rate_hz
poke_while_held q16_16 1000.4
poke_while_held published 94
"""), self.data()
        data._loaded |= made._loaded
        self.assertEqual([row["rate"] for row in haptic_region.at_own_rate(data)],
                         ["1000", "100, its own clock"])
        made.rows("haptic")[0]["loop_rate_hz"] = 512
        self.assertEqual([row["rate"] for row in haptic_region.at_own_rate(data)], ["100, its own clock"])

    def test_agreement(self):
        self.assertEqual(haptic_region.agreement(self.data()), (2, 3))
        self.assertEqual(haptic_region.differing(self.data()), {"ours, Q16.16 at 1000 Hz": 1})

    def test_figure(self):
        figure = haptic_region.draw(self.data())
        shown = [axes for axes in figure.axes if axes.images]
        self.assertEqual([axes.images[0].get_array().tolist() for axes in shown],
                         [[[0.25]], [[1, 0.75], [0.25, 0]]])
        self.assertEqual([(text.get_text(), text.get_position(), text.get_color())
                          for text in shown[1].texts],
                         [("2", (0, 0), "black"), ("0", (1, 1), "white")])
        self.assertEqual([axes.get_title() for axes in figure.axes[:2]], ["its own clock", "1000 Hz"])

    def test_levers_that_rest_everywhere_are_told_and_not_drawn(self):
        at_rest = REGION + "float no fixed 1000 0.23 30 4 4 4 4\nfloat yes fixed 1000 0.23 30 4 4 3 4\n"
        made = golden(stable_region=at_rest)
        self.assertEqual(haptic_region.settled(made), [("float", "no")])
        self.assertEqual(haptic_region.settled_finding(made),
                         "Not drawn, because all plants are at rest everywhere: ours, float without damping.")
        self.assertEqual(haptic_region.settled_finding(self.data()), "")
        labels = [axes.get_ylabel() for axes in haptic_region.draw(made).axes]
        self.assertFalse(any("float,\nwithout" in label for label in labels), labels)
        self.assertTrue(any("float,\nselective" in label for label in labels), labels)

    def test_panels_are_in_order_of_rate_after_the_published_one(self):
        rates = "".join(f"q16_16 yes {clock} {rate} 0.23 30 4 4 4 4\n"
                        for clock, rate in (("fixed", 1000), ("published", 100), ("fixed", 50)))
        rows = REGION.strip().splitlines()[0] + "\n" + rates
        figure = haptic_region.draw(golden(stable_region=rows))
        self.assertEqual([axes.get_title() for axes in figure.axes[:3]],
                         ["its own clock", "50 Hz", "1000 Hz"])

    def test_numbers_can_be_read_on_their_shade(self):
        for plants, white in ((4, 2), (5, 3)):
            axes = plt.figure().add_subplot()
            rows = [{"arm_m": arm, "hand_n_per_m": 30, "plants": plants, "at_rest": arm,
                     "released_at_rest": 3} for arm in range(5)]
            haptic_region.write_released(axes, rows, list(range(5)), [30])
            self.assertEqual([text.get_color() for text in axes.texts],
                             white * ["white"] + (5 - white) * ["black"])

    def test_oscillation_of_the_last_second(self):
        rows = ("time_s published_damped_deg published_undamped_deg q16_16_damped_deg "
                "q16_16_undamped_deg\n")
        for k in range(3000):
            time = k / 1000
            late = time > 1.999
            rows += (f"{time} {9 if k < 1000 else 0.1 * math.sin(time)} "
                     f"{5 * math.sin(2 * math.pi * (7 * time + 0.3))} {1.5 if k == 2500 else 0} "
                     f"{1.6 if late and k % 100 == 50 else 0}\n")
        made = golden(oscillation=rows)
        found = haptic_region.oscillation(made)
        self.assertEqual([row["frequency"] for row in found], [7, None, 10, None])
        for row, swing in zip(found, (10, 0.1 * (math.sin(2) - math.sin(2.999)), 1.6, 1.5)):
            self.assertAlmostEqual(row["swing"], swing, 3)
        self.assertEqual([row["lever"] for row in found],
                         2 * ["2016 design"] + 2 * ["ours, Q16.16"])
        self.assertEqual([row["damping"] for row in found],
                         2 * ["without damping", "selective damping"])
        axes = haptic_region.draw_oscillation(made).axes[1]
        self.assertEqual(max(curves(axes)[1][1]), 1.5)
        self.assertEqual(curves(axes)[2][0], [2, 2])

    def test_none_is_less_and_more_than_any(self):
        self.assertEqual((haptic_region.least([3, 2]), haptic_region.most([3, 4])), (2, 4))
        self.assertEqual((haptic_region.least([3, None]), haptic_region.most([None])), (None, None))


class Check(unittest.TestCase):
    def test_what_does_not_follow_from_the_data_is_named(self):
        def made(folder, *_):
            (folder / "figures").mkdir(exist_ok=True)
            (folder / "README.md").write_text((folder / "data" / "x.csv").read_text())
            (folder / "figures" / "a.svg").write_text("a")

        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch.object(report, "write", made):
            results = pathlib.Path(folder)
            (results / "data").mkdir()
            (results / "data" / "x.csv").write_text("1")
            made(results, ())
            self.assertEqual(report.differences(results, ()), [])
            (results / "data" / "x.csv").write_text("2")
            self.assertEqual(report.differences(results, ()), [pathlib.Path("README.md")])
            (results / "figures" / "a.svg").unlink()
            with unittest.mock.patch("sys.argv", ["report.py", "--results", folder, "--check"]), \
                    contextlib.redirect_stderr(io.StringIO()) as told:
                self.assertEqual(report.main(), 1)
            self.assertEqual(told.getvalue().count("does not follow from the data"), 2)

    def test_the_tools_are_noted(self):
        with tempfile.TemporaryDirectory() as folder:
            report.note_tools(pathlib.Path(folder))
            noted = Data(folder).json("tools")
            self.assertRegex(noted["date"], r"^\d{4}-\d\d-\d\d$")
            self.assertIn("avr-gcc", noted["tools"])


class Findings(Figures):
    """Sentences in place of tables."""

    def test_blocks(self):
        made = golden(blocks="""
block format cycles_mean
pid q8_8 300
one_pole q8_8 100
pid q16_16 404
one_pole q16_16 200
matrix_inverse_2 q8_24 500
one_pole q8_24 490
one_pole_wide q8_24 600
pid_wide q8_24 250
pid binary32 1000
one_pole binary32 500
matrix_inverse_2 binary32 1000
one_pole_wide binary32 600
pid_wide binary32 1000
""", operations="""
operation format implementation operands cycles_mean
dot2 q16_16 default small 150
dot3 q16_16 default small 200
divide q16_16 default small 1000
dot2 q8_24 default small 200
dot3 q8_24 default small 260
divide q8_24 default small 70
""")
        self.assertEqual(blocks.finding(made), "Building blocks (controllers, filters, tables, matrices, quaternions) that "
                         "take at most 0.4 times float's cycles on inputs in -1..1: 2 of 2 in Q8.8; 1 of 2 in Q16.16 (the "
                         "others up to 0.404, pid; there the products and quotients that the definitions require take 0.15 to "
                         "0.15 by themselves); 0 of 2 in Q8.24 (the others up to 0.98, one pole; there the products and quotients "
                         "that the definitions require take 0.12 to 0.40 by themselves). Outside of that range, sums of products "
                         "in Q8.24 take more. On inputs in -4..4 (rows *_wide), blocks take 0.25 to 1.00 in Q8.24.")

    def test_features(self):
        made = golden(features="""
scene feature with cycles_per_step_mean flash_bytes
lever gravity no 100 1000
lever gravity yes 110 990
lever ropes no 100 1000
lever ropes yes 400 1500
lever rods no 100 1000
lever rods yes 600 1200
lever solver=A yes 9999 9999
lever arithmetic=Nearest yes 2100 3900
everything gravity yes 5 5
everything arithmetic=Nearest yes 5 5
lever by_hand yes 1500 2000
""")
        self.assertEqual(features.finding(made), "Of 3 features the most expensive are rods (+500 cycles a step, +200 bytes "
                         "of flash) and ropes (+300 cycles a step, +500 bytes of flash); the cheapest is gravity (+10 "
                         "cycles a step, -10 bytes of flash). Written by hand, with bit-identical results, the lever's "
                         "step takes 1500 cycles and 2000 bytes. The engine, which also runs other scenes, takes 1.40 times the "
                         "cycles and 1.95 times the flash.")

    def test_a_feature_without_a_row_is_not_passed_over(self):
        rows = """
scene feature with cycles_per_step_mean flash_bytes
lever gravity no 100 1000
lever gravity yes 110 990
lever drag no 100 1000
lever drag yes 400 1500
lever arithmetic=Nearest yes 2100 3900
"""
        with self.assertRaisesRegex(DataError, "features.csv: there is no row with scene = lever, feature = by_hand"):
            features.finding(golden(features=rows))
        with self.assertRaisesRegex(DataError, "no row with .*feature = arithmetic=Nearest, with = yes"):
            scenes_workload.lever_steps(golden(features=rows.replace("Nearest yes", "Nearest no")))

    def test_fast_or_small(self):
        made = golden(features="""
scene feature cycles_per_step_mean flash_bytes
lever gravity 1 1
lever arithmetic=Nearest 2000 3900
lever arithmetic=Small 2500 3890
everything arithmetic=Nearest 40000 18000
everything arithmetic=Small 50400 16500
""", flash="""
operations format implementation flash_bytes
nine q16_16 default 12000
nine q16_16 small 2200
nine q8_24 default 1
own q16_16 small 1
""")
        self.assertIn("the lever takes 1.25 times the cycles and 3890 bytes instead of 3900, a scene with all features takes 1.26 "
                      "times the cycles and 16500 bytes instead of 18000; a program with the nine functions takes 2200 bytes instead "
                      "of 12000.", features.tiers(made))

    def test_saturation(self):
        rows = "scene scalar arithmetic integrator dt cycles_per_step_mean flash_bytes\n"
        for scene, cycles in (("fall", (100, 110, 400)), ("stack", (200, 190, 380))):
            for (scalar, arithmetic), each, flash in zip((("q16_16", "nearest"), ("q16_16", "saturating"), ("float", "avr-libc")),
                                                         cycles, (1000, 1000 + cycles[0], 500)):
                rows += f"{scene} {scalar} {arithmetic} semi_implicit_euler 0.00390625 {each} {flash}\n"
        self.assertEqual(scenes.saturation_finding(golden(scenes=rows)),
                         "In 2 scenes with steps of 1/256 s, saturating Q16.16 takes 0.950 (stack) to 1.100 (fall) times "
                         "the cycles of plain Q16.16 and 0.275 to 0.500 times those of float. Its flash differs from plain Q16.16's "
                         "by +100 to +200 bytes.")

    def test_ablations(self):
        made = golden(ablations="""
ablation case before after before_cycles after_cycles
lead spring_step 2 8 100 110
lead mass 4 4.1 100 80
share small_step 0.5 0.125 100 150
share nothing 0 3 100 900
""")
        self.assertEqual(stability.ablations_finding(made), "Over 2 measures in 3 cases, a measure moves the limit by a factor "
                         "of up to 4 (lead in spring step); in 1 cases it is less than 5 %. It changes the step's cycles by −20 % (lead "
                         "in mass) to +50 % (share in small step).")

    def test_scenarios(self):
        made = golden(haptic="""
scenario arithmetic verdict reason loop_rate_hz step_max_ms worst_lateness_ms cpu_percent stack_bytes
fall_down q16_16 held - 1024.4 0.4 0.2 44 131
fast_dial q16_16 swings too_late 1023.6 0.5 0.3 45 130
fall_down float held - 1 9 9 99 999
""")
        self.assertEqual(lever.scenarios_finding(made), "As flashed, in Q16.16, the lever passes 1 of 2 "
                         "scenarios, not fast dial (too_late), at 1024 steps a "
                         "second or more. A step takes at most 0.50 ms and begins at most 0.30 ms late (scenario \"fast dial\"). The "
                         "processor is busy for at most 45 % of its time, and the stack is at most 131 bytes deep.")

    def test_profile(self):
        made = golden(profile_lever="function self_share\n(asleep) 0.5\n"
                      + "".join(f"f{k} 0.{k}\n" for k in (2, 1)) + "g 0.05\nh 0.04\ni 0.03\n")
        self.assertEqual(lever.profile_finding(made), "The processor sleeps for 50 % of them. Most of the rest goes to `f2` (20.0 %), "
                         "`f1` (10.0 %), `g` (5.0 %), `h` (4.0 %): [the whole profile]"
                         "(data/profile_lever.csv).")

    def test_calibration(self):
        made = golden(calibration_candidates="""
formula fitted_to rms_g leave_one_out_rms_g cycles_mean flash_bytes verdict
line all 99 98 1 2 not_chosen
a+b all 36.25 44.5 326.4 2126 chosen
x/a as_published 41.125 - 714.8 2332 rejected
""")
        for row in made.rows("calibration_candidates"):
            row["fitted_to"] = row["fitted_to"].replace("_", " ")
        self.assertEqual(lever.calibration_finding(made), "The curve chosen is a+b: 36.2 g rms over the readings (44.5 g with each "
                         "reading left out of its own fit), 326 cycles and 2126 bytes. The published x/a, with its coefficients, has "
                         "41.1 g, 715 cycles and 2332 bytes.")

    def test_elementary_functions_are_those_of_the_library(self):
        header = pathlib.Path(__file__).parents[3] / "fixedpoint/src/fixedpoint/portable/elementary_functions.hpp"
        self.assertEqual(list(operations.ELEMENTARY), re.findall(r"^ +X\((\w+), \w", header.read_text(encoding="utf-8"),
                                                                 re.MULTILINE))

    def test_auxiliary_operations_are_those_of_the_table(self):
        table = (pathlib.Path(__file__).parents[3] / "reference/operation_table.h").read_text(encoding="utf-8")
        rows = table.split("#define AUXILIARY_OPERATIONS")[1].split("/* All. */")[0]
        self.assertEqual(list(operations.AUXILIARY), re.findall(r"OPERATION_(\w+)\(", rows))

    def test_elementary_functions_are_told_apart(self):
        made = golden(operations="operation format implementation operands cycles_mean\n" + "".join(
            f"{operation} {kind} physics {cycles}\n" for operation, kind, cycles in (
                ("sqrt", "q16_16 default", 50), ("sqrt", "float libc", 100), ("tan", "q16_16 default", 900),
                ("tan", "float libc", 300), ("pow", "q16_16 default", 400), ("pow", "float libc", 200))))
        self.assertEqual(operations.ratios_to_float(made, "q16_16"), {"sqrt": 0.5})
        self.assertEqual(operations.ratios_to_float(made, "q16_16", elementary=True), {"tan": 3, "pow": 2})
        self.assertIn("pow), as a multiple of float's: 2 to 3 (tan) in Q16.16.",
                      operations.elementary_finding(made))


class Identification(Figures):
    # Half of the range of `friction` is left, all of that of `mass`.
    ROWS = "plant as_published fall_undamped_s fall_damped_s swing_undamped_deg friction mass\n" + "".join(
        f"{plant} {'yes' if plant < 5 else 'no'} 0.19 {0.2 if plant == 1 else 0.4 if plant < 8 else '-'} 3 "
        f"{math.exp(plant % 5 if plant < 5 else plant - 5 if plant < 10 else 8)} {math.exp(8 * (plant % 2))}\n"
        for plant in range(11))

    def test_gravity_alone(self):
        # Gravity only stretches time, as the root of the arm.
        self.assertAlmostEqual(identification.by_gravity(0.2), 0.21565, 4)
        self.assertAlmostEqual(identification.by_gravity(0.8), 2 * 0.21565, 4)

    def test_what_is_narrowed(self):
        found = dict((name, factor) for factor, name in identification.narrowed(golden(identification=self.ROWS)))
        self.assertAlmostEqual(found["mass"], 1)
        self.assertAlmostEqual(found["friction"], 3.6 / 6)

    def test_finding(self):
        made = golden(identification=self.ROWS, stable_changes="arm_m\n0.2\n")
        text = identification.finding(made)
        self.assertIn("on 5 of 11 plants (", text)
        self.assertIn("With the damping 0 of 11 (", text)
        self.assertIn("the fastest in 0.20 s", text)
        self.assertIn("narrow friction most, to 60 %", text)
        as_fast = made.rows("identification")
        as_fast[3]["fall_damped_s"] = 0.18 * 1.09
        self.assertIn("With the damping 1 of 11 (", identification.finding(made))


class Pins(Figures):
    def test_lanes(self):
        rows = "device view pin begin_ms end_ms\n"
        for scale, device in enumerate(haptic_timing.DEVICES, 1):
            rows += f"""{device} frames step 10 {10 + scale}
{device} frames step 60 {60 + 2 * scale}
{device} frames render 20 {20 + scale}
{device} step step 0 {4 * scale}
{device} step collision 1 {1 + scale}
{device} step collision 2 {2 + 2 * scale}
{device} step operation 3 {3 + scale}
"""
        figure = haptic_timing.draw(golden(haptic_pins=rows))
        for scale, (frames, step) in enumerate(zip(figure.axes[::2], figure.axes[1::2]), 1):
            self.assertEqual([spans(lane) for lane in frames.collections],
                             [[(20, scale)], [(10, scale), (60, 2 * scale)]])
            self.assertEqual(texts(frames), [f"1 × {scale} ms", f"2 × {1.5 * scale:.3g} ms"])
            self.assertEqual([spans(lane) for lane in step.collections],
                             [[(3, scale)], [], [(2, 2 * scale)], [(1, scale)], [(0, 4 * scale)]])
            self.assertIn(f"a step of {4 * scale}.00 ms", step.get_title())
            self.assertEqual(step.get_xlim(), (0, 4 * scale))


class Lever(Figures):
    ROWS = """
quantity arithmetic published measured unit verdict reason
loop_step q16_16 - 0.5 ms measured -
loop_step q16_16_arduino - 0.625 ms measured -
loop_step float - 2 ms measured -
flash_bytes q16_16 - 9 bytes measured -
frame q16_16 - 4 ms measured -
frame q16_16_arduino - 5 ms measured -
"""

    def test_devices(self):
        made = golden(workload_firmware=self.ROWS)
        self.assertEqual(lever.devices(made), [("loop_step", "ms", [0.5, 0.625, 2, None]),
                                               ("flash_bytes", "bytes", [9, None, None, None])])

    def test_shares_have_their_interval(self):
        # Wilson's of 12 of 12 at 95%: n / (n + z^2) = 0.7575.
        self.assertEqual(lever.share(12, 12), "12 of 12 (76 to 100 %)")
        self.assertEqual(lever.share(0, 12), "0 of 12 (0 to 24 %)")
        self.assertEqual(lever.share(5, 10), "5 of 10 (24 to 76 %)")

    def test_the_other_levers(self):
        made = golden(haptic="""
scenario arithmetic seconds verdict
hours q16_16 3600 held
hours float 240 held
hours published 240 failed
fall published 3 held
""")
        self.assertEqual(lever.others(made), "The same firmware in float passes 1 of 1 and the rebuilt 2016 "
                         'design 1 of 2. The scenario "hours" simulates 3600 s of ours and 240 s of '
                         "the others.")

    def test_every_published_figure_has_its_verdict(self):
        with open(lever.PUBLISHED, encoding="utf-8") as stream:
            figures = [line.split(",")[:2] for line in stream.read().splitlines()[1:] if line]
        columns = "quantity arithmetic published measured unit verdict reason\n"
        lines = [f"{quantity} {arithmetic} 1 2 ms explained -" for quantity, arithmetic in figures]
        half = len(lines) // 2
        split = golden(workload=columns + "\n".join(lines[half:]) + "\nx y - 2 ms measured -",
                       workload_firmware=columns + "\n".join(lines[:half]))
        told = lever.verdicts(split)
        self.assertEqual([[row["quantity"], row["arithmetic"]] for row in told], figures)
        self.assertEqual([row["measured_in"] for row in told],
                         half * ["whole device"] + (len(lines) - half) * ["engine alone"])
        with self.assertRaisesRegex(DataError, f"no verdict on the published {figures[0][0]}"):
            lever.verdicts(golden(workload=columns + "\n".join(lines[half:]),
                                  workload_firmware=columns + "\n".join(lines[1:half])))


def recording(**changes):
    made = {"signals": {name: [0, 1] for name in replay.SIGNALS},
            "pins": {"step": [], "render": [], "servo": []}, "screens": [{"cells": " " * 400}],
            "arithmetic": "q16_16", "what": "a </script> within", "elf_sha256": "0123456789abcdef",
            "scenario": "bounce"}
    return made | changes


class Replay(Figures):
    def test_a_recording_is_checked(self):
        replay.check(recording())
        signals = recording()["signals"]
        for changes, message in (
                ({"signals": signals | {"more": [0, 1]}}, "signals are not"),
                ({"signals": signals | {"lever": [0]}}, "differ in length"),
                ({"signals": {name: [0] for name in signals}}, "or are empty"),
                ({"pins": {"step": []}}, "pins are not"),
                ({"screens": []}, "20 x 20"),
                ({"screens": [{"cells": " " * 400}, {"cells": " " * 399}]}, "20 x 20")):
            with self.assertRaisesRegex(DataError, message):
                replay.check(recording(**changes))

    def test_the_page_embeds_it(self):
        made = golden()
        made.json = lambda name: recording()
        text = replay.page(report.templates(), made)
        self.assertIn("(Q16.16, SHA-256", text)
        self.assertIn('"what":"a <\\/script> within"', text)
        self.assertIn(">0123456789ab…<", text)


class Style(unittest.TestCase):
    def test_a_figure_does_not_depend_on_the_last_bit_of_its_layout(self):
        def saved(left):
            figure = plt.figure(layout="none")
            figure.add_axes((left, 0.1, 0.8, 0.8)).plot((0, 1), (0, 1), marker="o")
            with tempfile.TemporaryDirectory() as folder:
                style.save(figure, pathlib.Path(folder), "figure")
                return (pathlib.Path(folder) / "figure.svg").read_text(encoding="utf-8")
        made = saved(0.1)
        self.assertEqual(made, saved(math.nextafter(0.1, 1)))
        clips = set(re.findall(r'clip-path="url\(#(\w+)\)"', made))
        self.assertTrue(clips and all(f'<clipPath id="{clip}">' in made for clip in clips))

    def test_every_format_has_a_colour_and_marker_of_its_own(self):
        looks = [row[1:] for row in (*style.FORMATS.values(), style.PUBLISHED)]
        self.assertEqual(len(set(looks)), len(looks))
        self.assertEqual([style.label(*kind) for kind in (
            ("q16_16", "default"), ("q8_24", "saturating"), ("q16_16", "published"), ("float", "libc"),
            ("s16_15", "accum"), ("q5_27", "default"))],
            ["Q16.16", "Q8.24, saturating", "Q16.16, 2016 design", "avr-libc float", "GCC _Accum s16.15",
             "Q5.27"])
        self.assertEqual(style.face("q16_16", "small"), "white")
        self.assertEqual(style.face("q16_16"), style.colour("q16_16"))


class ChooseAFormat(unittest.TestCase):
    def test_bits(self):
        self.assertEqual([choose_a_format.integer_bits(x) for x in (0, 0.99, 1, 1.5, 127.9, 128, 2**31)],
                         [1, 1, 2, 2, 8, 9, 33])
        self.assertEqual([choose_a_format.fraction_bits(x) for x in (2, 1, 0.5, 0.4, 2**-16, 1.5e-5)],
                         [0, 0, 1, 2, 16, 17])

    def test_the_narrowest_type_that_holds_both(self):
        for largest, step, name in ((7.9, 1 / 16, "Q4_4"), (8, 1 / 16, "Q8_8"), (100, 1 / 256, "Q8_8"),
                                    (1, 0.0001, "Fixed<2, 14>"), (200, 0.004, "Q12_12"),
                                    (127, 2**-16, "Q8_16"), (128, 2**-12, "Q12_12"), (100, 2**-12, "Q8_16"),
                                    (200, 2**-13, "Fixed<9, 15>"), (2000, 2**-14, "Q16_16"), (100, 1e-7, "Fixed<8, 24>"), (1e5, 0.001, "Fixed<18, 14>"),
                                    (2e9, 1, "Fixed<32, 0>"), (3e7, 1e-6, "Q32_32")):
            self.assertEqual(choose_a_format.choose(largest, step).name, name)
        self.assertEqual(choose_a_format.choose(127, 2**-16).measured, "q8_16")
        self.assertIsNone(choose_a_format.choose(200, 2**-13).measured)
        with self.assertRaisesRegex(DataError, "35 integer bits and 34 fraction bits"):
            choose_a_format.choose(1e10, 1e-10)

    def test_the_lever_of_the_firmware(self):
        """Its type is read from the firmware; the weights have to explain it."""
        self.assertEqual(choose_a_format.choose(*choose_a_format.ARM).name, "Q8_16")
        self.assertEqual(choose_a_format.why_the_firmware_differs(golden(calibration="adc_reading device_g\n0 76.7\n950 1458.1\n1 2\n")),
                         "The firmware's lever has this arm in `Q16_16`, not in `Q8_16`, because its one number type also holds the "
                         "weights on the force sensors. On the chip they reach 1458 g, which takes 12 integer bits and, with the 15 "
                         "fraction bits of the arm, more than 24 bits.")
        for grams in (255, 40000):  # 9 + 15 fit 24 bits; 17 + 15 have no name
            with self.assertRaisesRegex(DataError, f"up to {grams} g do not explain why the firmware uses Q16_16, not Q8_16"):
                choose_a_format.why_the_firmware_differs(golden(calibration=f"adc_reading device_g\n950 {grams}\n"))

    def test_the_types_are_those_of_the_library(self):
        self.assertEqual([each.name for each in choose_a_format.MEASURED.values()],
                         ["Q4_4", "Q8_8", "Q8_16", "Q12_12", "Q16_16", "Fixed<8, 24>", "Q32_32"])
        self.assertEqual(choose_a_format.WIDTHS, [8, 16, 24, 32, 64])
        # Each width that is measured has a type of its name, and each of these types is measured.
        self.assertEqual({each.width for each in choose_a_format.NAMED}, set(choose_a_format.WIDTHS))
        self.assertNotIn(None, [each.measured for each in choose_a_format.NAMED])

    def test_limits(self):
        q8_8 = choose_a_format.Format(8, 8)
        self.assertAlmostEqual(q8_8.square_overflows_from**2, 128)
        self.assertAlmostEqual(q8_8.square_vanishes_below**2, 1 / 512)
        self.assertEqual(q8_8.stands_still_below(1000), 1000 / 512)

    def test_cost(self):
        made = golden(operations=OPERATIONS)
        self.assertEqual([choose_a_format.cost(made, "add", name) for name in ("q16_16", "float", "q4_4")],
                         ["10 (99)", "100 (112)", "–"])
        self.assertEqual(choose_a_format.cost(made, "add", "q16_16", "small"), "70 (90)")


class Cells(Figures):
    def test_cells(self):
        self.assertEqual([report.cell(x) for x in (None, 1.23456, 999.96, 1000.4, -0.00012346, 7, "a|b")],
                         ["–", "1.235", "1000", "1000", "-0.0001235", "7", "a\\|b"])

    def test_a_gap_on_a_page_is_an_error(self):
        environment = report.templates()
        for template in ("{{ row.value }}", "a {{ 'x ' ~ row.value }}", "{{ number }}"):
            with self.assertRaises(DataError):
                environment.loader.get_source = lambda _, name, text=template: (text, None, None)
                environment.cache.clear()
                report.page(environment, "page", {"row": {"value": None}, "number": float("nan")})
        environment.loader.get_source = lambda _, name: ("{{ row.value | cell }}", None, None)
        environment.cache.clear()
        self.assertEqual(report.page(environment, "page", {"row": {"value": None}}), "–")


class Damage(Figures):
    """What is wrong with a file is told in a line, with exit status 1."""

    GOOD = "operation,format,cycles_max,loops\nadd,q8_8,9,1\nadd,q16_16,,2\n"
    HEADERS = [{"loops": "text"},
               {"operation": "text", "format": "text", "cycles_max": "optional", "loops": "number"}]

    def told(self, content, headers=HEADERS):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "data"
            path.mkdir()
            (path / "operations.csv").write_bytes(content)
            if headers is not None:
                report.write_columns(path, headers)
            errors = io.StringIO()
            arguments, sys.argv = sys.argv, ["report.py", "--results", folder]
            try:
                with contextlib.redirect_stderr(errors):
                    status = report.main()
            finally:
                sys.argv = arguments
            self.assertEqual(status, 1)
            self.assertNotIn("Traceback", errors.getvalue())
            *_, line = errors.getvalue().strip().splitlines()
            return line.replace(str(path) + "/", "")

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "operations.csv"
            path.write_text(self.GOOD, encoding="utf-8")
            report.write_columns(pathlib.Path(folder), self.HEADERS)
            rows = Data(folder).rows("operations")
            self.assertEqual([dict(row) for row in rows],
                             [{"operation": "add", "format": "q8_8", "cycles_max": 9, "loops": 1},
                              {"operation": "add", "format": "q16_16", "cycles_max": None, "loops": 2}])
            self.assertEqual(len(Data(folder).rows("operations", format="q16_16", loops=2)), 1)
            with self.assertRaisesRegex(DataError, "no column 'cost'"):
                rows[0]["cost"]

    def test_damage(self):
        good = self.GOOD.encode()
        for content, message in (
                (b"", "operations.csv: is empty"),
                (good.splitlines()[0] + b"\n", "operations.csv: has no rows"),
                (good[:-6], "operations.csv, row 3: 2 cells under 4 columns"),
                (good + b"add,q8_8,1,2,3\n", "operations.csv, row 4: 5 cells under 4 columns"),
                (good.replace(b",9,1", b",9,"), "row 2, column loops: the number is missing"),
                (good.replace(b",9,1", b",nan,1"), "row 2, column cycles_max: 'nan' is not a number"),
                (good.replace(b",9,1", b",9,nan"), "row 2, column loops: 'nan' is not a number"),
                (good.replace(b",9,1", b",9,1_0"), "row 2, column loops: '1_0' is not a number"),
                (good.replace(b",9,1", b",9, 1"), "row 2, column loops: ' 1' is not a number"),
                (good.replace(b",9,1", b",9,one"), "row 2, column loops: 'one' is not a number"),
                (good.replace(b"cycles_max,loops", b"loops,cycles_max"),
                 "operations.csv and columns.json disagree: column 3 is 'loops' in operations.csv and 'cycles_max' in columns.json"),
                (good.replace(b"loops", b"turns"), "operations.csv and columns.json disagree: columns.json lacks column 'turns', "
                 "operations.csv lacks column 'loops'; `fixbench report` writes columns.json"),
                (b"cost\n1\n", "operations.csv and columns.json disagree: columns.json has no record with column 'cost'"),
                (good.replace(b",9,1", b",9 1,1"), "row 2, column cycles_max: '9 1' is not a number"),
                (good.replace(b"add,q8", b"\xff\xfe"), "operations.csv: 'utf-8' codec"),
                (good, "operations.csv: there is no column 'implementation'")):
            told = self.told(content)
            self.assertTrue(told.startswith("report: "), told)
            self.assertIn(message, told)

    def test_a_fault_of_columns_json_names_the_column_and_both_commands(self):
        """Whichever of the two files is wrong."""
        lacking = [self.HEADERS[0], {key: self.HEADERS[1][key] for key in ("operation", "format", "cycles_max")}]
        self.assertIn("operations.csv and columns.json disagree: columns.json lacks column 'loops'",
                      self.told(self.GOOD.encode(), headers=lacking))
        experiments = [{"command": "fixbench cycles", "writes": ["operations.csv"], "full_only": []}]
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "operations.csv").write_text(self.GOOD, encoding="utf-8")
            report.write_columns(pathlib.Path(folder), lacking)
            with self.assertRaisesRegex(DataError, "`fixbench cycles` writes operations.csv, `fixbench report` writes columns.json"):
                Data(folder, experiments).rows("operations")
        for wrong, message in (
                ([{"loops": "numbr"}], "columns.json: column 'loops' holds 'numbr', and allowed are text, number, optional"),
                ([["loops"]], "columns.json: is not a list of records, each of which has for every column what it holds"),
                ({"loops": "text"}, "columns.json: is not a list of records")):
            with tempfile.TemporaryDirectory() as folder:
                (pathlib.Path(folder) / "columns.json").write_text(json.dumps(wrong), encoding="utf-8")
                with self.assertRaises(DataError) as raised:
                    self.assertIsNone(Data(folder).headers)
                self.assertIn(message, str(raised.exception))
                self.assertIn("`fixbench report` writes it", str(raised.exception))

    def checked(self, stored):
        """What --check says of a columns.json with this text, next to operations.csv and nothing else."""
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch("report.figures", return_value={}), \
                unittest.mock.patch("report.PAGES", {}):
            data = pathlib.Path(folder) / "data"
            data.mkdir()
            (data / "tools.json").write_text("{}", encoding="utf-8")
            (data / "loops.csv").write_text("operation,format,cycles_max,loops\nadd,q8_8,9,1\n", encoding="utf-8")
            if stored is not None:
                (data / "columns.json").write_text(stored, encoding="utf-8")
            with unittest.mock.patch("sys.argv", ["report.py", "--results", folder, "--check", "--columns", json.dumps(self.HEADERS)]), \
                    contextlib.redirect_stderr(io.StringIO()) as told:
                status = report.main()
            lines = [line for line in told.getvalue().splitlines() if line.startswith("report: ")]  # not the progress
            self.assertEqual((status, len(lines)), (1, 1) if lines else (0, 0))
            return "".join(lines).replace(folder + "/", "")

    def test_the_check_names_the_column_that_differs_from_the_programs(self):
        def text(*headers):
            return "[\n" + ",\n".join(map(json.dumps, headers)) + "\n]\n"
        first, second = self.HEADERS
        self.assertEqual(self.checked(text(first, second)), "")
        for stored, message in (
                (text(first, {**second, "loops": "text"}), "of loops.csv, column 'loops' holds text, and number in fixbench"),
                (text(first, dict(list(second.items())[:-1])), "of loops.csv, column 'loops' of fixbench is missing"),
                (text(first, {**second, "turns": "text"}), "of loops.csv, column 'turns' is not in fixbench"),
                (text(first, dict(reversed(second.items()))), "of loops.csv, column 1 is 'loops', and 'operation' in fixbench"),
                (text(second), "the record of fixbench with column 'loops' is missing"),
                (text(first, second, {"a": "text", "b": "text"}), "no record of fixbench has the columns a, b"),
                (text(second, first), "is not in the order of fixbench"),
                ("[", "data/columns.json: Expecting value"),
                (None, "data/columns.json is missing")):
            told = self.checked(stored)
            self.assertTrue(told.startswith("report: data/columns.json"), told)
            self.assertIn(message, told)
            self.assertTrue(told.endswith("; `fixbench report` writes it"), told)
            self.assertNotIn("from the data", told)

    def test_without_columns_nothing_is_read(self):
        self.assertIn("columns.json is missing; `fixbench report` writes it", self.told(self.GOOD.encode(), headers=None))

    def test_columns_follow_from_the_headers_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch("report.figures", return_value={}), \
                unittest.mock.patch("report.PAGES", {}):
            results = pathlib.Path(folder)
            (results / "data").mkdir()
            (results / "data" / "tools.json").write_text("{}", encoding="utf-8")
            report.write(results, headers=self.HEADERS)
            self.assertEqual(Data(results / "data").headers, self.HEADERS)
            self.assertEqual(report.differences(results, headers=self.HEADERS), [])
            self.assertEqual(report.differences(results, headers=self.HEADERS[:1]), [pathlib.Path("data/columns.json")])
            # Without those of the program, the pages are checked alone.
            self.assertEqual(report.differences(results), [])

    def test_a_missing_file_names_the_command(self):
        experiments = [{"command": "fixbench scenes", "writes": ["scenes.csv"], "full_only": []}]
        with self.assertRaisesRegex(DataError, "missing; `fixbench scenes` writes it"):
            Data("/nonexistent", experiments).rows("scenes")
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "replay.json").write_text('{"a": [1,', encoding="utf-8")
            with self.assertRaisesRegex(DataError, "replay.json.* column"):
                Data(folder).json("replay")


if __name__ == "__main__":
    unittest.main()
