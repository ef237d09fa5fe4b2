#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/portable/correct_rounding_table.hpp: the constants that decide
on which side of a tie an angle or a power lies."""

import table_header
from exponential_series import exponential
from series import arctangent, rounded, sine_and_cosine

COARSE, FINE, UNIT = 32, 2048, 64
FINE_ENTRIES = 69  # a coarse step, 64, plus what a byte of the angle leaves open
EXPONENTS = range(9, 33)


def mantissa(exponent):
    power = exponential(exponent, 1, 128)
    return rounded(power, power.bit_length() - 64)


def halves(word):
    return word & 0xFFFFFFFF, word >> 32


def angles(name, denominator, entries):
    """The upper 64 bits of 96, and the lower ones."""
    numbers = [arctangent(i, denominator, 96) for i in range(entries)]
    return (("uint64_t", name, [number >> 32 for number in numbers], "{:#018x}ull"),
            ("uint32_t", f"{name}_below", [number & (1 << 32) - 1 for number in numbers], "{:#010x}u"))


if __name__ == "__main__":
    table_header.write(
        "correct_rounding_table", "correct_rounding.py",
        f"atan(i / {COARSE}) and atan(i / {FINE}) in units of 2^-64 and, beyond them, of 2^-96; sine and cosine of i / {UNIT} in units of 2^-64, 1 as a unit less;\n"
        f"and the 64 leading bits of e^i from i = {EXPONENTS[0]} on, the lower half first.", "CorrectRoundingTable",
        [*angles("coarse", COARSE, COARSE + 1), *angles("fine", FINE, FINE_ENTRIES),
         ("uint64_t", "unit", [min(part, (1 << 64) - 1) for i in range(UNIT * 11 // 14 + 1) for part in sine_and_cosine(i, UNIT, 64)], "{:#018x}ull"),
         ("uint32_t", "power", [half for i in EXPONENTS for half in halves(mantissa(i))], "{:#010x}u")])
