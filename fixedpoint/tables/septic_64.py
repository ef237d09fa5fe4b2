#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes avr/septic_<name>_table.S and portable/septic_<name>_table.hpp of fixedpoint/src/fixedpoint:
functions on 64 intervals of [0, 1), with a polynomial of degree 7 in each, which avr/septic_64.S
evaluates by Horner's rule,

    c0 + t (c1 + t (c2 + ... + t c7)),   where t in [0, 1) is the position in the interval.

A record contains c7 to c0, the lowest byte first, in the unit of the function and with the widths in
bytes that WIDTHS gives."""

from fractions import Fraction
from math import cos, pi

import page
import table_header
from cubic import divided_differences, nearest
from exponential_series import logarithm
from series import arctangent, circular

INTERVALS = 64
WIDTHS = (3, 4, 5, 5, 6, 7, 8, 8)
BITS = 112
GRID = 1 << 58
NODES = [Fraction(round(GRID * (1 - cos((2 * i + 1) * pi / 16)) / 2), GRID) for i in range(8)]
# Multiples of the golden ratio, modulo 1.
SAMPLES = [Fraction(i * 0x278dde6e5fd29f1 % GRID, GRID) for i in range(96)]


def sine(numerator, denominator, bits):
    """sin(2 numerator/denominator) 2^bits."""
    return circular(numerator << bits + 1, denominator, bits)


def log1p(numerator, denominator, bits):
    return logarithm(denominator + numerator, denominator, bits)


# Name, formula in x, function, and the number of intervals that contain arguments.
FUNCTIONS = [("sine", "sin 2x", sine, 51), ("log", "ln(1 + x)", log1p, 64), ("atan", "atan x", arctangent, 64)]
UNIT = 63


def product(a, t, width):
    """The product of a, signed, and the upper bytes of t, a 64-bit fraction: the columns above the point, and the
    upper bytes of the column below it."""
    t >>= 64 - 8 * width
    a_bytes, t_bytes = ([number >> 8 * i & 255 for i in range(width)] for number in (a, t))
    total = 0
    for i in range(width):
        for j in range(width - 1 - i, width):
            digits = a_bytes[i] * t_bytes[j]
            total += digits >> 8 if i + j < width else digits << 8 * (i + j - width)
    return total - t if a < 0 else total


def evaluate(row, t):
    """septic_64 of portable/septic_64.hpp; t is in units of 2^-64."""
    a = row[0]
    for width, coefficient in zip(WIDTHS, row[1:]):
        assert -1 << 8 * width - 1 <= a < 1 << 8 * width - 1
        a = product(a, t, width) + coefficient
    return a


def coefficients(values):
    """The coefficients, in powers of t, of the polynomial through values at NODES."""
    differences = divided_differences(NODES, values)
    result = []
    for node, difference in zip(reversed(NODES), reversed(differences)):
        result = [high - node * low for high, low in zip([Fraction(0)] + result, result + [Fraction(0)])]
        result[0] += difference
    return result


def record(function, interval):
    """c7 to c0 and the largest error at the samples."""

    def exact(t):
        position = interval * GRID + t * GRID
        return Fraction(function(int(position), INTERVALS * GRID, BITS), 1 << BITS - UNIT)

    row = [nearest(c) for c in reversed(coefficients([exact(t) for t in NODES]))]
    # The constant compensates for the truncation of the products.
    errors = [evaluate(row, int(t * (1 << 64))) - exact(t) for t in SAMPLES]
    middle = nearest((max(errors) + min(errors)) / 2)
    row[-1] -= middle
    return row, max(abs(error - middle) for error in errors)


def write(name, formula, function, intervals):
    records = [record(function, i) for i in range(intervals)]
    digits = [c >> 8 * i & 255 for row, _ in records for c, width in zip(row, WIDTHS) for i in range(width)]
    sentence = (f"{formula} for x in [0, 1) in units of 2^-{UNIT}, in the layout of tables/septic_64.py;\n"
                f"the error is at most {float(max(error for _, error in records)):.1f} units at the {len(SAMPLES)} checked points of each interval.")
    page.write_assembly(f"septic_{name}_table", "septic_64.py", sentence,
                        [("bytes of c7 to c0: " + ", ".join(map(str, WIDTHS)), digits)], 1)
    table_header.write(f"septic_{name}_table", "septic_64.py", sentence, f"Septic{name.capitalize()}Table",
                       [("uint8_t", "record", digits, "{:3d}")])


if __name__ == "__main__":
    for row in FUNCTIONS:
        write(*row)
