#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/atan_32_table.S and portable/atan_32_table.hpp: the arc
tangent on [0, 1], for every 32-bit format."""

from fractions import Fraction

import cubic
import series

GUARD = 24


def scaled(numerator, denominator):
    return Fraction(series.arctangent(numerator, denominator, 39 + GUARD), 1 << GUARD)


if __name__ == "__main__":
    cubic.write("atan_32_table", "atan_32.py",
                "atan(x) on 256 intervals of [0, 1], cubics in the layout of tables/cubic.py.",
                "Atan32Table", scaled)
