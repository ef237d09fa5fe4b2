#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Proves for all pairs of operands, from its instructions, that fixedpoint_divide_q16_16_small returns the quotient rounded
to nearest, half up, and saturated.

usage: prove_small_quotients.py

n = |a| and d = |b|; b = 0 is taken as 2^-17, so that n 2^16 / d is 0 or at least 2^33. At each label, with X and D in
registers, Q the digits so far and j the number of digits after the next one,

    n 2^16 / d = Q 2^(8 (j + 1)) + 2^(8 j) X / D,  0 <= X < 256 D.

Proven for the stretch after each label:

    entry       X = n, D = d 2^(8 (j - 2)), Q = 0; T: the signs differ                                by bits
    bit         X and D are doubled, until bit 31 of D is set                                          by bits
    scaled      a reciprocal of the upper byte of D, whose estimate q of X / D is such that q 2^24 times
                that byte, or that byte plus 1, differs from every X by less than FAR; q is a byte
                even before it is increased by 1                                                       by running it
    first       X < D: a byte 0 is appended to X, and j is 1 less; or j < 4; or 2^(8 j) X / D > 2^31   by bits
    digit       q is that estimate                                                                     by running it
    multiple    Y = X - q D, hence |Y| < FAR                                                           by linear forms
    subtract    q is 1 more, Y is D less, until Y < 0                                                  by bits
    add         q is 1 less, Y is D more, until Y >= 0: then Y < D; X = 256 Y, and j is 1 less         by bits
    round       if j = -1: Q + X / 256 D rounded, with its sign, saturated                             by bits
    saturate    the saturated result                                                                   by bits

