#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/exp_64_table.S and portable/exp_64_table.hpp: the multiples
of ln 2, and the powers of e whose product is the exponential function of Q32.32."""

from fractions import Fraction

import page
import table_header
from exponential_series import exponential, logarithm

BITS = 72
GUARD = 24
LN2 = logarithm(2, 1, BITS + GUARD)
# e^a is a power of two, from 2^-33 to 2^33, times e^-x with x below 200/256.
POWERS = range(-33, 34)
COARSE = 200


def rounded(x):
    return x + (1 << GUARD - 1) >> GUARD


def power(numerator, denominator):
    """e^(-numerator/denominator) in units of 2^-72."""
    return Fraction(exponential(-numerator, denominator, BITS + GUARD), 1 << GUARD)


def nearest(x):
    return (2 * x.numerator + x.denominator) // (2 * x.denominator)


def bytes_of(number, count):
    return [number >> 8 * i & 255 for i in range(count)]


if __name__ == "__main__":
    multiples = [rounded(k * LN2) % (1 << BITS) for k in POWERS]
    coarse = [min(nearest(power(i, 256)), (1 << BITS) - 1) for i in range(COARSE)]
    fine = [(1 << BITS) - nearest(power(i, 65536)) for i in range(256)]
    assert max(fine) < 1 << 64
    sentence = ("k ln 2 modulo 1, e^(-i/256) and 1 - e^(-i/65536), all in units of 2^-72, 1 itself as one "
                "unit less.")
    page.write_assembly("exp_64_table", "exp_64.py", sentence, [
        ("1 - e^(-i/65536), 8 bytes", [byte for n in fine for byte in bytes_of(n, 8)]),
        ("e^(-i/256), 9 bytes", [byte for n in coarse for byte in bytes_of(n, 9)]),
        ("k ln 2 from k = -33 on, 9 bytes", [byte for n in multiples for byte in bytes_of(n, 9)])], 1)
    table_header.write("exp_64_table", "exp_64.py", sentence, "Exp64Table", [
        ("uint64_t", "multiple", [n >> 8 for n in multiples], "0x{:016x}"),
        ("uint8_t", "multiple_low", [n & 255 for n in multiples], "0x{:02x}"),
        ("uint64_t", "coarse", [n >> 8 for n in coarse], "0x{:016x}"),
        ("uint8_t", "coarse_low", [n & 255 for n in coarse], "0x{:02x}"),
        ("uint64_t", "fine", fine, "0x{:016x}")])
