#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes src/fixedpoint/avr/reciprocal_table.S: what a divisor is multiplied with so that it becomes
a power of two, or a little less.

power[i]       2^(7 - floor(log2 i)), i = 1..255: moves the leading one of a byte to bit 7.
reciprocal[i]  floor(2^17 / (257 + i)) - 256, the low byte of the largest v with v D < 2^25 for
               every D < 257 + i (in units of the index, D = 256 + i and a fraction). The next
               larger v fits the D of an interval where 2^25 - v D >= D, scaled likewise.
"""

import page


def power(byte):
    return 2**(8 - byte.bit_length()) if byte else 0


def reciprocal(index):
    return 2**17 // (257 + index) - 256


if __name__ == "__main__":
    page.write_assembly("reciprocal_table", "reciprocal.py",
                        "Powers of two and reciprocals, by which divisors are scaled.",
                        [("powers of two", [power(byte) for byte in range(256)]),
                         ("reciprocals", [reciprocal(index) for index in range(256)])])
