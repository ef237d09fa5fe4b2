#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/log_table.S and portable/log_table.hpp: chords of the
natural logarithm on 256 intervals of [1, 2] and the multiples of ln 2, for Q16.16, in units of
2^-8 ulp."""

from fractions import Fraction

import interpolation
import page
import table_header
from exponential_series import logarithm

UNIT = 24  # the unit is 2^-24
GUARD = 16
HALF_ULP = 128


def from_one(numerator, denominator):
    """ln(1 + numerator/denominator) in units."""
    return Fraction(logarithm(denominator + numerator, denominator, UNIT + GUARD), 1 << GUARD)


def exponent_logarithm(exponent):
    """ln 2^(exponent - 16) in units."""
    magnitude = (abs(exponent - 16) * logarithm(2, 1, UNIT + GUARD) >> GUARD - 1) + 1 >> 1
    return -magnitude if exponent < 16 else magnitude


SENTENCE = """\
ln(1 + i/256) 2^24 + 128, which includes half an ulp of Q16.16, so that truncating 8 bits rounds; the
rise of the logarithm over the interval; ln 2 (e - 16) 2^24 for the exponent e of the raw number."""


def main():
    values, slopes = zip(*interpolation.chords(from_one, HALF_ULP))
    exponents = [exponent_logarithm(exponent) for exponent in range(31)]

    def byte(numbers, i):
        return [number >> 8 * i & 255 for number in numbers]

    records = []
    for exponent, number in enumerate(exponents):
        records += [1 << (7 - exponent % 8), *(number >> 8 * i & 255 for i in range(4))]
    page.write_assembly("log_table", "log.py", SENTENCE, [
        ("value, bits 0..7", byte(values, 0)),
        ("value, bits 8..15", byte(values, 1)),
        ("value, bits 16..23", byte(values, 2)),
        ("slope, bits 8..15", byte(slopes, 1)),
        ("slope, bits 0..7", byte(slopes, 0)),
        ("5 log2 of a byte, indexed by its upper 7 bits", [5 * max(0, (2 * i).bit_length() - 1)
                                                   for i in range(128)]),
        ("by e: the factor that moves the leading one to bit 7, four bytes of logarithm",
         records)])
    table_header.write("log_table", "log.py", SENTENCE, "LogTable", [
        ("uint32_t", "value", values, "0x{:06x}"),
        ("uint16_t", "slope", slopes, "0x{:04x}"),
        ("uint32_t", "exponent", [number & 0xffffffff for number in exponents], "0x{:08x}")])


if __name__ == "__main__":
    main()
