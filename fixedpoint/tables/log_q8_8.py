#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes src/fixedpoint/avr/log_q8_8_table.S and src/fixedpoint/portable/log_q8_8_table.hpp: chords
of the natural logarithm of 1 to 2, in 64 intervals."""

from fractions import Fraction

import chords_of_bytes
from exponential_series import logarithm

BITS = 20


def in_ulp(interval, position):
    return Fraction(logarithm(2**14 + 256 * interval + position, 2**14, BITS), 2**(BITS - 8))


if __name__ == "__main__":
    chords_of_bytes.write("log_q8_8_table", "log_q8_8.py", "The natural logarithm of 1 to 2.",
                          "LogQ8_8Table", chords_of_bytes.of(in_ulp, 64))
