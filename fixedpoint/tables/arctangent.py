#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/arctangent_table.S and portable/arctangent_table.hpp: chords
of the arc tangent on [0, 1], for Q16.16, in units of 2^-8 ulp."""

from fractions import Fraction

import interpolation
import series

BITS = 60
HALF_ULP = 1 << 7


def arctangent(numerator, denominator):
    return Fraction(series.arctangent(numerator, denominator, BITS), 1 << (BITS - 24))


if __name__ == "__main__":
    interpolation.write(
        "arctangent_table", "arctangent.py",
        "2^24 atan(x) + 128 on 256 intervals of [0, 1]: it includes half an ulp of Q16.16, so that\n"
        "truncating 8 bits rounds.",
        interpolation.chords(arctangent, HALF_ULP), "ArctangentTable")
