#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/sine_32_table.S and portable/sine_32_table.hpp: the sine on
the first quarter turn, for every 32-bit format."""

from fractions import Fraction

import cubic
import series

GUARD = 24


def sine(numerator, denominator):
    return Fraction(series.sine_of_quarter_turns(numerator, denominator, 39 + GUARD), 1 << GUARD)


if __name__ == "__main__":
    cubic.write("sine_32_table", "sine_32.py",
                "sin(pi/2 x) on 256 intervals of [0, 1], cubics in the layout of tables/cubic.py.",
                "Sine32Table", sine)
