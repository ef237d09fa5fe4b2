#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes log_small_table, for src/fixedpoint/avr/ and for src/fixedpoint/portable/: parabolas for
ln(1 + x) on 16 cells of [0, 1], in units of 2^-24, plus half an ulp of Q16.16 for rounding.

On a cell, 0 <= d < 1/16, the function is value + slope d - bend d^2. The coefficients minimise the
largest error at 129 points in the integer arithmetic of avr/log_q16_16_small.S."""

from fractions import Fraction

import page
import table_header
from exponential_series import logarithm

CELLS = 16
UNIT = 24
GUARD = 24
FINE = 1 << GUARD
SPAN = 1 << UNIT - 4  # of a cell
HALF_ULP = 128
DISTANCES = [*range(0, SPAN, SPAN // 128), SPAN - 1]
GENERATOR = "log_small.py"


def log(x):
    """ln(1 + x) in units."""
    y = 1 + x
    return Fraction(logarithm(y.numerator, y.denominator, UNIT + GUARD), 1 << GUARD)


def rise(distance, slope, bend):
    """The kernel's increment of the value at a distance in units."""
    high, middle, low = distance >> 16, distance >> 8 & 0xFF, distance & 0xFF
    tangent = slope - (high * bend + (middle * bend >> 8))
    s1, s0 = tangent >> 8, tangent & 0xFF
    return (high * s1 << 8) + high * s0 + middle * s1 + (middle * s0 >> 8) + (low * s1 >> 8)


def parabola(cell):
    """(value, slope, bend): as a function of the slope, the spread of the errors has one minimum."""
    # In units of 1 / FINE, in which all values are integers, for speed.
    curve = [(d, int(log((cell + Fraction(d, SPAN)) / CELLS) * FINE)) for d in DISTANCES]

    def errors(slope, bend):
        return [exact - rise(d, slope, bend) * FINE for d, exact in curve]

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

    # Half the second derivative in the middle, without its sign.
    bend = round(256 / (2 * (1 + Fraction(2 * cell + 1, 2 * CELLS))**2))
    slope, bend = min(((best_slope(b), b) for b in range(max(bend - 1, 0), bend + 3)),
                      key=lambda pair: spread(*pair))
    error = errors(slope, bend)
    return round(Fraction(min(error) + max(error), 2 * FINE)), slope, bend


if __name__ == "__main__":
    sentence = ("Parabolas of ln(1 + x) on 16 cells of [0, 1]: the slope in units of 2^-16, the bend in\n"
                "2^-8, the value in 2^-24, plus half an ulp of Q16.16.")
    parabolas = [parabola(cell) for cell in range(CELLS)]
    parabolas = [(value + HALF_ULP, slope, bend) for value, slope, bend in parabolas]
    assert all(value >= 0 and slope < 1 << 16 and bend < 1 << 8 for value, slope, bend in parabolas)
    page.write_assembly(
        "log_small_table", GENERATOR, sentence,
        [("slope, bend, value", [byte for value, slope, bend in parabolas
                                 for byte in slope.to_bytes(2, "little") + bytes([bend])
                                 + value.to_bytes(3, "little")])], alignment=1)
    table_header.write("log_small_table", GENERATOR, sentence, "LogarithmSmallTable",
                       [("uint16_t", "slope", [slope for _, slope, _ in parabolas], "{:5d}"),
                        ("uint8_t", "bend", [bend for _, _, bend in parabolas], "{:3d}"),
                        ("uint32_t", "value", [value for value, _, _ in parabolas], "{:8d}")])
