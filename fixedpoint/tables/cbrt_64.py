#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/cbrt_64_table.S and portable/cbrt_64_table.hpp: the cube root of
[1, 2], where that of Q32.32 begins, and the halves of the cube roots of 1, 2 and 4."""

from fractions import Fraction

import cubic

GUARD = 24


def cube_root(x):
    """The largest integer whose cube is x at most."""
    root = 1 << -(-x.bit_length() // 3)
    while root**3 > x:
        root = (2 * root + x // root**2) // 3
    return root


def scaled(numerator, denominator):
    """cbrt(1 + x) - 1 without the half ulp that cubic.py adds, but with what keeps all values from 0 on."""
    unit = 1 << 39 + GUARD
    return Fraction(cube_root((numerator + denominator) * unit**3 // denominator) - unit,
                    1 << GUARD) - cubic.CORE_64.half_ulp + 9


if __name__ == "__main__":
    halves = [cube_root(2**remainder << 3 * 55) for remainder in range(3)]
    cubic.write("cbrt_64_table", "cbrt_64.py",
                "cbrt(1 + x) - 1, 9 2^-39 more and half an ulp of Q32.32 less, on 256 intervals of [0, 1], cubics\n"
                "in the layout of tables/cubic.py.",
                "Cbrt64Table", scaled, [
                    ("half the cube roots of 1, 2 and 4 in units of 2^-56",
                     [root >> 8 * i & 255 for root in halves for i in range(7)])],
                core=cubic.CORE_64)
