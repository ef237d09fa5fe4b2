#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes src/fixedpoint/avr/sin_q8_8_table.S and src/fixedpoint/portable/sin_q8_8_table.hpp: chords
of the sine of the first quarter turn, in 64 intervals."""

from fractions import Fraction

import chords_of_bytes
import series

BITS = 20


def sine(interval, position):
    """In ulp; of the middle of what the phase stands for."""
    numerator = 2 * (256 * interval + position) + 1
    return Fraction(series.sine_of_quarter_turns(numerator, 2**15, BITS), 2**(BITS - 8))


if __name__ == "__main__":
    chords_of_bytes.write("sin_q8_8_table", "sin_q8_8.py", "The sine of the first quarter turn.",
                          "SinQ8_8Table", chords_of_bytes.of(sine, 64))
