#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Answers the operands of a division of Q8.24, rounded to nearest, for `fixbench judge --pipe`:

    fixbench operands --operation divide --format q8_24 | answer.py | fixbench judge --pipe --as divide:q8_24
"""
import sys

MIN, MAX = -2**31, 2**31 - 1


def divide(a, b):
    if b == 0:
        return MAX if a > 0 else MIN if a < 0 else 0
    # floor(x + 1/2)
    return max(MIN, min(MAX, ((a << 25) + b) // (2 * b)))


for line in sys.stdin:
    operands = [int(word) for word in line.partition("#")[0].split()]
    if operands:
        print(*operands, divide(*operands))
