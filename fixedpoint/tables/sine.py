#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/sine_table.S and portable/sine_table.hpp: chords of the sine
of the first quarter turn, for Q16.16, in units of 2^-7 ulp."""

from fractions import Fraction

import interpolation
import series

BITS = 60
HALF_ULP = 1 << 6


def sine(numerator, denominator):
    return Fraction(series.sine_of_quarter_turns(numerator, denominator, BITS), 1 << (BITS - 23))


if __name__ == "__main__":
    interpolation.write(
        "sine_table", "sine.py",
        "2^23 sin(pi/2 x) + 64 on 256 intervals of [0, 1]: it includes half an ulp of Q16.16, so\n"
        "that truncating 7 bits rounds.",
        interpolation.chords(sine, HALF_ULP), "SineTable")
