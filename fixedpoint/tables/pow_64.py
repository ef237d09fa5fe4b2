#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/pow_64_table.S and portable/pow_64_table.hpp: the factors that
bring a mantissa from [1, 2) down to 1 + s, s < 2^-23, and their logarithms, for pow of Q32.32.

A factor is (1 - d 2^-8p)(1 - d' 2^-8p'), where d and d' are bytes. It is chosen by the leading bits
of s: the one that leaves the smallest s while no number of the interval comes below 1."""

from fractions import Fraction

import page
import table_header
from exponential_series import logarithm

BITS = 104
GUARD = 24
# The leading one of an unsigned number of Q32.32 is in 2^-32..2^31.
BIAS = 32


def rounded(x):
    return int((x * 2 + 1) // 2)


def minus_logarithm(factor):
    """-ln(factor) in units of 2^-104; the factor must be in [1/2, 1]."""
    return Fraction(logarithm(factor.denominator, factor.numerator, BITS + GUARD), 1 << GUARD)


def digit(excess, place):
    """The largest d for which (1 + excess)(1 - d 2^-8place) is at least 1."""
    return min(int(excess / (1 + excess) * 256**place), 255)


def step(largest, index_bits, places):
    """For s up to `largest`, indexed in units of 2^-index_bits: the digits and the logarithm of each
    interval, and the largest remaining s."""
    rows, left = [], 0
    for index in range(int(largest * 2**index_bits) + 1):
        start = Fraction(index, 2**index_bits)
        end = min(start + Fraction(1, 2**index_bits), largest)
        digits = []
        for place in places:
            digits.append(digit(start, place))
            start, end = (s - (1 + s) * Fraction(digits[-1], 256**place) for s in (start, end))
        factor = Fraction(1)
        for d, place in zip(digits, places):
            factor *= 1 - Fraction(d, 256**place)
        rows.append((digits, minus_logarithm(factor)))
        left = max(left, end)
    return rows, left


def bytes_of(number, count):
    return [number >> 8 * i & 255 for i in range(count)]


if __name__ == "__main__":
    ln2 = rounded(Fraction(logarithm(2, 1, BITS + GUARD), 1 << GUARD))
    first, left = step(Fraction(1) - Fraction(1, 2**64), 6, (1,))
    second, left = step(left, 12, (1, 2))
    third, left = step(left, 18, (2, 3))
    fourth, left = step(left, 24, (3,))
    assert left <= Fraction(1, 2**23)
    steps = [[(digits, rounded(logarithm)) for digits, logarithm in rows]
             for rows in (first, second, third, fourth)]
    steps[0] = [(digits, logarithm - BIAS * ln2) for digits, logarithm in steps[0]]
    sizes = [14, 13, 12, 11]
    for rows, size in zip(steps[1:], sizes[1:]):
        assert max(logarithm for _, logarithm in rows) < 1 << 8 * size
    sentence = (
        "The digits of the factors 1 - d 2^-8, then with d 2^-8 and d' 2^-16, d 2^-16 and d' 2^-24, d 2^-24,\n"
        "and minus their logarithms in units of 2^-104; those of the first are 32 ln 2 less. Then ln 2.")
    print([len(rows) for rows in steps], float(left * 2**23))
    page.write_assembly("pow_64_table", "pow_64.py", sentence, [
        (f"step {number}: {len(rows)} records of {len(rows[0][0]) + size} bytes",
         [byte for digits, logarithm in rows for byte in digits + bytes_of(logarithm, size)])
        for number, (rows, size) in enumerate(zip(steps, sizes), 1)
    ] + [("ln 2", bytes_of(ln2, 13))], 1)
    arrays = []
    for name, rows in zip(("first", "second", "third", "fourth"), steps):
        arrays += [
            ("uint16_t", f"{name}_digits", [sum(d << 8 * i for i, d in enumerate(reversed(digits)))
                                            for digits, _ in rows], "0x{:04x}"),
            ("uint64_t", f"{name}_upper", [n >> 64 & (1 << 64) - 1 for _, n in rows], "0x{:016x}"),
            ("uint64_t", f"{name}_lower", [n & (1 << 64) - 1 for _, n in rows], "0x{:016x}")]
    arrays += [("uint64_t", "ln2", [ln2 & (1 << 64) - 1, ln2 >> 64], "0x{:016x}")]
    table_header.write("pow_64_table", "pow_64.py", sentence, "Pow64Table", arrays)
