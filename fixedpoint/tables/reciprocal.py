#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes src/fixedpoint/avr/reciprocal_table.S: the factors that turn a divisor into a power of two
less at most a 256th of it.

power[i]       2^(7 - floor(log2 i)), i = 1..255: moves the leading one of a byte to bit 7.
reciprocal[i]  floor(2^17 / (257 + i)) - 256, the low byte of the largest v with v D < 2^17 for
               every D, 256 + i <= D < 257 + i. With v or with v + 1, 2^17 - v D is above 0 and
               below 512.
"""

import page


def power(byte):
    return 2**(8 - byte.bit_length()) if byte else 0


def reciprocal(index):
    v = 2**17 // (257 + index)
    # v + 1 is used if 2^17 - v D >= 512, which exceeds every D; the same must then hold for it.
    assert 257 + index <= 512 and 2**17 - (v + 1) * (256 + index) < 512
    return v - 256


if __name__ == "__main__":
    page.write_assembly("reciprocal_table", "reciprocal.py",
                        "Powers of two and reciprocals for scaling divisors.",
                        [("powers of two", [power(byte) for byte in range(256)]),
                         ("reciprocals", [reciprocal(index) for index in range(256)])])
