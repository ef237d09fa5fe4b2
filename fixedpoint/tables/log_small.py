#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/log_small_table.S and portable/log_small_table.hpp:
parabolas for the natural logarithm on 16 cells of [1, 2], in units of 2^-24.

On a cell, 0 <= d < 1/16, ln(start + d) is value + slope d - bend d^2. The three are those of least
largest error at 128 points, in the kernel's integers."""

from fractions import Fraction

import page
import table_header
from exponential_series import logarithm

CELLS = 16
UNIT = 24
GUARD = 24
SPAN = 1 << UNIT - 4  # of a cell
POINTS = 128


def scaled(cell, fraction):
    """ln(1 + (cell + fraction) / 16) in units."""
    x = 1 + (cell + fraction) / CELLS
    return Fraction(logarithm(x.numerator, x.denominator, UNIT + GUARD), 1 << GUARD)


def rise(distance, slope, bend):
    """What the kernel adds to the value, at a distance in units."""
    high, middle, low = distance >> 16, distance >> 8 & 0xFF, distance & 0xFF
    tangent = slope - (high * bend + (middle * bend >> 8))
    s1, s0 = tangent >> 8, tangent & 0xFF
    return (high * s1 << 8) + high * s0 + middle * s1 + (middle * s0 >> 8) + (low * s1 >> 8)


def parabola(cell):
    """(value, slope, bend): of the slopes, the errors' spread has one minimum."""
    curve = [scaled(cell, Fraction(at, POINTS)) for at in range(POINTS)]

    def errors(slope, bend):
        return [exact - rise(at * SPAN // POINTS, slope, bend) for at, exact in enumerate(curve)]

    def spread(slope, bend):
        error = errors(slope, bend)
        return max(error) - min(error)

    def best_slope(bend):
        low, high = 1 << 14, (1 << 16) - 1
        while low < high:
            middle = (low + high) // 2
            if spread(middle, bend) <= spread(middle + 1, bend):
                high = middle
            else:
                low = middle + 1
        return low

    # Half of the second derivative, at the middle of the cell.
    bend = round(128 / (1 + Fraction(2 * cell + 1, 2 * CELLS)) ** 2)
    slope, bend = min(((best_slope(b), b) for b in range(bend - 1, bend + 3)),
                      key=lambda pair: spread(*pair))
    error = errors(slope, bend)
    return round((min(error) + max(error)) / 2), slope, bend


SENTENCE = ("Parabolas of ln on 16 cells of [1, 2]: the bend in units of 2^-8, the slope in 2^-16, the\n"
            "value in 2^-24.")


if __name__ == "__main__":
    parabolas = [parabola(cell) for cell in range(CELLS)]
    assert all(value >= 0 and slope < 1 << 16 and bend < 1 << 8 for value, slope, bend in parabolas)
    page.write_assembly(
        "log_small_table", "log_small.py", SENTENCE,
        [("bend, slope, value", [byte for value, slope, bend in parabolas
                                 for byte in bytes([bend]) + slope.to_bytes(2, "little")
                                 + value.to_bytes(3, "little")])], alignment=1)
    table_header.write("log_small_table", "log_small.py", SENTENCE, "LogarithmSmallTable",
                       [("uint8_t", "bend", [bend for _, _, bend in parabolas], "{:3d}"),
                        ("uint16_t", "slope", [slope for _, slope, _ in parabolas], "{:5d}"),
                        ("uint32_t", "value", [value for value, _, _ in parabolas], "{:8d}")])
