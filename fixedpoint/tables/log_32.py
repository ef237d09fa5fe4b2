#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/log_32_table.S and portable/log_32_table.hpp: the natural
logarithm on [1, 2] and the multiples of ln 2, for every 32-bit format."""

from fractions import Fraction

import cubic
from exponential_series import logarithm

GUARD = 24
LN2 = (logarithm(2, 1, 39 + GUARD) >> GUARD - 1) + 1 >> 1


def scaled(numerator, denominator):
    return Fraction(logarithm(denominator + numerator, denominator, 39 + GUARD), 1 << GUARD)


if __name__ == "__main__":
    records = []
    for exponent in range(32):
        records += [1 << (8 - exponent % 8) & 255,
                    *(exponent * LN2 >> 8 * i & 255 for i in range(6))]
    cubic.write("log_32_table", "log_32.py",
                "ln(1 + x) on 256 intervals of [0, 1], cubics in the layout of tables/cubic.py.",
                "Log32Table", scaled, [
                    ("by e: the factor that shifts the leading one out of a byte, then e ln 2 in "
                     "units of 2^-39", records + [0] * (256 - len(records))),
                    ("7 log2 of a byte, indexed by its upper 7 bits",
                     [7 * max(0, (2 * i).bit_length() - 1) for i in range(128)])])
