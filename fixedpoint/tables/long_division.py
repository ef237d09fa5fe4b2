#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes src/fixedpoint/avr/long_division_table.S: the factor that moves the leading one of a byte to
bit 7, and the reciprocal of a byte whose leading one is there.

byte 1..127:   2^(7 - floor(log2 byte)); entry 0 is 0, the reciprocal of 256 in the form below.
byte 128..255: ceil(2^16 / byte) - 1 - 256, the low byte of the largest number v with
               byte v < 2^16, by which Moeller and Granlund divide two digits by one (Improved
               division by invariant integers, 2011).
"""

import page


def power(byte):
    return 2**(8 - byte.bit_length()) if byte else 0


def reciprocal(byte):
    return (2**16 - 1) // byte - 256


if __name__ == "__main__":
    page.write_assembly("long_division_table", "long_division.py",
                        "Powers of two and reciprocals for normalising divisors.",
                        [("powers of two", [power(byte) for byte in range(128)]),
                         ("reciprocals", [reciprocal(byte) for byte in range(128, 256)])])