Since 0 <= X < 256 D, the q with 0 <= X - q D < D is a byte, whatever has been carried out of its register on the way; and Q,
which begins with j < 4, has at most four bytes. Each step of `subtract` and `add` brings Y closer to the end of their loops.
Then instructions are left out in turn, and each time the proof must fail.
"""

import sys

import numpy
import z3

from arrays import Arrays
from bits import Bits, joined, same
from form import known
from machine_code import Program, demand
from stretches import Linear, equal

NAME = "fixedpoint_divide_q16_16_small"
Q, D, X, J, RECIPROCAL = (18, 19, 20, 21), (22, 23, 24, 25), (26, 27, 28, 29, 30), 31, 17
SAVED = (17, 28, 29)
FAR = 6 << 32


def wide(number):
    return z3.ZeroExt(64 - number.size(), number)


def magnitude(number):
    return z3.If(number < 0, -number, number)


def begin(m):
    """T, X, D, Q and j, where X < 256 D."""
    m.flags["T"] = z3.Bool("negative")
    m.registers[1] = z3.BitVec("r1", 8)
    state = (m.flags["T"], wide(joined(m, X)), wide(joined(m, D)), wide(joined(m, Q)), m.registers[J])
    m.holds.append(z3.ULT(state[1], state[2] << 8))
    return state


def now(m):
    return wide(joined(m, X)), wide(joined(m, D)), wide(joined(m, Q)), m.registers[J]


def show(m, *conditions):
    demand(m.impossible(z3.Not(z3.And(*conditions))))


def entry(m):
    b, a = m.number(18, 4), m.number(22, 4)
    n, d = wide(magnitude(a)), wide(magnitude(b))

    def check(m, end):
        x, scaled, _, j = now(m)
        moved = [z3.And(j == i + 2, scaled == d << 8 * i, d != 0) for i in range(4)]
        top = z3.ULT(scaled, 1 << 31) if end == ".Lbit" else z3.UGE(scaled, 1 << 31)
        show(m, m.flags["T"] == ((a < 0) != (b < 0)), x == n, top, z3.ULT(x, scaled << 8),
             z3.Or(z3.And(d == 0, scaled == 1 << 31, j == 8), *moved))
    return check


def bit(m):
    negative, x, d, _, j = begin(m)
    m.holds.append(z3.ULT(d, 1 << 31))

    def check(m, end):
        demand(m.flags["T"] is negative)
        top = z3.ULT(d, 1 << 30) if end == ".Lbit" else z3.UGE(d, 1 << 30)
        found = now(m)
        show(m, found[0] == x * 2, found[1] == d * 2, found[3] == j, top)
    return check


def estimate(top, reciprocal):
    """The estimate of the digit from the upper byte of X."""
    return numpy.minimum(top + (top * reciprocal >> 8) + 1, 255)


def fits(top, reciprocal):
    """The estimate is a byte before it is increased."""
    return top + (top * reciprocal >> 8) < 256


def pairs(least):
    """Of bytes, the first of them from `least` on."""
    return (part.ravel().astype(numpy.int64) for part in numpy.meshgrid(numpy.arange(least, 256), numpy.arange(256)))


def scaled(m):
    m.place(numpy.arange(128, 256), D[3:])

    def check(m, _):
        demand(all(map(m.untouched, (*X, *D[:3], J))) and m.transfer is None)
        demand((m.registers[D[3]] == numpy.arange(128, 256)).all() and all(map(m.is_zero, Q)))
        upper, top = pairs(128)
        # Since X < 256 D.
        upper, top = upper[top <= upper], top[top <= upper]
        demand(isinstance(m.registers[RECIPROCAL], numpy.ndarray))
        reciprocal = m.registers[RECIPROCAL][upper - 128]
        demand(fits(top, reciprocal).all())
        q = estimate(top, reciprocal)
        demand(((top + 1 << 32) - (q * upper << 24) < FAR).all() and ((top << 32) - (q * (upper + 1) << 24) > -FAR).all())
    return check


def first(m):
    for register in Q:
        m.registers[register] = z3.BitVecVal(0, 8)
    negative, x, d, _, j = begin(m)
    m.holds += [z3.UGE(d, 1 << 31), z3.ULE(j, 8)]
    unchanged = same(m, (*D, RECIPROCAL))

    def check(m, end):
        unchanged(m)
        demand(m.flags["T"] is negative)
        found = now(m)
        if end == ".Lsaturate":
            show(m, z3.UGE(j, 4), z3.UGE(4 * x, 3 * d))
        elif end == ".Ldigit":
            show(m, found[0] == x, found[2] == 0, found[3] == j, z3.ULT(j, 4))
        else:
            show(m, z3.ULT(x, d), found[0] == x << 8, found[2] == 0, found[3] == j - 1, (j == 0) == (end == ".Lround"))
    return check


def digit(m):
    """For any reciprocal whose estimate is a byte before it is increased."""
    reciprocal, top = pairs(0)
    m.given["reciprocal"], m.given["top"] = (part[fits(top, reciprocal)] for part in (reciprocal, top))
    m.place(m.given["top"], X[4:])
    m.place(m.given["reciprocal"], (RECIPROCAL,))

    def check(m, _):
        demand(all(map(m.untouched, (*X[:4], *D, J))) and m.transfer is None)
        demand((m.registers[X[4]] == m.given["top"]).all() and (m.registers[RECIPROCAL] == m.given["reciprocal"]).all())
        demand([m.registers[register] for register in Q[1:]] == [f"r{register}" for register in Q[:3]])
        demand((m.registers[Q[0]] == estimate(m.given["top"], m.given["reciprocal"])).all())
    return check


def multiple(m):
    x, d, digits = m.number(X), m.number(D), m.number(Q)
    rest, other = x - m.times(m.registers[Q[0]], d), (m.registers[J], m.registers[RECIPROCAL])
    m.hold(1 - FAR, rest, FAR - 1)

    def check(m, end):
        demand(m.transfer is None and other == (m.registers[J], m.registers[RECIPROCAL]))
        m.same(m.number(X) - known(1 << 40 if end == ".Ladd" else 0), rest, 1 << 40)
        m.show(equal(m.number(D), d), equal(m.number(Q), digits))
    return check


def begin_step(m, low, high):
    """The values of `begin` without X, and Y."""
    negative, _, d, q, j = begin(m)
    m.holds = [z3.UGE(d, 1 << 31)]
    y = z3.SignExt(24, joined(m, X))
    m.holds += [y >= low, y < high]
    return negative, y, d, q, j, same(m, (*D, RECIPROCAL, *Q[1:]))


def subtract(m):
    negative, y, d, _, j, unchanged = begin_step(m, 0, FAR)
    digit = m.registers[Q[0]]

    def check(m, end):
        unchanged(m)
        demand(m.flags["T"] is negative)
        show(m, z3.SignExt(24, joined(m, X)) == y - d, m.registers[Q[0]] == digit + 1, m.registers[J] == j,
             (y < d) == (end == ".Ladd"))
    return check


def add(m):
    negative, y, d, _, j, unchanged = begin_step(m, -FAR, 0)
    m.holds.append(z3.ULE(j, 3))
    digit = m.registers[Q[0]]

    def check(m, end):
        unchanged(m)
        demand(m.flags["T"] is negative)
        found = m.registers[Q[0]] == digit - 1
        if end == ".Ladd":
            show(m, found, z3.SignExt(24, joined(m, X)) == y + d, m.registers[J] == j, y + d < 0)
        else:
            show(m, found, now(m)[0] == y + d << 8, y + d >= 0, y + d < d, m.registers[J] == j - 1,
                 (j == 0) == (end == ".Lround"))
    return check


def rounded(m):
    negative, x, d, q, _ = begin(m)
    rest = z3.LShR(x, 8)
    m.holds += [z3.Extract(7, 0, x) == 0, z3.UGE(d, 1 << 31)]

    def check(m, end):
        up = z3.If(negative, 2 * rest > d, 2 * rest >= d)
        magnitude = q + z3.If(up, z3.BitVecVal(1, 64), z3.BitVecVal(0, 64))
        if end:
            demand(m.flags["T"] is negative)
            show(m, z3.UGE(magnitude, 1 << 31))
        else:
            show(m, z3.ULT(magnitude, 1 << 31),
                 z3.SignExt(32, m.number(22, 4)) == z3.If(negative, -magnitude, magnitude))
    return check


def saturated(m):
    negative = begin(m)[0]

    def check(m, _):
        show(m, m.number(22, 4) == z3.If(negative, z3.BitVecVal(1 << 31, 32), z3.BitVecVal((1 << 31) - 1, 32)))
    return check


ANY = ((),)
STRETCHES = [(NAME, entry, (".Lbit", ".Lscaled"), (), ANY, (None,)),
             (".Lbit", bit, (".Lbit", ".Lscaled"), SAVED, ANY, (None,)),
             (".Lscaled", scaled, (".Lfirst",), SAVED, ANY, (None,)),
             (".Lfirst", first, (".Lfirst", ".Ldigit", ".Lround", ".Lsaturate"), SAVED, ANY, (None,)),
             (".Ldigit", digit, (".Lmultiple",), SAVED, ANY, (None,)),
             (".Lmultiple", multiple, (".Lsubtract", ".Ladd"), SAVED, ANY, (None,)),
             (".Lsubtract", subtract, (".Lsubtract", ".Ladd"), SAVED, ANY, (None,)),
             (".Ladd", add, (".Ladd", ".Ldigit", ".Lround"), SAVED, ANY, (None,)),
             (".Lround", rounded, (".Lsaturate", None), SAVED, ANY, (None,)),
             (".Lsaturate", saturated, (None,), SAVED, ANY, (None,))]
BY_RUNNING = (".Lscaled", ".Ldigit")


def main():
    failed = False
    for machine, every, labels in ((Arrays, 1, BY_RUNNING), (Linear, 4, (".Lmultiple",)),
                                   (Bits, 4, [label for label, *_ in STRETCHES if label not in (*BY_RUNNING, ".Lmultiple")])):
        program = Program(STRETCHES, machine, sources=("divide_q16_16_small",), cuts=((".Lscaled", ".Lnormal", "mov", "r17"),))
        failed |= program.run(every, ("ret", "rjmp"), labels)
    return failed


if __name__ == "__main__":
    sys.exit(main())
