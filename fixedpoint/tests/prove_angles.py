#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Proves an error bound of fixedpoint_atan2_q16_16 for all pairs of operands, from its instructions
and tables.

usage: prove_angles.py

The code is cut where intermediate results have 24 bits:

    octant       the smaller magnitude and the larger one, and what has been folded                by bits
    normalised   N and D, which are these, cut to 24 bits from the leading one of D on             by bits
    reciprocal   2^47 / D, for every D                                                             by running it
    arctangent   the ratio N / D in 24 bits                                                        by linear forms
    folded       2^24 of its arc tangent and half an ulp, for every ratio                          by running it
    return       the angle of the octant                                                           by bits

The errors are added up for every ratio r: that of the arc tangent, and those of r, which enter the
angle with the factor 1 / (1 + r^2). That of the reciprocal is relative and enters with the factor r
/ (1 + r^2). Then instructions are left out in turn, and each time the proof must fail.
"""

import sys

import numpy
import z3

from arrays import Arrays
from bits import Bits, joined
from form import known
from machine_code import Program, demand
from stretches import Linear

NAME = "fixedpoint_atan2_q16_16"
D, N, RECIPROCAL, RATIO, ANGLE = (20, 21, 30), (18, 19, 25), (31, 24, 26), (20, 21, 30), (31, 22, 23)
OCTANT = 27
HALF_PI, PI, ULP = 26353589, 52707179, 256
# In units of 2^-24: of the relative error of the reciprocal, of the ratio cut from it, of the numbers cut to 24 bits.
CUT, SHORT = 10, 2
LARGEST = 0xd00000  # above pi/4
RECIPROCALS, ANGLES = (-33.4, 32.2), (-12.2, 12.4)
CHUNK = 1 << 18
BOUND = 0.645  # ulp


class Kernel(Program):
    """`found` is the largest and the smallest result over all cases."""
    found = {"reciprocal": (0.0, 0.0), "angle": (0.0, 0.0)}

    def within(self, name, low, high, numbers):
        demand(low < numbers.min() and numbers.max() < high)
        if self.stride == 1:
            least, most = self.found[name]
            self.found[name] = min(least, float(numbers.min())), max(most, float(numbers.max()))


def octant(steep, left):
    return z3.If(steep, z3.BitVecVal(1, 8), z3.BitVecVal(0, 8)) | z3.If(left, z3.BitVecVal(2, 8), z3.BitVecVal(0, 8))


def entry(m):
    y, x = m.number(22, 4), m.number(18, 4)
    height, width = (z3.If(number < 0, -number, number) for number in (y, x))
    steep = z3.UGT(height, width)

    def check(m, end):
        demand(m.impossible(z3.Not(z3.And(
            m.number(22, 4) == z3.If(steep, width, height), m.number(18, 4) == z3.If(steep, height, width),
            m.registers[1] == 0, m.registers[OCTANT] == octant(steep, x < 0), m.flags["T"] == (y < 0)))))
    return check


def magnitudes(m):
    small, large, kept = m.number(22, 4), m.number(18, 4), m.registers[OCTANT]
    m.holds.append(z3.ULE(small, large))

    def check(m, end):
        if end is None:
            demand(m.impossible(z3.Or(large != 0, m.number(22, 4) != 0)))
            return
        demand(m.registers[OCTANT] is kept and "T" not in m.flags)
        d, n = joined(m, D), joined(m, N)
        shifted = [z3.And(z3.LShR(large << k, k) == large, z3.Extract(31, 8, large << k) == d,
                          z3.Extract(31, 8, small << k) == n) for k in range(32)]
        demand(m.impossible(z3.Not(z3.And(z3.Or(*shifted), d < 0))))
    return check


def every(m, first, registers):
    """The numbers of a case, in the registers."""
    numbers = numpy.arange(first, first + CHUNK, m.program.stride)
    m.place(numbers, registers)
    return numbers


def reciprocal(m, first):
    d = every(m, first, D)

    def check(m, end):
        demand(all(map(m.untouched, (*N, OCTANT))))
        m.program.within("reciprocal", *RECIPROCALS, (m.number(RECIPROCAL) * (d / 2.0**47) - 1) * 2**24)
    return check


def ratio(m):
    product = m.times(m.number(N), m.number(RECIPROCAL)) * 2
    octant = m.registers[OCTANT]

    def check(m, end):
        demand(m.registers[OCTANT] == octant)
        found = m.number(RATIO)
        if found == known((1 << 24) - 1):
            m.show((1 << 48, product, None))
        else:
            m.show((0, product - found * (1 << 24), CUT << 24))
    return check


def folded(m, first):
    r = every(m, first, RATIO) / 2.0**24

    def check(m, end):
        demand(m.untouched(OCTANT) and m.is_zero(1))
        demand((m.number(ANGLE) < LARGEST).all())
        error = m.number(ANGLE) - ULP / 2 - numpy.arctan(r) * 2**24
        m.program.within("angle", *ANGLES, error)
        low, high = m.program.found["reciprocal"]
        part = 1 / (1 + r * r)
        # As what is said of r holds of the quotient nearly, and of what is computed here.
        for each in (error + part * (high * r + SHORT) + 0.01, part * (CUT + SHORT - low * r) + 0.01 - error):
            demand(0.5 + (each.max() + 0.5) / ULP < BOUND)
    return check


def angle(m):
    (left, below), steep = z3.Bools("left below"), z3.Bool("steep")
    m.registers[OCTANT] = octant(steep, left)
    m.flags["T"] = below
    first = z3.ZeroExt(8, joined(m, ANGLE))
    whole = z3.If(steep, z3.If(left, first + HALF_PI, HALF_PI + ULP - first), z3.If(left, PI + ULP - first, first)) >> 8
    m.holds.append(z3.ULT(first, LARGEST))

    def check(m, end):
        demand(m.impossible(m.number(22, 4) != z3.If(below, -whole, whole)))
    return check


STRETCHES = [(NAME, entry, (".Lfirst_octant",), (), ((),), (None,)),
             (".Lfirst_octant", magnitudes, (".Lnormalised", None), (), ((),), (None,)),
             (".Lnormalised", reciprocal, (".Lreciprocal",), (), [(i,) for i in range(1 << 23, 1 << 24, CHUNK)], (None,)),
             (".Lreciprocal", ratio, (".Larctangent",), (), ((),), (None,)),
             (".Larctangent", folded, (".Lfolded_angle",), (), [(i,) for i in range(0, 1 << 24, CHUNK)], (None,)),
             (".Lfolded_angle", angle, (None,), (), ((),), (None,))]


def main():
    failed = False
    for machine, every_other, labels in ((Bits, 8, (NAME, ".Lfirst_octant")), (Arrays, 1, (".Lnormalised", ".Larctangent")),
                                         (Linear, 2, (".Lreciprocal",)), (Bits, 4, (".Lfolded_angle",))):
        program = Kernel(STRETCHES, machine, cuts=(
            (".Lreciprocal", ".Lnormalised", "mul", "r25"), (".Lfolded_angle", ".Larctangent", "ldi", "r24")),
            sources=("atan2_q16_16", "long_division_table", "ratio_table", "arctangent_table"))
        failed |= program.run(every_other, ("ret", "rjmp"), labels)
    return failed


if __name__ == "__main__":
    sys.exit(main())
