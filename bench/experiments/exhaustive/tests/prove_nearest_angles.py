#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Proves that atan2 of CorrectlyRounded is correctly rounded in Q16.16 for all pairs of operands, from the machine code that is
measured.

usage: prove_nearest_angles.py FOLDER    the folder of the device programs

The kernel first computes the angle with the 32-bit core; less than DOUBT units of 2^-31 from a tie, another kernel decides:

    octant       the smaller magnitude and the larger one, n and d, and what has been folded             by bits
    ratio        2^32 n / d, less up to RATIO_REST, by the digits that prove_angles_32 proves            by linear forms
    core         V + t (S - t (b + w t2 / 256)) with all parts in units of 2^-31                         by running it, by linear forms
    unfold       the angle of the octant, rounded, if the sum is not in doubt                            by bits
    mirrored     in doubt: the shorter coordinate and the longer one, shifted to 32 bits                 by bits
    ties         for each of the 411,774 ties, four digits and the tangent of the rest                   by running it
    turned       the vector, turned back by the digits, exactly                                          by linear forms
    compared     its ratio with that tangent, with an error of at most LOST_PRODUCT                      by linear forms

So a direction is compared with one that depends only on tie and octant: V = y A - x B is compared with 0, where A and B do. For
each tie, that one, by that error, is between the two fractions with denominators up to 2^31 that are closest to the tie, from
below and from above. They are found exactly, by continued fractions. No tie is within 2^-21 of a multiple of pi/4: directions in
doubt are in the octant of their tie. Half of the ties, the odd multiples of 2^-17, are those of Q16.16; the others are those of
the formats with fewer fraction bits.

