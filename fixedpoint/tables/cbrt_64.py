#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/cbrt_64_table.S and portable/cbrt_64_table.hpp: the cube
root on [1, 2], from which that of Q32.32 starts, and the halves of the cube roots of 1, 2 and 4."""

from fractions import Fraction

import cubic

GUARD = 24


def cube_root(x):
    """The largest integer whose cube is at most x."""
    root = 1 << -(-x.bit_length() // 3)
    while root**3 > x:
        root = (2 * root + x // root**2) // 3
    return root


def scaled(numerator, denominator):
    """cbrt(1 + x) - 1 without the half ulp that cubic.py adds, plus an offset that keeps all values >= 0."""
    unit = 1 << 39 + GUARD
    return Fraction(cube_root((numerator + denominator) * unit**3 // denominator) - unit,
                    1 << GUARD) - cubic.CORE_64.half_ulp + 9


if __name__ == "__main__":
    halves = [cube_root(2**remainder << 3 * 55) for remainder in range(3)]
    cubic.write("cbrt_64_table", "cbrt_64.py",
                "cbrt(1 + x) - 1 + 9 2^-39 - half an ulp of Q32.32 on 256 intervals of [0, 1], cubics in the\n"
                "layout of tables/cubic.py.",
                "Cbrt64Table", scaled, [
                    ("half the cube roots of 1, 2 and 4 in units of 2^-56",
                     [root >> 8 * i & 255 for root in halves for i in range(7)])],
                core=cubic.CORE_64)
