#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Proves the bounds that avr/roots_q16_16_small.S states for the reciprocal root Y of M,
2^30 <= M < 2^32, with its coefficients: Y is below 2^16, not above 2^31 / sqrt(M), and less than
2^-11 of it below. Y depends only on the upper half of M; every one is tried, at both ends.

The coefficients were chosen among all those near the minimax polynomial: of those for which the
reciprocal square root has the smallest error, the ones whose Y is closest to the root, so that the
square root tests the fewest candidates."""

from math import sqrt

C0, C1, C3, BIAS = 128, 59, 198, 12


def reciprocal_root(upper):
    z = 255 - (upper >> 8)
    seed = C0 + (z * (C1 + ((z * z >> 8) * C3 >> 8)) >> 8)
    error = 0x8000 - BIAS - 2 * ((upper * seed >> 8) * seed >> 8)
    return (seed << 8) + (error * seed >> 8) + (error >> 8) ** 2


if __name__ == "__main__":
    least, most = 1.0, 0.0
    for upper in range(1 << 14, 1 << 16):
        root = reciprocal_root(upper)
        assert root < 1 << 16
        least = min(least, 1 - root * sqrt((upper << 16) + 0xffff) / 2**31)
        most = max(most, 1 - root * sqrt(upper << 16) / 2**31)
    assert 0 <= least and most < 2**-11
    print(f"{-BIAS} {C0} {C1} {C3}: low by {least:.1e} to {most:.1e}")
