#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/reciprocal_sqrt_32_table.S and
portable/reciprocal_sqrt_32_table.hpp: the reciprocal square root on [1, 2], for every 32-bit
format."""

from fractions import Fraction
from math import isqrt

import cubic

GUARD = 24


def fallen(numerator, denominator):
    one = 1 << 39 + GUARD
    return Fraction(one - isqrt(one * one * denominator // (denominator + numerator)), 1 << GUARD)


if __name__ == "__main__":
    logarithms = [max(0, (2 * i).bit_length() - 1) for i in range(128)]
    cubic.write("reciprocal_sqrt_32_table", "reciprocal_sqrt_32.py",
                "1 - 1/sqrt(1 + x) on 256 intervals of [0, 1], cubics in the layout of "
                "tables/cubic.py.",
                "ReciprocalSqrt32Table", fallen, [
                    ("the factor that shifts the leading one out of a byte, indexed by its upper 7 bits",
                     [256 >> logarithm & 255 for logarithm in logarithms]),
                    ("its base-2 logarithm, indexed likewise", logarithms)])
