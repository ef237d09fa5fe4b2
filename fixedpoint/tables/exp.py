#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/exp_table.S and portable/exp_table.hpp: the exponential
function at 256 nodes and the reduction of its argument by multiples of ln 2, for Q16.16.

x - k ln 2 in units of 2^-16 is 256 h + l + tail + 1/16, with h in -128..127 and l, the low byte of
raw + offset, in 0..255. The node of h is 256 h + 128 + 1/16, so l - 128 + tail is the distance from
it; its exponential minus 1 is within -128 .. 128 units, a signed byte and a fraction, except for
l = 255 if tail exceeds 0.87."""

from fractions import Fraction

import page
import table_header
from exponential_series import exponential, logarithm

FRACTION_BITS = 39
FIRST, FIRST_LARGE, LAST = -17, 4, 16
GUARD = 64
NODE_SHIFT = Fraction(1, 16)
# The mean truncation of the products, in units of the last bit of the tail.
SMALL_LOSS, LARGE_LOSS = 3, 64
# Leaves room for the 31 / 256 that the square adds at l = 255. Results for which this limits the
# tail are small.
LARGEST_SMALL_TAIL = 224


def power(index):
    h = index - 256 if index >= 128 else index
    return exponential(16 * (256 * h + 128) + 1, 1 << 20, FRACTION_BITS)


def reduction(k):
    """(offset, tail) of k, exact."""
    # k = 16 is out of range for every result: half a unit less leaves mantissas of at least 1,
    # which saturate.
    multiple = Fraction(31, 2) if k == LAST else k
    shift = -multiple * Fraction(logarithm(2, 1, 16 + GUARD), 1 << GUARD) - NODE_SHIFT
    offset = shift.numerator // shift.denominator
    return offset & 0xffff, shift - offset


SENTENCE = """\
2^39 e^x at the nodes x = (256 h + 128 + 1/16) / 2^16, where h is the index as a signed byte. For k
from -17 to 16: offset and tail, the first 16 and the next 24 fraction bits of -k ln 2 - 2^-20; below
k = 4 the tail has 8 bits."""


def main():
    powers = [power(index) for index in range(256)]
    offsets, tails = [], []
    for k in range(FIRST, LAST + 1):
        offset, tail = reduction(k)
        offsets.append(offset)
        if k < FIRST_LARGE:
            small = int(256 * tail + Fraction(1, 2)) + SMALL_LOSS
            tails.append(min(small, LARGEST_SMALL_TAIL) << 16)
        else:
            tails.append(int(tail * 2**24 + Fraction(1, 2)) + LARGE_LOSS)
    large_tails = tails[FIRST_LARGE - FIRST:]
    records = [offset & 255 for offset in offsets] + [offset >> 8 for offset in offsets]
    records += [tail >> 16 for tail in tails]
    records += [1 << (index & 7) for index in range(len(offsets))]
    records += [tail >> 8 & 255 for tail in large_tails] + [tail & 255 for tail in large_tails]
    page.write_assembly("exp_table", "exp.py", SENTENCE, [
        *((f"power, bits {bit}..{bit + 7}", [value >> bit & 255 for value in powers])
          for bit in (32, 24, 16, 8, 0)),
        ("by k: offset low, high; tail, bits 16..23; 2^((k + 1) mod 8); tail, bits 8..15, 0..7",
         records)])
    table_header.write("exp_table", "exp.py", SENTENCE, "ExpTable", [
        ("uint32_t", "power", [value >> 8 for value in powers], "0x{:08x}"),
        ("uint8_t", "power_low", [value & 255 for value in powers], "0x{:02x}"),
        ("uint16_t", "offset", offsets, "0x{:04x}"),
        ("uint32_t", "tail", tails, "0x{:06x}")])


if __name__ == "__main__":
    main()
