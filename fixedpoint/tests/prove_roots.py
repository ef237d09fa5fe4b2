#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Proves that fixedpoint_sqrt_q32_32 returns the number nearest to the square root of 2^32 a for all
a >= 0, and 0 for all others, from its instructions and its tables.

usage: prove_roots.py

The statements about the registers at each label (stretches.py), in the order of the code; s is the
root so far, of k bytes, and X = 2^7 (N 2^(16 (k - 4)) - s^2), extended by the bytes still in use:

    seed      N = a 2^e >= 2^62; the root of 2^(16 (count - 2)) N, times shift / 256, is that of 2^32 a
    square    s^2 <= N / 2^32 < (s + 4)^2, by trying the highest two bytes of N
    root      the same, and X. As s grows with each pass, there is a last one.
    invert    0 <= X < 2^7 (2 s + 1): s is the root of k bytes, rounded down
    digit     v = floor((2^24 - 1) / h) - 2^8, by trying all h, the highest two bytes of s
    compare   the estimate of the digit, and what is left of u, the highest three bytes of X (long_division.py)
    estimated u = d h + r; r < h or d = 255
    high      X < 0 with this digit, not with 0: with each pass it is one less
    .Lcompare, .Lshift_root    all digits are there; of the longest roots, 2 X is compared with s
    return    floor(root of N' + 1/2), where s = floor(root of N'), and N' - s^2 = X / 2^7 if it is needed

