#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/exp_small_table.S and portable/exp_small_table.hpp: e^x less
1 at the steps of 1/16 below ln 2, in units of 2^-32, and at the first 16 steps of 1/256, in units of
2^-40, of which the fifth byte is the step's number and is left out."""

from fractions import Fraction

import page
import table_header

SENTENCE = ("e^(i/16) - 1 in units of 2^-32, for i = 0..11, and e^(j/256) - 1 in units of 2^-40, for\n"
            "j = 0..15, less its fifth byte, which is j.")


def exponential(x):
    """e^x, off by less than 2^-100."""
    total = term = Fraction(1)
    for n in range(1, 40):
        term *= x / n
        total += term
    return total


def nearest(x):
    return int(x + Fraction(1, 2))


if __name__ == "__main__":
    coarse = [nearest((exponential(Fraction(i, 16)) - 1) * 2**32) for i in range(12)]
    fine = [nearest((exponential(Fraction(j, 256)) - 1) * 2**40) for j in range(16)]
    assert all(value >> 32 == j for j, value in enumerate(fine))
    fine = [value % 2**32 for value in fine]
    page.write_assembly(
        "exp_small_table", "exp_small.py", SENTENCE,
        [(title, [byte for value in values for byte in value.to_bytes(4, "little")])
         for title, values in [("coarse", coarse), ("fine", fine)]], alignment=1)
    table_header.write("exp_small_table", "exp_small.py", SENTENCE, "ExponentialSmallTable",
                       [("uint32_t", "coarse", coarse, "{:#010x}"),
                        ("uint32_t", "fine", fine, "{:#010x}")])