Then instructions are left out in turn, and each time the proof must fail; of those that run for every tie, a third may not
matter.
"""
import sys
from functools import partial
from pathlib import Path

import numpy
import z3
from mpmath import mp, mpf

from calling import FRAME, Bits, machine_code, shown
from framed import Framed
from machine_code import CALL_SAVED, Program, Unprovable, demand
from form import Form, known
from prove_angles_32 import (ARCTANGENT, FOURTH, LOST, RECORD, Core, Ratio, Rows, arc_tangent, differences, digit, dividend, reciprocal,
                             rows, scaled)
from prove_quotients import check_table
from stretches import Linear, equal, zeros

machine_code.STEPS = 2000
EVERY = 5  # of the instructions that run for every tie, one in this many is left out
TIMEOUT = 60000  # milliseconds of a question to z3
SIDE, TABLE = "fixedpoint_angle_reaches_q16_16", "fixedpoint_short_turns_table"
A32, B32, TIE = (22, 4), (18, 4), (14, 4)


# The kernel that compares an angle with a tie


SHIFT, REDUCE, VECTOR, TURNS, PRODUCT, COMPARE = (
    ".Lshift", ".Lreduce", ".Lvector", (".Lturn1", ".Lturn2", ".Lturn3", ".Lturn4"), ".Lproduct", ".Lcompare")
SIDE_CUTS = ((".Lexchange", SIDE, "cp", "r18"), (SHIFT, ".Lexchange", "and", "r21"), (REDUCE, SHIFT, "eor", "r7"),
             (VECTOR, REDUCE, "in", "r28"), *((name, VECTOR, "ldd", f"Y+{13 - i}") for i, name in enumerate(TURNS)),
             (PRODUCT, TURNS[-1], "push", "r20"), (COMPARE, PRODUCT, "neg", "r21"))
X, Y, ZERO = range(2, 12), range(12, 22), 31
# On the stack, after the registers of the caller: what stands there under these numbers.
LONGER, SHORTER, OCTANT, TURN_DIGITS, TANGENT, HEIGHT = (
    (103, 102, 101, 100), (107, 106, 105, 104), 108, (109, 110, 111, 112), range(121, 112, -1), range(130, 121, -1))
SAVED = tuple(CALL_SAVED)
MIRRORED = (*SAVED, *range(100, 109))
REDUCED = (*MIRRORED, *range(109, 122))
MULTIPLIED = (*REDUCED, *range(122, 131))
OCTANTS = {(False, False): 0, (True, False): 3, (False, True): 5, (True, True): 6}  # (steep, left)
TOP_OF_STACK = 0x0800
# Of each turn: the fraction bits of its digit, and of what power of two the vector must be a multiple before it, as the turn
# leaves out the bytes below.
TURNED_BY, MULTIPLE_OF = (8, 8, 16, 16), (40, 40, 16, 16)  # the latter in bits
# Of the product, in units of its last place: the lower bytes of 9 products, and 36 whole ones.
LOST_PRODUCT = -(-(9 * 255 * 2**64 + sum((k + 1) * 255**2 * 2**(8 * k) for k in range(8))) // 2**72)


def with_frame(base, unknown, constant):
    """What is on the stack is also read at addresses, which are known."""
    class OnStack(base):
        def __init__(self, program):
            super().__init__(program)
            self.saved = self.saved | {n: unknown(self, n) for n in range(100, 131)}
            self.upper = None

        def point(self, low):
            """The stack pointer."""
            for i in range(2):
                self.registers[low + i] = constant(TOP_OF_STACK - len(self.stack) >> 8 * i & 255)

        def demand_pointer(self):
            demand(self.pointer(28) == TOP_OF_STACK - len(self.stack))

        def pointer(self, low):
            parts = [self.registers[low + i] for i in range(2)]
            return sum((part.constant() if isinstance(part, Form) else part) << 8 * i for i, part in enumerate(parts))

        def step(self, address):
            mnemonic, operands, _, following = self.program.code[address]
            if mnemonic == "ldd":
                at = TOP_OF_STACK - self.pointer({"Y": 28, "Z": 30}[operands[1][0]]) - int(operands[1][2:])
                demand(0 <= at < len(self.stack) and not isinstance(self.stack[at], int), "what is read is not on the stack")
                self.registers[int(operands[0][1:])] = self.stack[at]
                return [(following, self)]
            if mnemonic == "in" and operands[1] in ("0x3d", "0x3e"):
                self.registers[int(operands[0][1:])] = constant(
                    TOP_OF_STACK - len(self.stack) >> 8 * (operands[1] == "0x3e") & 255)
                return [(following, self)]
            if mnemonic == "out" and operands[0] == "0x3e":
                self.upper = operands[1]
            if mnemonic == "out" and operands[0] == "0x3d":
                demand(self.upper == f"r{int(operands[1][1:]) + 1}", "half of the stack pointer is not set")
                length = TOP_OF_STACK - self.pointer(int(operands[1][1:]))
                demand(0 <= length <= len(self.stack), "the stack does not balance")
                self.stack = self.stack[:length]
            if mnemonic in FRAME:
                return [(following, self)]
            return super().step(address)
    return OnStack


def side_entry(m):
    y, x = m.number(*A32), m.number(*B32)
    tie = {n: m.registers[n] for n in range(14, 18)}
    height, width = (z3.If(number < 0, -number, number) for number in (y, x))
    steep, left = z3.UGT(height, width), x < 0

    def check(m, _):
        octant = z3.BitVecVal(0, 8)
        for case, value in OCTANTS.items():
            octant = z3.If(z3.And(steep == case[0], left == case[1]), z3.BitVecVal(value, 8), octant)
        shown(m, m.registers[30] == octant, m.number(*A32) == z3.If(steep, width, height),
              m.number(*B32) == z3.If(steep, height, width))
        demand(all(m.registers[n] is byte for n, byte in tie.items()))
    return check


def shifted(m):
    shorter, longer = m.number(*A32), m.number(*B32)
    kept = {n: m.registers[n] for n in (*range(14, 18), 30)}
    m.holds += [longer != 0, z3.ULE(shorter, longer)]

    def check(m, end):
        demand(all(m.registers[n] is byte for n, byte in kept.items()))
        if end == SHIFT:
            # By a byte, and once more.
            shown(m, m.number(*A32) == shorter << 8, m.number(*B32) == longer << 8, z3.ULT(longer, 1 << 24))
            return
        pushed = m.stack[len(SAVED):]
        demand(len(pushed) == 9)
        m.saved |= dict(zip(range(100, 109), pushed))
        long, short = (z3.Concat(*(m.saved[n] for n in reversed(place))) for place in (LONGER, SHORTER))
        demand(m.saved[OCTANT] is kept[30])
        shown(m, z3.Or(*(z3.And(long == longer << k, short == shorter << k, z3.LShR(long, k) == longer) for k in range(8))),
              long < 0)
    return check


class Runs(Rows):
    """Runs the code for many ties at once."""

    def of(self, cases):
        other = super().of(cases)
        other.stack = [item[cases] if isinstance(item, numpy.ndarray) else item for item in self.stack]
        return other

    def step(self, address):
        try:
            return super().step(address)
        except (KeyError, TypeError, ValueError, IndexError) as reason:
            raise Unprovable("something is read before it is set") from reason

    def compute(self, mnemonic, d, r, target, following):
        if mnemonic == "bst":
            self.transfer = bool(self.registers[d] >> int(r) & 1)
            return [(following, self)]
        if mnemonic == "lpm" and r == "Z+":
            place = self.registers[31] * 256 + self.registers[30] + 1
            super().compute(mnemonic, d, "Z", target, following)
            self.registers[30], self.registers[31] = place & 255, place >> 8
            return [(following, self)]
        return super().compute(mnemonic, d, r, target, following)


def reduced(directions, m, steep, left):
    """The ties of an octant: of each, whether what the vector is compared with is next to it."""
    indices = numpy.array([i for i in range(0, len(directions), m.program.stride) if directions[i][:2] == (steep, left)])
    m.given["tie"] = indices
    m.place(indices + 1 << 15, range(14, 18))
    m.registers[30] = OCTANTS[steep, left]

    def check(m, _):
        pushed = m.stack[len(MIRRORED):]
        demand(len(pushed) == 13 and numpy.all(m.registers[ZERO] == 0))
        m.saved |= dict(zip(range(109, 122), pushed))
        size = numpy.zeros(len(m.given["tie"]), dtype=numpy.int64)
        digits = [(m.saved[n] + size).tolist() for n in TURN_DIGITS]
        tangent = sum((m.saved[n] + size).astype(object) << 8 * i for i, n in enumerate(TANGENT))
        for i, *case in zip(m.given["tie"].tolist(), *digits, tangent):
            demand(is_between(case[:4], case[4], *directions[i][2:]), f"next to {i + 1} / 2^17")
    return check


def is_between(digits, tangent, below, above):
    """Whether what the vector is compared with, by any permitted error, is between the fractions next to the tie; and whether
    what the turns require holds for all directions in doubt."""
    (a, b), (c, e) = below, above
    # The turned vector is (x cosine + y sine, y cosine - x sine), where 2^31 <= x < 2^32 and y <= x.
    cosine, sine = 1 << 47, 0

    def height(numerator, denominator, margin):
        """The turned y of a fraction, and of those by `margin` 2^-24 above it, for x = denominator 2^24."""
        return cosine * ((numerator << 24) + margin * denominator) - (sine * denominator << 24)

    # Ratios in doubt are within 2^-25 of the tie's; so are the fractions.
    for i, (turn, bits, multiple) in enumerate(zip(digits, TURNED_BY, MULTIPLE_OF)):
        if (cosine | sine) & (1 << multiple) - 1:
            return False
        if turn and (height(a, b, -1) < 0 or i >= 2 and height(c, e, 1) << 8 >= e << 72):
            return False
        cosine, sine = cosine - (sine * turn >> bits), sine + (cosine * turn >> bits)
        if cosine + sine > 1 << 48:
            return False
    if height(a, b, -1) << 8 <= -b << 70 or height(c, e, 1) << 8 >= e << 70:
        return False
    steepness, fall = (cosine << 88) - sine * tangent, (sine << 88) + cosine * tangent
    return (steepness > 0 and steepness * a - fall * b << 31 < -(LOST_PRODUCT + 1) * b << 80 and steepness * c >= fall * e)


def halved(m):
    m.zero(ZERO)
    longer, shorter = (sum((m.saved[n] * (1 << 8 * i) for i, n in enumerate(place)), Form()) for place in (LONGER, SHORTER))

    def check(m, _):
        m.demand_pointer()
        m.show(equal(m.number(X) * 2, longer * 2**48), equal(m.number(Y) * 2, shorter * 2**48), *zeros(m, (ZERO,)))
    return check


def turned(i, m, by_zero=False):
    m.point(28)
    m.zero(ZERO, *X[:MULTIPLE_OF[i] // 8], *Y[:MULTIPLE_OF[i] // 8])
    if by_zero:
        m.stack[len(MIRRORED) + i] = m.saved[TURN_DIGITS[i]] = known(0)
    elif i >= 2:
        m.zero(Y[-1])
    x, y, digit, unit = m.number(X), m.number(Y), m.saved[TURN_DIGITS[i]], 1 << TURNED_BY[i]

    def check(m, _):
        m.demand_pointer()
        demand(m.constant((m.number(X) - x) * unit - m.times(y, digit), unit << 80) == 0)
        demand(m.constant((m.number(Y) - y) * unit + m.times(x, digit), unit << 80) == 0)
        m.show(*zeros(m, (ZERO,)))
    return check


def multiplied(m):
    m.point(28)
    m.zero(ZERO)
    x, height = m.number(X[1:]), [m.registers[n] for n in Y[:9]]
    tangent = sum((m.saved[n] * (1 << 8 * i) for i, n in enumerate(TANGENT)), Form())

    def check(m, _):
        pushed = m.stack[len(REDUCED):]
        demand(len(pushed) == 9)
        m.saved |= dict(zip(range(122, 131), pushed))
        demand(all(m.saved[n] is byte for n, byte in zip(HEIGHT, height)))
        m.show((0, m.times(x, tangent) - m.number(range(21, 30)) * 2**72, LOST_PRODUCT << 72), *zeros(m, (ZERO,)))
    return check


def compared(m, steep, left, negative):
    m.zero(ZERO)
    m.stack[MIRRORED.index(OCTANT)] = m.saved[OCTANT] = known(OCTANTS[steep, left])
    height = sum((m.saved[n] * (1 << 8 * i) for i, n in enumerate(HEIGHT)), Form())
    difference = height * 256 - m.number(range(21, 30))
    # A turned y of less than 2^70, as `is_between` asks.
    if negative:
        m.hold((1 << 72) - (1 << 70), height)
        difference -= known(1 << 80)
    else:
        m.hold(None, height, (1 << 70) - 1)

    def check(m, _):
        reached = m.registers[24].constant()
        demand(reached in (0, 1))
        m.show((0, difference, None) if reached ^ steep ^ left else (None, difference, -1))
    return check


WIDE = 320  # bits of sines and cosines
TIES = 411775  # pi, in units of 2^-17


def neighbours(numerator, denominator):
    """The fractions with denominators up to 2^31 next to a number in (0, 1), below and above it."""
    a, b, c, d = 0, 1, 1, 1
    while True:
        up, rest = denominator * c - numerator * d, numerator * b - denominator * a
        k = min(rest // up, ((1 << 31) - b) // d)
        a, b, rest = a + k * c, b + k * d, rest - k * up
        if b + d > 1 << 31:
            return (a, b), (c, d)
        k = min(up // rest, ((1 << 31) - d) // b)
        c, d, up = c + k * a, d + k * b, up - k * rest
        if b + d > 1 << 31:
            return (a, b), (c, d)


def ties():
    """For each tie the octant and the directions next to it."""
    found = []
    with mp.workprec(WIDE + 40):
        first = [int(mp.nint(f(mpf(1) / (1 << 17)) * 2**WIDE)) for f in (mp.cos, mp.sin)]
    # Directions in doubt are in the octant of their tie.
    for k in (1, 2, 3, 4):
        quarter = k * mp.pi / 4 * 2**17
        demand(abs(quarter - mp.nint(quarter)) / 2**17 > 2.0**-21)
    cosine, sine = first
    # Each step errs by a few units of the last place.
    for _ in range(1, TIES):
        low, high = sorted((abs(cosine), sine))
        found.append((sine > abs(cosine), cosine < 0, *neighbours(low, high)))
        cosine, sine = cosine * first[0] - sine * first[1] >> WIDE, sine * first[0] + cosine * first[1] >> WIDE
    return found


# The kernel


ATAN2, RATIO, POWER, INDEX, SCALE, ROUGH = "atan2_q16_16_correctly_rounded", ".Lratio", ".Lpower", ".Lindex", ".Lscale", ".Lrough"
LOOK_UP, BENT, SLOPE_READ, RISE, UNFOLD = ".Llook_up", ".Lbent", ".Lslope", ".Lrise", ".Lunfold"
DIGITS = (25, 24, 23)
# On the stack: the operands and the octant, and what the ratio pushes.
OPERANDS = (*range(18, 26), 30)
PUSHED = (*OPERANDS, 14, 15, 16, 17, 28, 29)
T = (18, 19, 20)
LOST_FALL = 2 * 255 * 2**16 + 2 * 255**2 * 2**8 + 255**2
HALF_PI, PI, DOUBT = 3373259426, 6746518852, 10  # in units of 2^-31
LARGEST = 0x64880000  # above pi/4


def on_stack(base, unknown):
    class Kept(base):
        def __init__(self, *arguments):
            super().__init__(*arguments)
            self.saved = self.saved | {n: unknown(self, n) for n in OPERANDS}
    return Kept


class Kernel(Framed):
    looked_up = 256

    def compute(self, mnemonic, d, r, target, following):
        if mnemonic == "sbiw":
            return super().compute(mnemonic, d, r, target, following)
        return Bits.compute(self, mnemonic, d, r, target, following)


def entry(m):
    y, x = m.number(*A32), m.number(*B32)
    m.saved |= {n: m.registers[n] for n in OPERANDS[:-1]}
    height, width = (z3.If(number < 0, -number, number) for number in (y, x))
    steep, left = z3.UGT(height, width), x < 0

    def check(m, end):
        if end is None:
            shown(m, y == 0, x == 0, m.number(*A32) == 0)
            return
        demand(len(m.stack) == len(OPERANDS), "the stack does not balance")
        m.saved[30] = octant = m.stack[-1]
        shown(m, octant == z3.If(steep, z3.BitVecVal(1, 8), z3.BitVecVal(0, 8)) + z3.If(left, z3.BitVecVal(2, 8), z3.BitVecVal(0, 8)),
              m.flags["T"] == (y < 0))
        if end == RATIO:
            shown(m, height != width, m.number(*A32) == z3.If(steep, width, height), m.number(*B32) == z3.If(steep, height, width))
        else:
            shown(m, height == width, y != 0, m.number(*A32) == (1 << 32) - 1)
    return check


def popped(m):
    kept = {n: m.registers[n] for n in range(22, 26)}

    def check(m, _):
        demand(m.transfer is None and all(m.registers[n] is form for n, form in kept.items()))
    return check


def bent(m):
    i, t2 = (part.ravel() for part in numpy.meshgrid(numpy.arange(256), numpy.arange(256)))
    m.place(i, (25,))
    m.place(t2, (24,))
    _, slope, bend, twist = rows(m.program)
    wanted, place = bend[i] + (twist[i] * t2 >> 8), m.program.labels[ARCTANGENT] + RECORD * i + 3

    def check(m, _):
        demand(m.transfer is None and (m.registers[18], m.registers[19]) == ("r22", "r23") and (m.number((20,)) == t2).all())
        demand(m.is_zero(21) and (m.number((24, 25)) == wanted).all() and (m.number((30, 31)) == place).all())
        demand((wanted >= 0).all() and (wanted < slope[i] >> 8).all())
    return check


class Cubic(Linear):
    """Takes the bytes of the record one after the other, whatever their values."""

    def read(self, size):
        record = [self.variable("record") for _ in range(size)]
        self.record = iter(record)
        return sum((byte * (1 << 8 * i) for i, byte in enumerate(record[1:])), Form())

    def compute(self, mnemonic, d, r, target, following):
        if mnemonic == "lpm" and r == "Z+":
            self.registers[d] = next(self.record)
            return [(following, self)]
        if mnemonic == "adiw" and d == 30:
            demand(r == "0x01")
            next(self.record)
            return [(following, self)]
        return super().compute(mnemonic, d, r, target, following)


def fall(m):
    product, t = m.times(m.number((24, 25)), m.number(T)), m.number(T)
    place = m.registers[30], m.registers[31]
    m.zero(21)

    def check(m, _):
        demand(m.transfer is None and place == (m.registers[30], m.registers[31]))
        m.show((0, product - m.number((22, 23)) * (1 << 24), LOST_FALL), equal(m.number(T), t), *zeros(m, (21,)))
    return check


def slope_read(m):
    fall, t, place = m.number((22, 23)), m.number(T), (m.registers[30], m.registers[31])
    m.zero(21)
    slope = m.read(4)
    following = m.variable("record")
    m.record = iter([*m.record, following])
    # As `bent` shows.
    m.hold(0, slope - fall)

    def check(m, _):
        demand(m.transfer is None and place == (m.registers[30], m.registers[31]) and next(m.record, None) is None)
        m.show(equal(m.number((24, 25, 26)), slope - fall), equal(m.number(T), t), *zeros(m, (21,)))
    return check


def risen(m):
    slope, t = m.number((24, 25, 26)), m.number(T)
    m.zero(21)
    value = m.read(5)
    next(m.record)
    # As `core_errors` asks of the table; and t is below 2^24.
    m.hold(None, value + slope, (1 << 32) - 1)
    product = m.times(slope, t)
    m.hold(0, slope * (1 << 24) - product)

    def check(m, _):
        demand(m.transfer is None and next(m.record, None) is None)
        m.show((0, product - (m.number(range(22, 26)) - value) * (1 << 24), LOST))
    return check


def unfolded(m, octant):
    angle, m.flags["T"] = m.number(*A32), z3.Bool("below")
    m.stack[-1] = m.saved[30] = z3.BitVecVal(octant, 8)
    y, x = (z3.Concat(*(m.saved[n] for n in reversed(range(low, low + 4)))) for low in (22, 18))
    m.registers[1] = z3.BitVec("r1", 8)
    m.holds.append(z3.ULT(angle, LARGEST))
    wide = z3.ZeroExt(8, angle)
    whole = (wide + 1, HALF_PI - 1 - wide, PI - 1 - wide, HALF_PI + 1 + wide)[octant] + (1 << 14) + DOUBT
    above, in_doubt = z3.Extract(31, 0, z3.LShR(whole, 15)), z3.ULT(whole & 0x7fff, 2 * DOUBT)

    def check(m, _):
        result = m.number(*A32)
        if m.calls:
            (name, given, reached), = m.calls
            demand(name == SIDE)
            m.holds.append(z3.ULE(z3.Extract(7, 0, reached), 1))
            nearest = above - 1 + z3.ZeroExt(24, z3.Extract(7, 0, reached))
            shown(m, in_doubt, given[0] == y, given[1] == x, given[2] == (above << 16) - (1 << 15),
                  result == z3.If(y < 0, -nearest, nearest))
        else:
            shown(m, z3.Not(in_doubt), result == z3.If(z3.Bool("below"), -above, above))
    return check


def core_errors(program):
    """The lowest and the highest error of the angle in the first octant, in units of 2^-31."""
    value, slope, _, twist = (part.astype(float)[:, None] for part in rows(program))
    demand((value / 256 + slope / 256 < 2.0**32).all())
    difference, beyond = differences(program, arc_tangent, FOURTH)
    pieces = difference.shape[1]
    t = numpy.arange(1, pieces + 1)[None, :] / pieces
    steepest = 1 / (1 + (numpy.arange(256)[:, None] / 256)**2)
    # Value and slope are cut to 2^-31; bend + twist t2 / 256 is rounded downward, and t2 / 256 is up to a 256th below t.
    low = (difference - beyond) / 256 - 1 - t + t * t * numpy.minimum(twist, 0) / 256 - LOST / 2**24 - RATIO_REST / 2 * steepest
    high = (difference + beyond) / 256 + t * t * (numpy.maximum(twist, 0) / 256 + 1) + t * LOST_FALL / 2**24
    return float(low.min()), float(high.max())


# In units of 2^-32: x 2^8 / D - floor(x / 2^32) for x < 2^40 and D >= 2^40 - 2^32.
RATIO_REST = 1 + 256 / 255


def sum_errors(program):
    """Of the angle in any octant."""
    low, high = core_errors(program)
    found = []
    for constant, exact in ((1, mpf(0)), (HALF_PI + 1, mp.pi / 2)):
        found += [low + float(constant - exact * 2**31), high + float(constant - exact * 2**31)]
    for constant, exact in ((HALF_PI - 1, mp.pi / 2), (PI - 1, mp.pi)):
        found += [float(constant - exact * 2**31) - high, float(constant - exact * 2**31) - low]
    return min(found), max(found)


def stretches_of_side(directions):
    any_case, octants = ((),), [*OCTANTS]
    return [(SIDE, side_entry, (SHIFT,), (), any_case, (None,)),
            (SHIFT, shifted, (SHIFT, REDUCE), SAVED, any_case, (None,)),
            (REDUCE, partial(reduced, directions), (VECTOR,), MIRRORED, octants, (None,)),
            (VECTOR, halved, (TURNS[0],), REDUCED, any_case, (None,)),
            *((name, partial(turned, i), ([*TURNS, PRODUCT][i + 1],), REDUCED, any_case if i < 2 else [(False,), (True,)], (None,))
              for i, name in enumerate(TURNS)),
            (PRODUCT, multiplied, (COMPARE,), REDUCED, any_case, (None,)),
            (COMPARE, compared, (None,), MULTIPLIED, [(*octant, negative) for octant in octants for negative in (False, True)], (None,))]


def main():
    folder, failed = Path(sys.argv[1]), False
    elf = folder / "correctly_rounded_angles.elf"
    mp.prec = 100
    z3.set_param("timeout", TIMEOUT)
    any_case = ((),)
    kernel = [(ATAN2, entry, (RATIO, LOOK_UP, None), (), any_case, (None,)),
              (RATIO, scaled, (INDEX,), OPERANDS, any_case, (None,)),
              (INDEX, reciprocal, (SCALE,), PUSHED, any_case, (None,)),
              (SCALE, dividend, (f".Ldigit{DIGITS[0]}",), PUSHED, any_case, (None,)),
              *((f".Ldigit{q}", partial(digit, q), (f".Ldigit{q - 1}" if q > 23 else ROUGH,), PUSHED, any_case, (None,)) for q in DIGITS),
              (ROUGH, popped, (LOOK_UP,), PUSHED, any_case, (None,)),
              (LOOK_UP, bent, (BENT,), OPERANDS, any_case, (None,)),
              (BENT, fall, (SLOPE_READ,), OPERANDS, any_case, (None,)),
              (SLOPE_READ, slope_read, (RISE,), OPERANDS, any_case, (None,)),
              (RISE, risen, (UNFOLD,), OPERANDS, any_case, (None,)),
              (UNFOLD, unfolded, (None,), OPERANDS, [(octant,) for octant in range(4)], (None,))]
    cuts = ((RATIO, ATAN2, "push", "r14"), (POWER, RATIO, "lpm", "r17"), (INDEX, POWER, "mov", "r30"), (SCALE, INDEX, "mov", "r27"),
            (".Ldigit25", SCALE, "mul", "r28"), *((f".Ldigit{q}", f".Ldigit{q + 1}", "mul", f"r{q}") for q in DIGITS[1:]),
            (ROUGH, ".Ldigit23", "pop", "r29"), (LOOK_UP, ROUGH, "mov", "r30"), (BENT, LOOK_UP, "mul", "r25"),
            (SLOPE_READ, BENT, "adiw", "r30"), (RISE, SLOPE_READ, "mul", "r24"), (UNFOLD, RISE, "eor", "r26"))
    bits = partial(on_stack(Kernel, lambda _, n: z3.BitVec(f"stack.{n}", 8)), {SIDE: ([A32, B32, TIE], 2)})
    linear = [on_stack(base, lambda machine, _: machine.variable("stack")) for base in (Ratio, Cubic)]
    arrays = on_stack(Rows, lambda _, n: f"stack{n}")
    for machine, every, labels in ((bits, 12, (ATAN2, RATIO, UNFOLD)),
                                   (linear[0], 12, (INDEX, SCALE, *(f".Ldigit{q}" for q in DIGITS), ROUGH)),
                                   (arrays, 4, (LOOK_UP,)), (linear[1], 8, (BENT, SLOPE_READ, RISE))):
        program = Core(kernel, machine, elf=elf, cuts=cuts)
        if machine is linear[0]:
            check_table(program)
        failed |= program.run(every, ("ret", "rjmp"), labels)
    found = sum_errors(program)
    print(f"{ATAN2}: the sum errs by {found[0]:.3f} to {found[1]:.3f}, by less than {DOUBT}, in units of 2^-31")
    failed |= not -DOUBT < found[0] <= found[1] < DOUBT

    side = stretches_of_side(ties())
    linear = with_frame(Linear, lambda machine, _: machine.variable("stack"), known)
    arrays = with_frame(Runs, lambda _, n: f"stack{n}", int)
    for machine, every, labels in ((partial(Kernel, {}), 4, (SIDE, SHIFT)), (linear, 12, (VECTOR, *TURNS, PRODUCT, COMPARE))):
        program = Program(side, machine, elf=elf, cuts=SIDE_CUTS)
        failed |= program.run(every, ("ret", "rjmp", *FRAME), labels)
    program = Program(side, arrays, elf=elf, cuts=SIDE_CUTS)
    stretch = side[2]
    visited = program.prove(*stretch)
    print(f"{REDUCE}: proven", flush=True)
    needless, count = program.survivors(stretch, visited, EVERY, ("ret", "rjmp", *FRAME)), len(sorted(visited)[::EVERY])
    print(f"of {count} instructions that were left out, without effect {needless}")
    failed |= 3 * len(needless) > count
    # A change of the table by 2^-64 is noticed.
    program.stride = 10
    for entry_number in (9, 20, 40, 55, 70, 71):
        flash, place = program.flash, program.labels[TABLE] + 11 * entry_number + 3
        program.flash = flash[:place] + bytes([flash[place] ^ 1]) + flash[place + 1:]
        try:
            program.prove(*stretch)
            print(f"entry {entry_number} of the table may change by 2^-64")
            failed = True
        except Unprovable as reason:
            print(f"entry {entry_number} changed by 2^-64: {reason}")
        program.flash = flash
    return failed


if __name__ == "__main__":
    sys.exit(main())
