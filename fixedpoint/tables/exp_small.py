#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/exp_small_table.S and portable/exp_small_table.hpp: factors
1 + b/256 about e^x at the steps of 1/16 below ln 2 with their logarithms, in units of 2^-32, and
e^x - 1 at the first 17 steps of 1/256, in units of 2^-40, of which the fifth byte is the step's
number and is left out."""

from fractions import Fraction

import page
import table_header
from exponential_series import logarithm

SENTENCE = ("b for i = 0..11, and ln(1 + b/256) in units of 2^-32, less than 1/256 below i/16; and\n"
            "e^(j/256) - 1 in units of 2^-40, for j = 0..16, less its fifth byte, which is j.")
# The largest b leave least to the second table. Those below it err less over all arguments.
BELOW = {2: 1, 8: 1, 10: 1, 11: 1}


def exponential(x):
    """e^x, off by less than 2^-100."""
    total = term = Fraction(1)
    for n in range(1, 40):
        term *= x / n
        total += term
    return total


def nearest(x):
    return int(x + Fraction(1, 2))


def factor(i):
    """(b, its logarithm), rounded down up to a third: what the kernel adds to its argument errs upward."""
    b = int(256 * (exponential(Fraction(i, 16)) - 1)) - BELOW.get(i, 0)
    units = Fraction(logarithm(256 + b, 256, 64), 2**32)
    assert 16 * units <= i * 2**32 < 16 * units + 2**28
    return b, int(units + Fraction(2, 3))


if __name__ == "__main__":
    coarse = [factor(i) for i in range(12)]
    fine = [nearest((exponential(Fraction(j, 256)) - 1) * 2**40) for j in range(17)]
    assert all(value >> 32 == j for j, value in enumerate(fine))
    fine = [value % 2**32 for value in fine]
    page.write_assembly(
        "exp_small_table", "exp_small.py", SENTENCE,
        [("b, logarithm", [byte for b, log in coarse for byte in bytes([b]) + log.to_bytes(4, "little")]),
         ("fine", [byte for value in fine for byte in value.to_bytes(4, "little")])], alignment=1)
    table_header.write("exp_small_table", "exp_small.py", SENTENCE, "ExponentialSmallTable",
                       [("uint8_t", "factor", [b for b, _ in coarse], "{:3d}"),
                        ("uint32_t", "logarithm", [log for _, log in coarse], "{:#010x}"),
                        ("uint32_t", "fine", fine, "{:#010x}")])
