#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the library takes of flash and RAM: nothing that a program does not use.
Usage: footprint_test.py FOLDER_OF_THE_DEVICE_PROGRAMS"""

import csv
import subprocess
import sys
import unittest
from pathlib import Path

FOLDER = Path(sys.argv.pop())
LIBRARY = ["q4_4", "q8_8", "q16_16", "q32_32"]
# The largest flash in bytes of the small functions of Q16.16, alone and of nine together.
SMALL = {"divide": 284, "sqrt": 298, "reciprocal_sqrt": 324, "sin": 266, "cos": 270, "sincos": 330, "atan": 328, "atan2": 328,
         "exp": 432, "log": 248, "nine": 2048}


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def data_in_flash(program):
    """The names of the tables that a program reads from program memory."""
    symbols = map(str.split, run("avr-readelf", "-sW", FOLDER / f"{program}.elf").splitlines())
    return {symbol[7] for symbol in symbols
            if len(symbol) == 8 and symbol[3] == "OBJECT" and int(symbol[1], 16) < 0x800000}


def flash_bytes(program):
    text, data = run("avr-size", FOLDER / f"{program}.elf").splitlines()[1].split()[:2]
    return int(text) + int(data)


def footprints(program):
    with open(FOLDER / f"{program}.footprints.csv", encoding="ascii") as stream:
        return {row["subject"]: row for row in csv.DictReader(stream)}


class Footprint(unittest.TestCase):
    def test_multiplication_alone_links_no_table(self):
        self.assertEqual(data_in_flash("multiply_footprint"), set())

    def test_all_functions_of_angles_fit_six_kilobytes(self):
        self.assertLessEqual({"fixedpoint_sine_table", "fixedpoint_arctangent_table"},
                             data_in_flash("angles_footprint"))
        # Both contain the start-up code.
        self.assertLessEqual(flash_bytes("angles_footprint") - flash_bytes("multiply_footprint"),
                             6 * 1024)

    def test_no_subject_of_the_library_takes_ram(self):
        for program in LIBRARY:
            self.assertTrue(footprints(program))
            for subject, row in footprints(program).items():
                self.assertEqual(row["ram_bytes"], "0", subject)

    def test_functions_that_share_code_take_less_together(self):
        rows = {subject: int(row["flash_bytes"]) for subject, row in footprints("q16_16").items()}
        small = [subject for subject in rows
                 if subject.endswith("_small")
                 and not subject.startswith(("own_", "nine_"))]
        together = rows["own_q16_16_small"]
        self.assertGreater(together, max(rows[subject] for subject in small))
        self.assertLess(together, sum(rows[subject] for subject in small))
        self.assertLessEqual(together, 2112)

    def test_small_functions_stay_small(self):
        rows = {subject: int(row["flash_bytes"]) for subject, row in footprints("q16_16").items()}
        for subject, largest in SMALL.items():
            self.assertLessEqual(rows[f"{subject}_q16_16_small"], largest, subject)

    def test_multiplication_fits_two_hundred_bytes(self):
        self.assertIn(int(footprints("q16_16")["multiply_q16_16_default"]["flash_bytes"]),
                      range(1, 201))


if __name__ == "__main__":
    unittest.main()
