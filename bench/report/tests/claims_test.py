#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages on the committed data: what they claim is computed here once more, from the CSV files and
without the report's own code. Usage: claims_test.py RESULTS"""

import csv
import functools
import math
import pathlib
import re
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import catalogue  # noqa: E402
import report  # noqa: E402
import table_3_2  # noqa: E402
from data import Data  # noqa: E402

RESULTS = pathlib.Path(sys.argv.pop() if len(sys.argv) > 1 else pathlib.Path(__file__).parents[3] / "results")


@functools.lru_cache(maxsize=None)
def table(name):
    with open(RESULTS / "data" / f"{name}.csv", newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def rows(name, **wanted):
    """Rows of a data file as they stand there, all cells text."""
    return [row for row in table(name) if all(row[key] == value for key, value in wanted.items())]


def largest(column, **what):
    """The largest number of a column over every run of the operation."""
    return max(float(row[column]) for name in ("operations", "accuracy", "exhaustive")
               for row in rows(name, **what) if row.get(column))


class Claims(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "data").symlink_to((RESULTS / "data").resolve())
            report.write_pages(pathlib.Path(folder), Data(RESULTS / "data"))
            cls.pages = {path.name: path.read_text(encoding="utf-8") for path in pathlib.Path(folder).glob("*.md")}
        cls.words = {name: " ".join(text.split()) for name, text in cls.pages.items()}

    def says(self, page, text):
        self.assertIn(text, self.words[page])

    def table(self, page, heading):
        """The rows below the line of a page that begins so, cells as text."""
        _, _, below = self.pages[page].partition("\n" + heading)
        lines = below.splitlines()[2:]
        return [[cell.strip() for cell in line.strip("|").split("|")]
                for line in lines[:next(k for k, line in enumerate(lines) if not line.startswith("|"))]]

    def test_every_file_has_the_columns_of_a_record(self):
        data = Data(RESULTS / "data")
        for path in (RESULTS / "data").glob("*.csv"):
            if path.name != "bounds.csv":  # the report's own
                self.assertEqual(len(data.rows(path.stem)), len(table(path.stem)))

    def test_the_rows_of_a_table_are_as_long_as_its_heading(self):
        for page, text in self.pages.items():
            heading = None
            for line in text.splitlines():
                cells = len(re.findall(r"(?<!\\)\|", line)) if line.startswith("|") else None
                self.assertTrue(None in (heading, cells) or cells == heading, f"{page}: {line}")
                heading = cells

    def test_the_pages_are_short(self):
        self.assertEqual(len(self.pages), len(report.PAGES))
        self.assertLessEqual(sum(len(text.splitlines()) for text in self.pages.values()), 500)

    def test_programs_of_several_operations_are_of_formats_and_implementations_that_exist(self):
        known = {(row["format"], row["implementation"]) for row in rows("operations")}
        for row in rows("flash"):
            self.assertIn((row["format"], row["implementation"]), known)

    def test_the_first_screen_of_the_project_has_measured_figures(self):
        readme = (RESULTS.parent / "README.md").read_text(encoding="utf-8")

        def tells(text):
            self.assertTrue(text in " ".join(readme.split()), f"README.md has to say '{text}'")
        names = ("add", "multiply", "divide", "sqrt", "sin", "atan2")
        tells(f"| mean cycles | {' | '.join(names)} |")
        for label, number_format, implementation in (("avr-libc float", "float", "libc"), ("Q16.16, design of 2016", "q16_16", "published"),
                                                     ("Q16.16, this library", "q16_16", "default")):
            mean = {row["operation"]: f"{float(row['cycles_mean']):.0f}" for row in rows(
                "operations", format=number_format, implementation=implementation, operands="physics")}
            tells(f"| {label} | {' | '.join(mean.get(name, '–') for name in names)} |")
        tells(f"{sum(row['operands'] == 'all' for row in rows('exhaustive'))} functions ran over all of their inputs")
        self.assertEqual({row["violations"] for row in rows("exhaustive")}, {"0"})
        self.assertEqual({row["mismatches"] for row in rows("kernels")}, {"0"})

    def test_the_library_says_what_three_bytes_cost(self):
        readme = (RESULTS.parent / "fixedpoint" / "README.md").read_text(encoding="utf-8")
        names = ("add", "multiply", "dot3", "divide", "sqrt", "sin", "atan2")
        self.assertIn(f"| | {' | '.join(names)} |", readme)
        for label, number_format, implementation in (("Q8.16", "q8_16", "default"), ("Q12.12", "q12_12", "default"),
                                                     ("Q16.16", "q16_16", "default"), ("avr-libc float", "float", "libc")):
            mean = {row["operation"]: f"{float(row['cycles_mean']):.0f}" for row in rows(
                "operations", format=number_format, implementation=implementation, operands="physics")}
            self.assertIn(f"| {label} | {' | '.join(mean.get(name, '–') for name in names)} |", readme)

    def test_table_3_2_names_its_hypothesis_and_the_baseline(self):
        hypotheses = rows("table_3_2_hypotheses")
        used, = (row for row in hypotheses if row["measured_with"] == "yes")
        self.says("README.md", f"{len(hypotheses)} hypotheses")
        self.says("README.md", f"the hypothesis of rank {used['rank']} ")
        self.says("README.md", f"within 10% in {used['within_10_percent']} of the {len(rows('table_3_2'))} rows")
        mean = sum(int(row["within_10_percent"]) for row in hypotheses) / len(hypotheses)
        self.says("README.md", f"an average hypothesis does so in {mean:.4g}")

    def test_table_3_2_counts_are_of_what_they_say(self):
        with open(RESULTS.parent / "reference/published/table_3_2.csv", newline="", encoding="utf-8") as stream:
            cells = sum(len(row) - 1 for row in list(csv.reader(stream))[1:])
        measured = rows("table_3_2")
        labels = [text.get_text() for text in table_3_2.draw(Data(RESULTS / "data")).axes[0].get_legend().texts]
        for verdict, counts in (label.split(": ") for label in labels if ":" in label):
            self.assertEqual(counts, " + ".join(str(sum(row["verdict"] == verdict for row in part))
                                                for part in (measured[:cells], measured[cells:])))
        of = {verdict: sum(row["verdict"] == verdict for row in measured[:cells])
              for verdict in ("reproduced", "explained", "not reproducible")}
        self.assertEqual(sum(of.values()), cells)
        self.says("README.md", f"Of the table's {cells} cells, this one hypothesis reproduces {of['reproduced']}; another hypothesis "
                               f"explains {of['explained']} more, and none explains the other {of['not reproducible']}")

    def test_explained_names_a_measured_cause_and_the_odds(self):
        for row in rows("table_3_2", verdict="explained"):
            measured, deviation, fit, tried = re.match(
                r"(\d+) ms \(([-+][\d.]+)%\) with .*?; (\d+) of (\d+) alternatives come within 10%", row["reason"]).groups()
            self.assertLessEqual(abs(float(deviation)), 10)
            self.assertAlmostEqual(100 * (int(measured) / float(row["published_ms"]) - 1), float(deviation), delta=0.5)
            self.assertTrue(0 < int(fit) <= int(tried))
        for name in ("workload", "workload_firmware"):
            for row in rows(name, verdict="explained"):
                self.assertRegex(row["reason"], r"\d", row["quantity"])

    def test_what_ran_over_all_inputs(self):
        exact = [int(row["inputs"]) for row in rows("exhaustive", operands="all")]
        self.assertLessEqual(set(exact), {2**16, 2**24, 2**32})
        self.says("README.md", f"{len(exact)} functions ran over all their inputs as translated machine code, {exact.count(2**32)} of "
                               "them over 2^32")

    def test_the_division_has_its_costs_by_operands(self):
        mean = {row["implementation"]: float(row["cycles_mean"]) / 16 for row in rows("operations", operation="divide", operands="physics")
                if row["format"] in ("q16_16", "float") and row["implementation"] in ("published", "libc", "default")}
        engine, = rows("workload", quantity="divide")
        self.says("README.md", f"a division takes {mean['published']:.0f} µs in the 2016 design, {mean['libc']:.0f} µs in float and "
                               f"{mean['default']:.1f} µs in ours. Within the rebuilt engine of 2016 it takes "
                               f"{float(engine['measured']):.0f} µs on average; {float(engine['published']):.0f} µs were published")

    def test_means_are_over_the_domain(self):
        # Operands that leave early, the negative ones, are not among them.
        for operation in ("sqrt", "reciprocal_sqrt", "log"):
            for row in rows("operations", operation=operation, operands="physics", implementation="default"):
                self.assertEqual(row["samples"], row["regular"], (operation, row["format"]))
        # The error of exp is that of rounded results, near the 0.29 ulp of rounding: what saturates is not among them.
        for row in rows("operations", operation="exp", operands="physics", implementation="default"):
            self.assertTrue(0.2 < float(row["rms_ulp"]) < 0.4, row["format"])

    def test_no_table_shows_less_than_the_largest_that_is_known(self):
        kinds = [*((name, "default") for name in catalogue.FORMATS), ("float", "libc")]
        shown = 0
        for operation, *cells in self.table("choose_a_format.md", "| operation |"):
            if not all("(" in cell for cell in cells):
                continue
            for (number_format, implementation), cell in zip(kinds, cells):
                what = {"operation": operation, "format": number_format, "implementation": implementation}
                self.assertEqual(int(re.search(r"\((\d+)\)", cell).group(1)), largest("cycles_max", **what), what)
                shown += 1
        self.assertEqual(shown, 9 * len(kinds))
        for line in self.table("README.md", "| format | largest |")[:len(catalogue.FORMATS)]:
            ulp, operation = re.match(r"([\d.]+) \((\w+)\)", line[3]).groups()
            number_format = line[0].lower().replace(".", "_")
            every = {row["operation"] for row in rows("operations", format=number_format, implementation="default")}
            known = {each: largest("max_ulp", operation=each, format=number_format, implementation="default") for each in every}
            self.assertEqual(known[operation], max(known.values()), "one of the largest")
            self.assertAlmostEqual(known[operation], float(ulp), 3)

    def test_where_float_errs_without_a_right_digit(self):
        lost = 0
        names = {row["operation"] for row in rows("operations", format="float", implementation="libc")}
        for name in names:
            lost += largest("max_ulp", operation=name, format="float", implementation="libc") >= 2**23
        self.says("README.md", f"*no digit* in {lost} of {len(names)} |")

    def test_where_ours_costs_more_than_float(self):
        for line in self.table("README.md", "| format | largest |")[:len(catalogue.FORMATS)]:
            number_format = line[0].lower().replace(".", "_")
            of_float = {row["operation"]: float(row["cycles_mean"]) for row in
                        rows("operations", format="float", implementation="libc", operands="physics")}
            ratios = sorted((float(row["cycles_mean"]) / of_float[row["operation"]] for row in
                             rows("operations", format=number_format, implementation="default", operands="physics")
                             if row["operation"] in of_float), reverse=True)
            slower = [ratio for ratio in ratios if ratio > 1]
            if slower:
                told = [float(ratio) for ratio in re.findall(r"([\d.]+) times", line[-1])]
                self.assertEqual([f"{ratio:.3g}" for ratio in slower[:2]], [f"{ratio:.3g}" for ratio in told])
                self.assertEqual(f"and {len(slower) - 2} more" in line[-1], len(slower) > 2)
            else:
                self.assertEqual(line[-1], f"none of {len(ratios)} takes more cycles than float")

    def test_bounds_are_those_of_all_runs(self):
        def kind(row):
            return row["operation"], row["format"], row["implementation"]

        runs = [(kind(row), row) for name in ("operations", "exhaustive") for row in rows(name)]
        judged = runs + [(kind(row), row) for row in rows("accuracy")]
        bounds = rows("bounds")
        self.assertEqual([kind(row) for row in bounds], list(dict.fromkeys(kind(row) for row in rows("operations"))))
        tests = "".join((RESULTS.parent / room / "CMakeLists.txt").read_text(encoding="utf-8")
                        for room in ("fixedpoint", "bench/experiments/exhaustive"))
        for row in bounds:
            mine = [run for which, run in runs if which == kind(row)]
            self.assertEqual(int(row["cycles_max"]), max(int(run["cycles_max"]) for run in mine), row)
            self.assertEqual(row["cycles_bound"] == "exact", any(run["operands"] == "all" for run in mine), row)
            errors = [run for which, run in judged if which == kind(row) and run["max_ulp"]]
            if errors:
                self.assertGreaterEqual(float(row["max_ulp"]), max(float(run["max_ulp"]) for run in errors), row)
            if row["proof"]:
                self.assertIn(f"test_command({row['proof']}", tests)
            elif row["bound"] == "exact" and row["implementation"] == "default":
                self.assertTrue(any(run["operands"] == "all" for run in errors), row)
            # What is exact by a proof calls others that are.
            self.assertEqual(row["bound"].startswith("proven"), bool(row["proof"]) and row["bound"] != "exact", row)

    def test_reasons_of_floats_leads_follow_from_the_errors(self):
        runs = [(row["scene"], row["scalar"] == "float", float(row["cycles_per_simulated_second"]),
                 max(float(row["error_method"]), float(row["error_arithmetic"]))) for row in rows("scenes", verdict="held")
                if row["error_method"] and row["cycles_per_simulated_second"] and row["arithmetic"] != "published"]
        led = {scene for scene, is_float, cost, error in runs if is_float and not any(
            theirs == scene and not other_is_float and paid <= cost and reached <= 1.05 * error
            for theirs, other_is_float, paid, reached in runs)}
        if not led:
            self.assertNotIn("| scene | float |", self.pages["engine.md"])
            return
        told = self.table("engine.md", "| scene | float |")
        self.assertTrue(told)
        for scene, _, _, error, ours, why in told:
            rivals = [row for row in rows("scenes", scene=scene.replace(" ", "_"), verdict="held") if row["error_method"]
                      and row["arithmetic"] in ("nearest", "saturating")
                      and math.isclose(max(float(row["error_method"]), float(row["error_arithmetic"])), float(ours), rel_tol=1e-3)]
            self.assertTrue(rivals, scene)
            by_arithmetic = all(float(row["error_arithmetic"]) > float(row["error_method"]) for row in rivals)
            self.assertEqual("errs by its resolution" in why, by_arithmetic, scene)
            self.assertEqual("pays for" in why, not by_arithmetic, scene)
            self.assertLess(float(error), float(ours))

    def test_the_share_by_mass_costs_what_the_engine_says(self):
        quotient, = rows("operations", operation="divide", format="q16_16", implementation="small", operands="physics")
        step, = rows("features", scene="chain", feature="solver=ProjectedGaussSeidel<10>")
        cycles = float(quotient["cycles_mean"])
        readme = " ".join((RESULTS.parent / "engine/README.md").read_text(encoding="utf-8").split())
        self.assertIn(f"{cycles:.0f} cycles in Q16.16 (results/data/operations.csv), "
                      f"{100 * cycles / float(step['cycles_per_step_mean']):.0f}% of a step of two rods (features.csv)", readme)

    def test_the_broad_phases_of_the_levers_scene_are_told(self):
        cost = {row["feature"]: float(row["cycles_per_step_mean"]) for row in rows("features", scene="lever")
                if row["feature"].startswith("broad_phase=")}
        self.says("engine.md", f"sort and sweep takes {cost['broad_phase=SortAndSweep']:.0f} cycles a step and every pair "
                               f"{cost['broad_phase=BruteForce']:.0f}")

    def test_compensated_integration_is_on_the_fronts_that_the_page_counts(self):
        front = {}
        for row in rows("scenes", verdict="held"):
            if row["error"] and row["cycles_per_simulated_second"]:
                front.setdefault(row["scene"], []).append(
                    (float(row["cycles_per_simulated_second"]), max(float(row["error_method"]), float(row["error_arithmetic"])),
                     row["scalar"], row["arithmetic"]))
        for scalar, name in (("q8_8", "Q8.8"), ("q16_16", "Q16.16")):
            on = sum(any((of, arithmetic) == (scalar, "compensated") and not any(
                paid <= cost and reached <= error and (paid, reached) != (cost, error) for paid, reached, *_ in runs)
                for cost, error, of, arithmetic in runs) for runs in front.values())
            told = re.search(rf"in {re.escape(name)} it takes .*?it is on (\d+) fronts", self.words["engine.md"])
            self.assertEqual(int(told.group(1)), on, name)

    def test_sort_and_sweep_is_cheaper_from_there_on(self):
        cost = {(row["broad_phase"], int(row["particles"])): float(row["cost_per_step"]) for row in rows("growth")}
        first = int(re.search(r"sort and sweep is cheaper from (\d+) particles upwards on the chip", self.words["engine.md"]).group(1))
        counts = sorted(count for phase, count in cost if phase == "sort_and_sweep")
        cheaper = {count: cost["sort_and_sweep", count] < cost["brute_force", count] for count in counts}
        self.assertTrue(all(cheaper[count] for count in counts if count >= first))
        self.assertFalse(cheaper[max(count for count in counts if count < first)])

    def test_nothing_is_missing_on_a_page(self):
        for name, text in self.pages.items():
            self.assertIsNone(re.search(r"\b(None|nan|NaN|Undefined)\b", text), name)

    def test_the_rounded_sensor_curve_is_told(self):
        rounded, = (row for row in rows("calibration_verdicts") if not row["coefficient"])
        self.assertGreater(float(rounded["largest_distance_g"]), 1e4)
        self.says("lever.md", f"an error of up to {float(rounded['largest_distance_g']):.0f} g, {rounded['verdict']}")

    def test_counts_and_ends_of_the_stability_search(self):
        found = rows("stability")
        self.says("stability.md", f"{len({row['case'] for row in found})} cases in {len({row['scalar'] for row in found})} number formats")
        by_gsl = {row["case"] for row in found if row["reference"].startswith("GSL")}
        self.says("stability.md", f"in {len(by_gsl)} cases, GSL's integrators")
        ended = {row["quantity"] for row in rows("envelope", integrator="semi_implicit_euler", scalar="float", arithmetic="ieee")
                 if row["limited_by"].startswith("stable")}
        for quantity, _, *cells in self.table("stability.md", "| quantity | unit |"):
            self.assertEqual(cells[-1].startswith("beyond"), quantity in ended, quantity)

    def test_steps_are_what_they_are_called(self):
        for name, text in self.words.items():
            self.assertNotRegex(text, r"\b[14] ms steps", name)  # they take 1/1024 s and 1/256 s

    def test_each_methods_bound_is_where_float_breaks(self):
        for method, product in (("semi_implicit_euler", 4), ("velocity_verlet", 4), ("explicit_euler", 50**(2 / 300) - 1)):
            told = [float(row["limit"]) * float(row["x"])**2 for row in rows(
                "stability_map", map="stiffness_upper", scalar="float", integrator=method) if row["limit"] != "none"]
            self.assertGreater(len(told), 8)
            for found in told:
                self.assertAlmostEqual(found / product, 1, delta=0.05, msg=method)
        self.assertTrue(all(row["limited_by"] == "stable" for row in rows(
            "stability_map", map="stiffness_upper", scalar="float", integrator="implicit_springs")))

    def test_durations_are_shown(self):
        seconds = {row["arithmetic"]: float(row["seconds"]) for row in rows("haptic", scenario="hours")}
        others = {seconds[name] for name in seconds if name != "q16_16"}
        self.assertEqual(len(others), 1)
        self.says("lever.md", f"simulates {seconds['q16_16']:.0f} s of ours and {others.pop():.0f} s of the others")

    def test_every_published_figure_has_its_verdict(self):
        told = {(line[0].replace(" ", "_"), line[1]): line[6] for line in self.table("lever.md", "| quantity | arithmetic |")}
        with open(RESULTS.parent / "reference/published/workload.csv", newline="", encoding="utf-8") as stream:
            for row in csv.DictReader(stream):
                self.assertIn((row["quantity"], row["arithmetic"]), told)
        self.assertIn("fall_time", {quantity for quantity, _ in told})
        self.assertLessEqual(set(told.values()), {"reproduced", "explained", "cause named", "not reproducible"})

    def test_a_step_of_the_lever_says_what_sets_it_apart(self):
        told = self.table("engine.md", "| format | `fixbench` |")
        self.assertEqual(len({tuple(line[:3]) for line in told}), len(told))
        feature, = rows("features", scene="lever", feature="arithmetic=Nearest", **{"with": "yes"})
        self.assertEqual([line[3:] for line in told if line[1] == "features"],
                         [[f"{float(feature['cycles_per_step_mean']):.0f}", feature["flash_bytes"]]])
        scene = {row["scalar"]: row for row in rows("scenes", scene="lever", integrator="semi_implicit_euler", dt="0.00390625")
                 if row["arithmetic"] in ("nearest", "avr-libc")}
        for line in (line for line in told if line[1] == "scenes"):
            row = scene[line[0].lower().replace(".", "_")]
            self.assertEqual(line[3:], [f"{float(row['cycles_per_step_mean']):.0f}", row["flash_bytes"]])

    def test_the_hash_that_counts_is_that_of_the_kernel(self):
        sampled = {(row["operation"], row["format"], row["implementation"]): row["kernel_sha256"] for row in rows("operations")}
        whole = rows("exhaustive")
        self.assertTrue(whole)
        for row in whole:
            self.assertEqual(row["kernel_sha256"], sampled[row["operation"], row["format"], row["implementation"]])

    def test_runs_rank_by_the_larger_error(self):
        steps = {}
        for row in rows("scenes", verdict="held"):
            if row["cycles_per_simulated_second"] and row["error"]:
                steps.setdefault(row["scene"].replace("_", " "), []).append(
                    (max(float(row["error_method"]), float(row["error_arithmetic"])), float(row["cycles_per_simulated_second"])))
        told = self.table("engine.md", "| scene | 1 cm |")
        self.assertEqual({line[0] for line in told}, set(steps))
        for scene, *cells in told:
            for target, cell in zip((1e-2, 1e-3, 1e-4, 1e-5), cells):
                fit = [cycles for error, cycles in steps[scene] if error <= target]
                self.assertEqual(cell, "–") if not fit else self.assertAlmostEqual(
                    float(cell.rsplit(": ", 1)[1]) * 1e6 / min(fit), 1, 3)

    def test_what_is_stable_stands_on_the_page(self):
        for term in ("tolerance of the case", "horizon", "bisection"):
            self.says("stability.md", term)


if __name__ == "__main__":
    unittest.main()
