#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/reciprocal_sqrt_32_table.S and
portable/reciprocal_sqrt_32_table.hpp: the reciprocal square root on [2, 4] and on [1, 2], for every
32-bit format."""

from fractions import Fraction
from math import isqrt

import cubic

GUARD = 24


def negative_reciprocal_root(numerator, denominator):
    """Of m, from 2 to 4 in the lower half of the table and from 1 to 2 in the upper half."""
    m = Fraction(2 * numerator, denominator)
    if m < 1:
        m = 2 + 2 * m
    one = 1 << 39 + GUARD
    return Fraction(-isqrt(one * one * m.denominator // m.numerator), 1 << GUARD)


if __name__ == "__main__":
    logarithms = [max(0, (2 * i).bit_length() - 1) for i in range(128)]
    cubic.write("reciprocal_sqrt_32_table", "reciprocal_sqrt_32.py",
                "1/sqrt(m) on 128 intervals of [2, 4] and on 128 of [1, 2], cubics in the layout of\n"
                "tables/cubic.py for a falling function.",
                "ReciprocalSqrt32Table", negative_reciprocal_root, [
                    ("the factor that shifts the leading one of a byte to bit 7, and its base-2 logarithm, in turn,"
                     "\n    // indexed by the upper 7 bits of the byte, which is not 0",
                     [number for logarithm in logarithms for number in (128 >> logarithm, logarithm)])],
                core=cubic.FALLING_CORE_32)
