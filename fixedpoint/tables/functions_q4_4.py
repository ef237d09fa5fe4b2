#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes src/fixedpoint/avr/<function>_q4_4_table.S: the result for every Q4.4 number, rounded to
nearest and saturated, of the functions of one operand."""

from fractions import Fraction
from math import isqrt

import page
import series
from exponential_series import exponential, logarithm

BITS = 40
HALF_PI = Fraction(series.pi(BITS), 2**(BITS + 1))


def sine(quarters):
    """sin(pi/2 quarters)."""
    quarters %= 4
    if quarters > 2:
        return -sine(quarters - 2)
    if quarters > 1:
        quarters = 2 - quarters
    return Fraction(
        series.sine_of_quarter_turns(quarters.numerator, quarters.denominator, BITS), 2**BITS)


def arctangent(a):
    if a < 0:
        return -arctangent(-a)
    if a > 1:
        return HALF_PI - arctangent(1 / a)
    return Fraction(series.arctangent(a.numerator, a.denominator, BITS), 2**BITS)


def natural_logarithm(a):
    """ln a, or the smallest number if a <= 0."""
    if a <= 0:
        return Fraction(-8)
    doublings = 0
    while a >= 2:
        a, doublings = a / 2, doublings + 1
    while a < 1:
        a, doublings = a * 2, doublings - 1
    return Fraction(logarithm(a.numerator, a.denominator, BITS) +
                    doublings * logarithm(2, 1, BITS), 2**BITS)


def root(a):
    """sqrt(a), or 0 if a < 0."""
    return Fraction(isqrt(2**(2 * BITS) * max(a.numerator, 0) // a.denominator), 2**BITS)


def reciprocal_root(a):
    """1 / sqrt(a), or the largest number if a = 0, and 0 if a < 0."""
    if a <= 0:
        return Fraction(8 if a == 0 else 0)
    return Fraction(isqrt(2**(2 * BITS) * a.denominator // a.numerator), 2**BITS)


FUNCTIONS = {
    "sin": (lambda a: sine(a / HALF_PI), "The sine"),
    "cos": (lambda a: sine(a / HALF_PI + 1), "The cosine"),
    "atan": (arctangent, "The arc tangent"),
    "exp": (lambda a: Fraction(exponential(a.numerator, a.denominator, BITS), 2**BITS),
            "The exponential function"),
    "log": (natural_logarithm, "The natural logarithm"),
    "sqrt": (root, "The square root"),
    "reciprocal_sqrt": (reciprocal_root, "1 / sqrt"),
}


def nearest(value):
    return max(-128, min(127, (32 * value + 1) // 2))


if __name__ == "__main__":
    for name, (function, sentence) in FUNCTIONS.items():
        signed = [raw - 256 if raw > 127 else raw for raw in range(256)]
        page.write_assembly(
            f"{name}_q4_4_table", "functions_q4_4.py", f"{sentence} of every Q4.4 number.",
            [("by the raw number", [nearest(function(Fraction(raw, 16))) & 255 for raw in signed])])
