#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/portable/correct_rounding_table.hpp: the constants that decide
on which side of a tie a sine or a power lies."""

import table_header
from exponential_series import exponential
from series import rounded, sine_and_cosine

UNIT = 64
EXPONENTS = range(9, 33)


def mantissa(exponent):
    power = exponential(exponent, 1, 128)
    return rounded(power, power.bit_length() - 64)


def halves(word):
    return word & 0xFFFFFFFF, word >> 32


if __name__ == "__main__":
    table_header.write(
        "correct_rounding_table", "correct_rounding.py",
        f"Sine and cosine of i / {UNIT} in units of 2^-64, 1 as a unit less;\n"
        f"and the 64 leading bits of e^i from i = {EXPONENTS[0]} on, the lower half first.", "CorrectRoundingTable",
        [("uint64_t", "unit", [min(part, (1 << 64) - 1) for i in range(UNIT * 11 // 14 + 1) for part in sine_and_cosine(i, UNIT, 64)], "{:#018x}ull"),
         ("uint32_t", "power", [half for i in EXPONENTS for half in halves(mantissa(i))], "{:#010x}u")])
