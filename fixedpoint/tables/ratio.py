#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/ratio_table.S and portable/ratio_table.hpp: chords of 1/d on
[1, 2), with which atan2 divides its smaller coordinate by its larger one."""

from fractions import Fraction

import interpolation


def reciprocal(numerator, denominator):
    return (1 << 24) / (1 + Fraction(numerator, denominator))


if __name__ == "__main__":
    interpolation.write(
        "ratio_table", "ratio.py",
        "2^24 / (1 + x) on 256 intervals of [0, 1]. It is falling: slopes are negated.",
        interpolation.chords(reciprocal, 0), "RatioTable")
