#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/log2_table.S and portable/log2_table.hpp: parabolas of the
binary logarithm on 128 intervals of [1, 2], for Q16.16, in units of 2^-7 ulp."""

from fractions import Fraction

import page
import table_header
from exponential_series import logarithm
from parabola import WHOLE, parabola

INTERVALS = 128
UNIT = 23  # the unit is 2^-23
GUARD = 40
HALF_ULP = 64
BEND_BITS = 8


def curve(i):
    """log2(1 + i/128 + t/128) on the interval, minus t/2, which the kernel adds itself."""
    def exact(t):
        ln = logarithm(INTERVALS * WHOLE + i * WHOLE + t, INTERVALS * WHOLE, UNIT + GUARD)
        return Fraction(ln << UNIT, logarithm(2, 1, UNIT + GUARD)) - Fraction(t, 2)

    return exact


SENTENCE = """\
log2(1 + i/128) 2^23 + 64, which includes half an ulp of Q16.16, so that truncating 7 bits rounds; the
rise of the chord over the interval, minus 2^15; twice the height of the curve above its middle."""


def main():
    values, slopes, bends = zip(*(parabola(curve(i), BEND_BITS) for i in range(INTERVALS)))
    values = [value + HALF_ULP for value in values]

    def byte(numbers, i):
        return [number >> 8 * i & 255 for number in numbers]

    page.write_assembly("log2_table", "log2.py", SENTENCE, [
        ("slope, bits 0..7", byte(slopes, 0)),
        ("value, bits 0..7", byte(values, 0)),
        ("slope, bits 8..15", byte(slopes, 1)),
        ("value, bits 8..15", byte(values, 1)),
        ("bend", bends),
        ("value, bits 16..23", byte(values, 2)),
        ("128 + log2 of a byte, indexed by its upper 7 bits", [128 + max(0, (2 * i).bit_length() - 1)
                                                       for i in range(128)]),
        ("the factor that moves the leading one to bit 7, indexed by that logarithm",
         [1 << (7 - i) for i in range(8)])])
    table_header.write("log2_table", "log2.py", SENTENCE, "Log2Table", [
        ("uint32_t", "value", values, "0x{:06x}"),
        ("uint16_t", "slope", slopes, "0x{:04x}"),
        ("uint8_t", "bend", bends, "0x{:02x}")])


if __name__ == "__main__":
    main()
