#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes log_small_table, for src/fixedpoint/avr/ and for src/fixedpoint/portable/: parabolas for
ln(1 + x) on 16 cells of [0, 1], in units of 2^-24, plus half an ulp of Q16.16 for rounding.

On a cell, 0 <= d < 1/16, the function is value + slope d - bend d^2. Half the second derivative is
half the square of the first one: the bend is computed from the upper byte of the slope at the
beginning of the cell, with a factor below 1/2 since the derivative in the middle counts. Value and
slope minimise the largest error at 2062 points in the integer arithmetic of avr/log_q16_16_small.S."""

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
BEND = 122  # of 256, with the smallest largest error
DISTANCES = [*range(0, SPAN, 509), SPAN - 1]
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


def bend(slope):
    return ((slope >> 8)**2 >> 8) * BEND >> 8


def parabola(cell):
    """(value, slope): for one upper byte of the slope, the spread of the errors has one minimum."""
    # In units of 1 / FINE, in which all values are integers, for speed.
    curve = [(d, int(log((cell + Fraction(d, SPAN)) / CELLS) * FINE)) for d in DISTANCES]

    def errors(slope):
        return [exact - rise(d, slope, bend(slope)) * FINE for d, exact in curve]

    def spread(slope):
        error = errors(slope)
        return max(error) - min(error)

    def best_slope(upper):
        low, high = upper << 8, upper << 8 | 255
        while low < high:
            middle = (low + high) // 2
            if spread(middle) <= spread(middle + 1):
                high = middle
            else:
                low = middle + 1
        return low

    upper = min(256 * CELLS // (CELLS + cell), 255)
    slope = min(map(best_slope, (upper - 1, upper)), key=spread)
    error = errors(slope)
    return round(Fraction(min(error) + max(error), 2 * FINE)), slope


if __name__ == "__main__":
    sentence = ("Parabolas of ln(1 + x) on 16 cells of [0, 1]: the slope in units of 2^-16 and the value in\n"
                "2^-24, plus half an ulp of Q16.16{}.")
    parabolas = [parabola(cell) for cell in range(CELLS)]
    parabolas = [(value + HALF_ULP, slope) for value, slope in parabolas]
    assert all(value >= 0 and slope < 1 << 16 for value, slope in parabolas)
    page.write_assembly(
        "log_small_table", GENERATOR, sentence.format("; its lowest byte is last"),
        [("slope, value", [byte for value, slope in parabolas
                           for byte in slope.to_bytes(2, "little") + (value >> 8).to_bytes(2, "little")
                           + bytes([value & 0xFF])])], alignment=1)
    table_header.write("log_small_table", GENERATOR, sentence.format(""), "LogarithmSmallTable",
                       [("uint16_t", "slope", [slope for _, slope in parabolas], "{:5d}"),
                        ("uint32_t", "value", [value for value, _ in parabolas], "{:8d}")])
