#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Proves the largest error of fixedpoint_atan2_q16_16_small for all pairs of operands from its instructions and table.

usage: prove_small_angles.py

    octant       the smaller magnitude N and the larger one D, and the symmetries applied                        by bits
    shifted      both up by bytes while D < 2^16, down by bits while D >= 2^22                                    by bits
    a bit        2 N = b D + the next N, b inverted into r26, which ends with the bit that began as its lead     by bits
    quotient     16 N = q D + R                                                                                   by bits
    divisor      D' = D + q N / 16, rounded downward                                                              by linear forms
    tangent      2^16 R = z D' and a remainder                                                                    by bits
    angle        atan(q / 16) + atan(z / 2^20), in units of 2^-24, plus half an ulp, for every q and z           by running it
    return       the angle of the octant                                                                          by bits

Shifting up is exact: below 2^24, the two bits shifted down afterwards are 0. Shifting down leaves D >= 2^21, so that N / D
is less than 2^-21 below the ratio, or less than N / D times that above it. Since N / D = tan(atan(q / 16) + atan(t)) with
t = R / (16 D + q N), t 2^20 is between z (1 - 1 / D'), or z if q is 0, and z + 1, and R <= D limits z. Then instructions are
left out in turn, and each time the proof must fail.
"""

import sys

import numpy
import z3

from bits import Bits, joined
from machine_code import Program, demand
from prove_angles import HALF_PI, OCTANT, entry, octant
from prove_angles_32 import Rows
from stretches import Linear, equal, zeros

NAME, UP, DOWN, BIT, BYTE = "fixedpoint_atan2_q16_16_small", ".Lfirst_octant", ".Ldown", ".Lbit", ".Lbyte"
DIVIDE, PRODUCT, FINE, CUBE, TURN = ".Ldivide", ".Lproduct", ".Lfine", ".Lcube", ".Lturn"
D, N, COPY, ANGLE = (18, 19, 20), (22, 23, 24), (30, 31, 25), (18, 22, 23)
Q, Z0, Z1, ZERO, ULP = 30, 26, 25, 21, 256
BOUND = 0.651  # ulp


class Dividing(Bits):
    """Knows only the proven effects of the calls: `divisions` are N, D, the lead, the remainder of N, and r26."""

    def __init__(self, program):
        super().__init__(program)
        self.divisions = []

    def copy(self):
        other = super().copy()
        other.divisions = self.divisions[:]
        return other

    def step(self, address):
        mnemonic, _, target, following = self.program.code[address]
        labels = self.program.labels
        if mnemonic != "rcall" or target not in (labels[BIT], labels[BYTE]):
            return super().step(address)
        lead = self.registers[Z0] if target == labels[BIT] else z3.BitVecVal(1, 8)
        before = joined(self, N), joined(self, D), lead
        for register in (*N, Z0):
            self.registers[register] = z3.BitVec(f"divided.{len(self.divisions)}.r{register}", 8)
        self.flags = {"T": self.flags["T"]} if "T" in self.flags else {}
        self.divisions.append((*before, joined(self, N), self.registers[Z0]))
        return [(following, self)]


def shown(m, *conditions):
    demand(all(m.impossible(z3.Not(condition)) for condition in conditions))


def idle(m, *registers):
    """A check that the registers and T are as they are now."""
    before = {register: m.registers[register] for register in registers}

    def check(m):
        demand("T" not in m.flags and all(m.registers[register] is form for register, form in before.items()))
    return check


def ordered(m):
    small, large = m.number(22, 4), m.number(18, 4)
    m.holds.append(z3.ULE(small, large))
    return small, large


def moved_up(m):
    small, large = ordered(m)
    kept = idle(m, OCTANT)

    def check(m, end):
        kept(m)
        n, d = m.number(22, 4), m.number(18, 4)
        if end is None:
            shown(m, large == 0, n == 0)
        elif end == DOWN:
            shown(m, n == small, d == large, z3.UGE(large, 1 << 16))
        else:
            shown(m, n == small << 8, d == large << 8, large != 0, z3.ULT(large, 1 << 16))
    return check


def moved_down(m):
    small, large = ordered(m)
    kept = idle(m, OCTANT)

    def check(m, end):
        kept(m)
        n, d = m.number(22, 4), m.number(18, 4)
        if end == DIVIDE:
            shown(m, n == small, d == large, z3.ULT(large, 1 << 22))
        else:
            shown(m, n == z3.LShR(small, 1), d == z3.LShR(large, 1), z3.UGE(large, 1 << 22))
    return check


def begun(m):
    kept = idle(m, *N, *D, OCTANT, 1, *COPY[:2], Z1)

    def check(m, _):
        kept(m)
        shown(m, m.registers[Z0] == 1)
    return check


def a_bit(m):
    n, d, bits = joined(m, N), joined(m, D), m.registers[Z0]
    m.holds += [z3.ULE(n, d), z3.ULT(d, 1 << 23)]
    kept = idle(m, *D, OCTANT, ZERO, *COPY[:2], Z1)

    def check(m, end):
        kept(m)
        reached = z3.UGE(n << 1, d)
        shown(m, joined(m, N) == (n << 1) - z3.If(reached, d, 0), z3.ULE(joined(m, N), d),
              m.registers[Z0] == (bits << 1) + z3.If(reached, z3.BitVecVal(0, 8), z3.BitVecVal(1, 8)),
              (bits < 0) if end is None else bits >= 0)
    return check


def quotient(m):
    n, d = joined(m, N), joined(m, D)
    m.holds += [z3.ULE(n, d), z3.ULT(d, 1 << 22), m.registers[ZERO] == 0]
    kept = idle(m, *D, OCTANT, ZERO)

    def check(m, _):
        kept(m)
        (of, by, lead, rest, bits), = m.divisions
        shown(m, lead == 0x1f)
        # What began below the lead ends above the four bits of the quotient.
        m.holds.append(z3.Extract(7, 4, bits) == 0xf)
        shown(m, of == n, by == d, joined(m, COPY) == n, joined(m, N) == rest,
              m.registers[Z0] == ~bits << 4)
    return check


def divisor(m):
    m.zero(ZERO)
    d, factor, n, rest = m.number(D), m.registers[Z0], m.number(COPY), m.number(N)
    octant = m.registers[OCTANT]
    for number in (d, n):
        m.hold(0, number, (1 << 22) - 1)
    m.hold(0, factor, 240)
    product = m.times(factor, n)
    m.hold(0, product, 240 << 22)

    def check(m, _):
        demand(m.transfer is None and m.registers[OCTANT] is octant)
        m.show((0, product - (m.number(D) - d) * 256, 255), equal(m.number(N), rest), equal(m.registers[Z0], factor),
               *zeros(m, (ZERO,)))
    return check


def tangent(m):
    n, d, factor = joined(m, N), joined(m, D), m.registers[Z0]
    m.holds.append(m.registers[ZERO] == 0)
    kept = idle(m, OCTANT, ZERO)

    def check(m, _):
        kept(m)
        (first_n, first_d, lead, rest, upper), (second_n, second_d, second_lead, _, lower) = m.divisions
        shown(m, first_n == n, first_d == d, second_n == rest, second_d == d, lead == 1, second_lead == 1,
              m.registers[Z1] == upper, m.registers[Z0] == lower, m.registers[Q] == factor)
    return check


def angle(m, q):
    z = numpy.arange(0, 1 << 16, m.program.stride)
    m.place(~z & 0xffff, (Z0, Z1))
    m.place(numpy.full_like(z, q << 4), (Q,))
    m.registers[ZERO] = 0

    def check(m, _):
        demand(m.untouched(OCTANT) and m.is_zero(1) and m.is_zero(24) and m.transfer is None)
        found = m.number(ANGLE)
        least = 1 + q * q / 256
        reached = z <= 2**16 / (1 + q * (q + 1) / 256) * (1 + 2.0**-15) + 1
        found, tangents = found[reached], z[reached]
        demand((found < 1 << 24).all())
        for moved, smallest in ((0.0, 2**16 * least - 1), (2.0**3 / least, 2**21 * least - 1)):
            ends = [2**24 * (numpy.arctan(q / 16) + numpy.arctan(each / 2.0**20))
                    for each in (tangents * (1 - (q > 0) / smallest), tangents + 1)]
            high, low = (found - ULP / 2 - ends[0]).max() + moved * (q + 1) / 16, (found - ULP / 2 - ends[1]).min() - moved
            demand(0.5 + (max(high, -low) + TURNED) / ULP < BOUND)
            m.program.largest = max(m.program.largest, high, -low)
    return check


TURNED = 1.6  # the errors of subtracting the angle, of multiples of pi/2 and of the computation here


def turned(m):
    (left, below), steep = z3.Bools("left below"), z3.Bool("steep")
    m.registers[OCTANT] = octant(steep, left)
    m.registers[24], m.registers[1] = z3.BitVecVal(0, 8), z3.BitVecVal(0, 8)
    m.flags["T"] = below
    first = z3.ZeroExt(8, joined(m, ANGLE))
    whole = z3.If(steep, z3.If(left, HALF_PI + first, HALF_PI + ULP - 1 - first),
                  z3.If(left, 2 * HALF_PI + ULP - 1 - first, first)) >> 8

    def check(m, _):
        shown(m, m.number(22, 4) == z3.If(below, -whole, whole))
    return check


class Kernel(Program):
    largest = 0.0


ANY = ((),)
STRETCHES = [(NAME, entry, (UP,), (), ANY, (None,)),
             (UP, moved_up, (UP, DOWN, None), (), ANY, (None,)),
             (DOWN, moved_down, (DOWN, DIVIDE), (), ANY, (None,)),
             (BYTE, begun, (BIT,), (), ANY, (None,)),
             (BIT, a_bit, (BIT, None), (), ANY, (None,)),
             (DIVIDE, quotient, (PRODUCT,), (), ANY, (None,)),
             (PRODUCT, divisor, (FINE,), (), ANY, (None,)),
             (FINE, tangent, (CUBE,), (), ANY, (None,)),
             (CUBE, angle, (TURN,), (), [(q,) for q in range(16)], (None,)),
             (TURN, turned, (None,), (), ANY, (None,))]
CUTS = ((DIVIDE, DOWN, "movw", "r30"), (PRODUCT, DIVIDE, "mul", "r30"), (FINE, PRODUCT, "mov", "r30"), (CUBE, FINE, "com", "r26"),
        (TURN, CUBE, "inc", "r27"))


def main():
    failed = False
    for machine, labels in ((Dividing, (NAME, UP, DOWN, BYTE, BIT, DIVIDE, FINE)), (Linear, (PRODUCT,)), (Rows, (CUBE,)),
                            (Bits, (TURN,))):
        program = Kernel(STRETCHES, machine, cuts=CUTS, sources=("atan2_q16_16_small", "arctangent_small_table"))
        failed |= program.run(2, ("ret", "rjmp"), labels)
        if machine is Rows:
            print(f"{NAME}: errs by less than {0.5 + (program.largest + TURNED) / ULP:.6f} ulp, of at most {BOUND}")
    return failed


if __name__ == "__main__":
    sys.exit(main())
