#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/arc_sine_table.S and portable/arc_sine_table.hpp: parabolas
on intervals of 1/64, for Q16.16, of the arc sine from 0 to 1/2 and of the root that reduces larger
arguments to that range."""

from fractions import Fraction
from math import isqrt

import page
import table_header
from parabola import WHOLE, parabola
from series import arc_sine

INTERVALS = 64
ARCS = INTERVALS // 2 + 1
FIRST_ROOT = INTERVALS // 4
ARC_UNIT = 23  # the unit is 2^-23
ROOT_UNIT = 22
GUARD = 40
HALF_ULP = 64
BEND_BITS = 7


def arc(i):
    """asin x - x."""
    def exact(t):
        position = i * WHOLE + t
        excess = arc_sine(position, INTERVALS * WHOLE, ARC_UNIT + GUARD)
        return Fraction(excess, 1 << GUARD) - Fraction(position << ARC_UNIT, INTERVALS * WHOLE)

    return exact


def root(i):
    """sqrt(x / 2)."""
    def exact(t):
        half = ((i * WHOLE + t) << 2 * (ROOT_UNIT + GUARD)) // (2 * INTERVALS * WHOLE)
        return Fraction(isqrt(half), 1 << GUARD)

    return exact


SENTENCE = """\
For the arc sine from 0 on, in units of 2^-23: asin x - x plus 64, half an ulp of Q16.16; the rise of
its chord over 1/64; the height of the chord above the middle of the curve. For sqrt(x / 2) from
x = 1/4 on, in units of 2^-22: value, rise and the height of the curve above the middle of its chord."""


def main():
    arcs = [parabola(arc(i), BEND_BITS) for i in range(ARCS)]
    arcs = [(value + HALF_ULP, slope, bend) for value, slope, bend in arcs]
    roots = [parabola(root(i), BEND_BITS) for i in range(FIRST_ROOT, INTERVALS)]
    records = []
    for value, slope, bend in arcs + roots:
        records += [value & 255, value >> 8 & 255, value >> 16, slope & 255, slope >> 8, bend]
    page.write_assembly("arc_sine_table", "arc_sine.py", SENTENCE, [
        ("three bytes of value, two of slope, the bend; first the arcs, then the roots", records)], 1)
    table_header.write("arc_sine_table", "arc_sine.py", SENTENCE, "ArcSineTable", [
        (kind, f"{name}_{member}", [row[k] for row in rows], form)
        for name, rows in (("arc", arcs), ("root", roots))
        for k, (kind, member, form) in enumerate([("uint32_t", "value", "0x{:06x}"),
                                                  ("uint16_t", "slope", "0x{:04x}"),
                                                  ("uint8_t", "bend", "0x{:02x}")])])


if __name__ == "__main__":
    main()
