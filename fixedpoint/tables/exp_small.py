#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/exp_small_table.S and portable/exp_small_table.hpp: factors
1 + b/256 close to e^x at steps of 1/16 below ln 2 with their logarithms, in units of 2^-32, and
j/256 - ln(1 + j/256) for the first 18 factors 1 + j/256, in units of 2^-40."""

from fractions import Fraction

import page
import table_header
from exponential_series import logarithm

SENTENCE = ("b for i = 0..11, and ln(1 + b/256) in units of 2^-32, less than 1/256 below i/16; and\n"
            "j/256 - ln(1 + j/256) for j = 0..17 in units of 2^-40, plus the correction of the kernel.")
# Here the largest b minus 1 is taken, since its logarithm is closer to an integer.
LOWER = {7, 10, 11}
# In units of 2^-40: 14 times the rounding error of ln 2, minus the 2 units of 2^-32 that the kernel adds first.
CORRECTION = 124


def exponential(x):
    """e^x, with an error below 2^-100."""
    total = term = Fraction(1)
    for n in range(1, 40):
        term *= x / n
        total += term
    return total


def nearest(x):
    return int(x + Fraction(1, 2))


def factor(i):
    """(b, its logarithm)"""
    b = int(256 * (exponential(Fraction(i, 16)) - 1)) - (i in LOWER)
    units = Fraction(logarithm(256 + b, 256, 64), 2**32)
    assert 16 * units <= i * 2**32 < 16 * units + 2**28
    return b, nearest(units)


def shortfall(j):
    return nearest(Fraction(j * 2**56 - logarithm(256 + j, 256, 64), 2**24)) + CORRECTION


if __name__ == "__main__":
    coarse = [factor(i) for i in range(12)]
    fine = [shortfall(j) for j in range(18)]
    page.write_assembly(
        "exp_small_table", "exp_small.py", SENTENCE,
        [("b, logarithm", [byte for b, log in coarse for byte in bytes([b]) + log.to_bytes(4, "little")]),
         ("shortfall", [byte for value in fine for byte in value.to_bytes(4, "little")])], alignment=1)
    table_header.write("exp_small_table", "exp_small.py", SENTENCE, "ExponentialSmallTable",
                       [("uint8_t", "factor", [b for b, _ in coarse], "{:3d}"),
                        ("uint32_t", "logarithm", [log for _, log in coarse], "{:#010x}"),
                        ("uint32_t", "shortfall", fine, "{:#010x}")])
