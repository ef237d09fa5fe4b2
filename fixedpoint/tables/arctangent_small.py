#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes arctangent_small_table, for src/fixedpoint/avr/ and for src/fixedpoint/portable/: atan(i/16) in
units of 2^-24, plus half an ulp of Q16.16 for rounding and the mean of the extreme errors of the
remaining angle in avr/atan2_q16_16_small.S."""

from math import atan

import page
import table_header

CELLS = 16
UNIT = 1 << 24
HALF_ULP = 128
GENERATOR = "arctangent_small.py"
SENTENCE = ("atan(i/16) for i = 0..15 in units of 2^-24, plus half an ulp of Q16.16 and an offset that\n"
            "centres the errors of the remaining angle.")
# Denominators from 2^16 to 2^22: the smallest have the largest errors, on one side.
DENOMINATORS = [(1 << 16) + 1, 3 << 15, 3 << 18, (1 << 22) - 1]


def rest(numerator, denominator):
    """(i, the angle beyond atan(i/16)) as the kernel computes it."""
    cell, remainder = min(16 * numerator // denominator, CELLS - 1), 16 * numerator
    remainder -= cell * denominator
    ratio = (remainder << 16) // (denominator + (cell * numerator >> 4))
    upper = ratio >> 8
    return cell, (ratio - ((upper * upper >> 8) * upper >> 8) * 85 // 256) << 4


def offset(cell):
    """The middle of the errors."""
    errors = []
    for denominator in DENOMINATORS:
        for step in range(cell << 10, cell + 1 << 10):
            numerator = denominator * step >> 14
            found, angle = rest(numerator, denominator)
            if found == cell:
                errors.append(UNIT * atan(numerator / denominator) - angle)
    return round((min(errors) + max(errors)) / 2)


if __name__ == "__main__":
    angles = [offset(cell) + HALF_ULP for cell in range(CELLS)]
    page.write_assembly(
        "arctangent_small_table", GENERATOR, SENTENCE,
        [("angles", [byte for angle in angles for byte in angle.to_bytes(3, "little")])], alignment=1)
    table_header.write("arctangent_small_table", GENERATOR, SENTENCE, "ArctangentSmallTable",
                       [("uint32_t", "angle", angles, "{:8d}")])