Since a square is never an integer plus 1/4, there are no ties. The root of k bytes times shift /
256, rounded, is that of the exact root, rounded: bits below the rounding bit do not matter. Then
instructions are left out in turn, and each time the proof must fail.
"""

import sys
from functools import partial

import numpy

from arrays import Arrays
from form import known
from long_division import ESTIMATES, MANY, begin_compared, hold_reciprocal, invert, show_estimate
from machine_code import Program, demand
from stretches import Linear, equal, kept, zeros

NAME = "fixedpoint_sqrt_q32_32"
A = range(18, 26)
ROOT = (29, 28, 17, 16, 15, 14)  # the highest byte first
ZERO, INVERSE, SHIFT, COUNT, DIGIT, HALF = 12, 13, 11, 10, 27, 30
EVERY = 8  # instructions, of which one is left out
NEEDLESS = ("ret", "push", "pop")
SHIFTS = [1 << i for i in range(8)]
SAVED = (10, 11, 12, 13, 14, 15, 16, 17, 28, 29)
KEPT = (ZERO, SHIFT)
MINUS_S = (25, 18, 19, 20, 21, 22, 23, 24)  # the remainder of two bytes of the root, the lowest first


class Digit:
    """How the byte of the root after the first `k` is found: the registers of X, those below u first, by
    how many bits X is longer than needed, and which registers are 0."""

    def __init__(self, name, k, x, longer, idle):
        self.name, self.k, self.x, self.longer, self.idle = name, k, x, longer, idle
        self.u = x[-3:]
        self.high = f".L{name}_high"
        self.idle_above = [register for register in idle if register not in x]
        self.weight = 1 << 8 * len(x) - 24  # of the lowest byte of u
        self.root = ROOT[k - 1::-1]

    def product(self, m, s, digit):
        """The amount subtracted from X for a digit."""
        return (m.times(s, digit) * 512 + m.times(digit, digit)) * (1 << self.longer + 7)


DIGITS = (Digit("third", 2, (25, 18, 19, 20, 21, 22, 23), 16, (24,)),
          Digit("fourth", 3, (25, 18, 19, 20, 21, 22), 0, (23, 24)),
          Digit("fifth", 4, (23, 24, 25, 18, 19, 20, 21), 0, (22, 23, 24)),
          Digit("sixth", 5, (21, 22, 23, 24, 25, 18, 19, 20), 0, (21, 22)))
NEXT = dict(zip(DIGITS, DIGITS[1:]))


def entry(m):
    m.zero(1)
    a, top = m.number(A), m.registers[25]

    def check(m, end):
        if end is None:
            m.show(equal(m.number(A), known(0)))
            demand(not m.possible([(0, top, 127), (1, a, MANY)]))
            return
        count, shift = (m.registers[register].constant() for register in (COUNT, SHIFT))
        demand(1 <= count <= 4 and (count == 4 or not m.transfer))
        moved = 0 if m.transfer else 80 - 16 * count - 2 * (shift.bit_length() - 1)
        demand(m.transfer or shift in SHIFTS)
        m.show((0, top, 127), equal(m.number(A), a * (1 << moved)), (64, m.registers[25], 255),
               equal(m.registers[ZERO], known(0)))
    return check


def counted(m, digits):
    """`count` is the number of digits that remain, up to all of `digits`; with T, all."""
    if m.transfer:
        m.registers[COUNT] = known(digits)
    else:
        m.hold(1, m.registers[COUNT], digits)


def seed(m):
    same = m.try_all(numpy.arange(1 << 14, 1 << 16), A[-2:], (*A[:-2], SHIFT, COUNT))
    m.registers[ZERO] = 0

    def check(m, end):
        s, v = numpy.asarray(m.number(ROOT[1::-1]), dtype=numpy.int64), m.given["tried"] << 16
        demand((s >= 1 << 15).all() and (s * s <= v).all() and (v + 65535 < (s + 4) ** 2).all())
        demand(m.is_zero(ZERO))
        same(m)
    return check


def begin_root(m):
    m.zero(ZERO)
    s = m.number(ROOT[1::-1])
    m.hold(128, m.registers[ROOT[0]])
    return s, kept(m, *KEPT, COUNT)


def first_remainder(m, x, s):
    """0 <= N - 2^32 s^2 < 2^32 ((s + 4)^2 - s^2), and N < 2^64."""
    return [(0, x, MANY), (-MANY, x - (s * 8 + known(16)) * (1 << 39), -1),
            (-MANY, x + m.times(s, s) * (1 << 39) - known(1 << 71), -1)]


def square(m):
    s, same = begin_root(m)
    n, high = m.number(A), m.number(A[-2:]) * (1 << 16)
    left = high - m.times(s, s)
    m.hold(0, left)
    m.hold(None, left + known(65535) - s * 8, 15)

    def check(m, end):
        x = m.number(MINUS_S)
        m.possible([])
        m.same(x, (n - m.times(s, s) * (1 << 32)) * 128, 1 << 63)
        m.show(*first_remainder(m, x, s), equal(m.registers[HALF], known(128)), equal(m.number(ROOT[1::-1]), s), *same(m))
    return check


def root(m):
    s, same = begin_root(m)
    x = m.number(MINUS_S)
    m.registers[HALF] = known(128)
    for statement in first_remainder(m, x, s):
        m.hold(*statement)

    def check(m, end):
        m.possible([])
        more = int(end == ".Lroot")
        less = (s * 2 + known(1)) * (1 << 39)
        m.same(m.number(MINUS_S), x - less * more, 1 << 64)
        m.same(m.number(ROOT[1::-1]), s + known(more), 1 << 16)
        m.show(*same(m))
        if more:
            m.show(*first_remainder(m, x - less, s + known(1)), equal(m.registers[HALF], known(128)))
        else:
            m.show((1, less - x, MANY), *zeros(m, DIGITS[0].idle))
    return check


def begin_digit(of, m, idle=None):
    m.zero(ZERO, *(of.idle if idle is None else idle))
    m.hold(128, m.registers[ROOT[0]])
    counted(m, 6 - of.k)
    return m.number(of.root), m.number(ROOT[1::-1]), m.number(of.x)


def remains(x, s, bits):
    """0 <= X < 2^bits (2 s + 1)"""
    return [(0, x, MANY), (-MANY, x - (s * 2 + known(1)) * (1 << bits), -1)]


def estimate(of, m, small):
    s, h, x = begin_digit(of, m)
    hold_reciprocal(m, INVERSE, h, small)
    for statement in remains(x, s, of.longer + 23):
        m.hold(*statement)
    u0, u1, u2 = (m.registers[register] for register in of.u)
    v = m.registers[INVERSE]
    same = kept(m, *of.x[:-3], of.u[2], *of.root, *of.idle, *KEPT, COUNT, INVERSE)

    def check(m, end):
        show_estimate(m, small, v, h, u2, u1, u0, *of.u[:2])
        m.show(*same(m))
    return check


def compare(of, m, over, which):
    s, h, x = begin_digit(of, m)
    u = begin_compared(m, over, which, h, *of.u[::-1])
    same = kept(m, *of.x[:-3], *of.root, *of.idle, *KEPT, COUNT, INVERSE)

    def check(m, end):
        digit, rest = m.registers[DIGIT], m.number(of.u)
        m.possible([])
        m.settle()
        m.show(equal(u, m.times(digit, h) + rest), *same(m))
        if m.reaches(0, rest - h):
            m.show((255, digit, 255))
    return check


def subtract(of, m, last):
    """`last`: the digit is 255, because it would have been 256."""
    s, h, left = begin_digit(of, m)
    digit = known(255) if last else m.registers[DIGIT]
    m.registers[DIGIT] = digit
    if not last:
        m.hold(1, h - m.number(of.u))
    return digit_taken(of, m, left + m.times(digit, h) * of.weight, s)


def less_digit(of, m):
    s, _, left = begin_digit(of, m, of.idle_above)
    digit = m.registers[DIGIT]
    m.hold(128, m.registers[of.x[-1]])
    return digit_taken(of, m, left - known(1 << 8 * len(of.x)) + of.product(m, s, digit), s)


def digit_taken(of, m, x, s):
    """The remainder of X after a digit, if that is negative, or if it is not."""
    for statement in remains(x, s, of.longer + 23):
        m.hold(*statement)
    same, shift = kept(m, *of.root, *KEPT, INVERSE), kept(m, *KEPT)
    before, following = m.registers[COUNT], NEXT.get(of)

    def check(m, end):
        new = m.registers[DIGIT]
        left = x - of.product(m, s, new)
        longer = s * 256 + new
        m.possible([])
        modulus = 1 << 8 * len(of.x)
        if end == of.high:
            m.same(m.number(of.x) - known(modulus), left, modulus)
            m.show((128, m.registers[of.x[-1]], 255), equal(m.registers[COUNT], before), *same(m), *zeros(m, of.idle_above))
            return
        m.same(m.number(of.x), left, modulus)
        m.learn(*remains(left, longer, of.longer + 7))
        m.show(*(shift if end == ".Lshift_root" else same)(m))
        if end == ".Lshift_root":
            demand(not m.transfer)
            m.show(equal(before, known(1)), equal(m.number(ROOT[::-1]), longer))
        elif end == ".Lcompare":
            demand(m.transfer)
            m.show(equal(m.number(ROOT[::-1]), longer))
        else:
            m.learn(*zeros(m, following.idle))
            m.show(equal(m.number(following.x), left * (1 << 16 - of.longer)), equal(m.number(following.root), longer),
                   equal(m.registers[COUNT], before - known(1)), (1, m.registers[COUNT], MANY))
    return check


def compared(m):
    m.zero(ZERO)
    s, x = m.number(ROOT[::-1]), m.number(DIGITS[-1].x)
    top = m.registers[DIGITS[-1].x[-1]]
    # As a < 2^63.
    m.hold(0, s, (1 << 48) - 2)
    for statement in remains(x, s, 7):
        m.hold(*statement)

    def check(m, end):
        m.possible([])
        m.learn(equal(top, known(0)))
        m.show((0, m.number(A) - s, 1))
        for more, low, high in ((0, -MANY, -1), (1, 0, MANY)):
            if m.possible([equal(m.number(A), s + known(more))]):
                m.show((low, x - (s + known(1)) * 128, high))
    return check


def shift_root(m, shift):
    m.zero(ZERO)
    m.registers[SHIFT] = known(shift)
    s = m.number(ROOT[::-1])

    def check(m, end):
        m.show((0, s * shift + known(128) - m.number(A) * 256, 255))
    return check


def stretches():
    yield NAME, entry, (".Lseed", None), ()
    yield ".Lseed", seed, (".Lsquare",), SAVED, ((),), (None,)
    yield ".Lsquare", square, (".Lroot",), SAVED
    yield ".Lroot", root, (".Lroot", ".Linvert"), SAVED
    yield ".Linvert", partial(invert, h=ROOT[1::-1], inverse=INVERSE, idle=(*A, *KEPT, COUNT)), (".Lthird_digit",), SAVED, ((),), (None,)
    for of in DIGITS:
        yield f".L{of.name}_digit", partial(estimate, of), (f".L{of.name}_compare",), SAVED, [(True,), (False,)]
        yield f".L{of.name}_compare", partial(compare, of), (f".L{of.name}_estimated",), SAVED, ESTIMATES
        ends = (of.high, f".L{NEXT[of].name}_digit" if of in NEXT else ".Lcompare", ".Lshift_root")
        yield f".L{of.name}_estimated", partial(subtract, of), ends, SAVED, [(True,), (False,)]
        yield of.high, partial(less_digit, of), ends, SAVED
    yield ".Lcompare", compared, (None,), SAVED, ((),), (True,)
    yield ".Lshift_root", shift_root, (None,), SAVED, [(shift,) for shift in SHIFTS], (False,)


def program(machine):
    cuts = [(f".L{of.name}_compare", f".L{of.name}_digit", "cp", "r26") for of in DIGITS]
    return Program(list(stretches()), machine, sources=("sqrt_q32_32", "sqrt_table", "long_division_table"), cuts=cuts)


def main():
    tried = [".Lseed", ".Linvert"]
    failed = program(Arrays).run(EVERY, NEEDLESS, tried)
    return program(Linear).run(EVERY, NEEDLESS, [label for label, *_ in stretches() if label not in tried]) or failed


if __name__ == "__main__":
    sys.exit(main())
