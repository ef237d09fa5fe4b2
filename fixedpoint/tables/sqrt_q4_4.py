#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes src/fixedpoint/avr/sqrt_q4_4_table.S: the square root of every Q4.4 number, rounded to
nearest; 0 for the negative numbers."""

import math

import page


def nearest_root(n):
    root = math.isqrt(n)
    return root + (n > root * root + root)


if __name__ == "__main__":
    page.write_assembly("sqrt_q4_4_table", "sqrt_q4_4.py", "Square roots of Q4.4 numbers.",
                        [("roots", [nearest_root(16 * n) if n < 128 else 0 for n in range(256)])])
