#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes src/fixedpoint/avr/sqrt_q8_8_table.S.

small[a]          the root of the raw number a, rounded to nearest.
value, slope[i]   chords of the root r(a) = 16 sqrt(a): for raw numbers a = base + f
                      i = 16..127:  base = 256 i,          f = 0..255
                      i = 136..255: base = 32 (i - 128),   f = 0..31
                  the estimate (16 value + slope f) >> 8 is the nearest integer to r(a) or one
                  less; of all chords with this property, the one that is exact most often.
                  value has 16 bits: its low byte is bits 11..4, its high byte has bits 15..12 in
                  the low nibble and bits 3..0 in the high one, so that two bytes form the integer.
"""

import math

import page


def nearest_root(a):
    root = math.isqrt(256 * a)
    return root + (256 * a > root * root + root)


def chord(base, length):
    """The best (value, slope)."""
    roots = [nearest_root(base + f) for f in range(length)]
    steepness = 8 * 256 / math.sqrt(base + length / 2)
    best = None
    for slope in range(int(steepness) - 1, int(steepness) + 3):
        rises = [slope * f for f in range(length)]
        # The estimate must not exceed the root, nor stay more than one below it.
        highest = min(256 * root + 255 - rise for root, rise in zip(roots, rises)) // 16
        lowest = -(-max(256 * (root - 1) - rise for root, rise in zip(roots, rises)) // 16)
        for value in range(lowest, highest + 1):
            exact = sum((16 * value + rise) >> 8 == root for root, rise in zip(roots, rises))
            if best is None or exact > best[0]:
                best = (exact, value, slope)
    return best[1:]


if __name__ == "__main__":
    rows = [(0, 0)] * 16 + [chord(256 * i, 256) for i in range(16, 128)]
    rows += [(0, 0)] * 8 + [chord(32 * i, 32) for i in range(8, 128)]
    page.write_assembly("sqrt_q8_8_table", "sqrt_q8_8.py", "Square roots of Q8.8 numbers.", [
        ("small", [nearest_root(a) for a in range(256)]),
        ("value, bits 11..4", [value >> 4 & 255 for value, _ in rows]),
        ("value, bits 3..0 and 15..12", [(value & 15) << 4 | value >> 12 for value, _ in rows]),
        ("slope", [slope for _, slope in rows])])
