#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Proves that fixedpoint_divide_q16_16 returns the quotient rounded to nearest, half up, and
saturated, for all pairs of operands, from its instructions and its table.

usage: prove_quotients.py

The statements about the registers at each label (stretches.py), in the order of the code:

    magnitudes            n = |a|, d = |b|, T: the signs differ
    short, medium, long   n < 2^15 d where d < 2^16; n / d is as before
    index                 y = p d
    scale                 D = V y = 2^k - E, 0 < E < 2^(k-8); so w = p V has d w = D
    digit                 x = n w at the first; at each, n w 2^16 = (the digits above) D + x, scaled
    return                n w 2^16 / D = n 2^16 / d differs from the result by 1/2 at most

A tie, n 2^16 / d - 1/2 an integer, requires d divisible by 2^17, so d is not short. Nor does
rounding carry the result beyond 2^31: n / d <= 2^15 - 1/d if d < 2^16; otherwise n <= 2^31,
excluding both extremes. Then instructions are left out in turn, and each time the proof must fail.
"""

import sys
from functools import partial

import z3

from form import known
from machine_code import Program, Unprovable, demand
from stretches import Linear, equal, zeros

NAME = "fixedpoint_divide_q16_16"
TABLE = "fixedpoint_reciprocal_table"
EVERY = 8  # instructions, of which one is left out
# They skip digits of 0, clear what is already 0, or test such bytes.
NEEDLESS = ("breq", "eor", "or", "ret")


class Reciprocals(Linear):
    """The contents of its table for the index looked up."""

    def look_up(self, d):
        page = self.registers[31].get(1, 0) - (self.program.labels[TABLE] >> 8)
        if set(self.registers[31]) - {1} or page not in (0, 1):
            raise Unprovable("a byte is taken from elsewhere than the table")
        form, index, value = self.registers[30], self.byte(30), self.variable("table")
        self.registers[d] = value
        if page == 0:
            # power() of tables/reciprocal.py; of 0, nothing.
            demand(not self.copy().possible([(0, index, 0)]))
            scaled = self.times(value, index)
            self.hold(128, scaled)
            self.hold(0, known(256) - scaled - value)
        else:
            # What is known of the index and of the carries in it, times the value.
            self.hold(0, self.times(value, index - form), 0)
            carries = {name for name in form if str(name).startswith("carry")}
            for low, fact, high in self.facts[:]:
                if low == 0 and high and len(fact) > 1 and carries & set(fact):
                    self.hold(0, self.times(value, fact))
                    self.hold(0, value * high - self.times(value, fact))
            v, t = value + known(256), index + known(256)
            scaled = self.times(v, t)
            self.hold(0, known(1 << 17) - scaled - v)
            self.hold(None, known(1 << 17) - scaled - t, 511)
A, B = range(22, 26), range(18, 22)  # registers, the lowest first
MANY = 1 << 64


class Size:
    """The code for divisors of one size, D = 2^k - E: the registers of its numbers."""

    def __init__(self, name, k, **registers):
        self.name, self.k, self.top = name, k, B[k // 8 - 2]
        self.__dict__.update(registers)


SHORT = Size("short", 24, y=(26, 27), p=20, v=30, e=(19, 18), x=(31, 20, 21, 22, 23), zero=(21,), idle=(25,), saved=())
MEDIUM = Size("medium", 32, y=(26, 27, 20), p=21, v=30, e=(18, 19, 31), x=(20, 21, 22, 30, 23, 25), zero=(), idle=(24,),
              saved=())
LONG = Size("long", 40, y=(18, 19, 20, 21), p=26, v=27, e=(28, 29, 30, 31), x=(18, 19, 20, 21, 22, 23), zero=(16,),
            idle=(16,), saved=(16, 17, 28, 29))


def entry(m):
    """n = |a|, d = |b|, T: the signs differ"""
    m.zero(1)
    a, b = m.number(A), m.number(B)
    # -2^31 and -2^16, byte by byte
    both_extreme = [equal(m.registers[register], known(number))
                    for register, number in zip((*A, *B), (0, 0, 0, 128, 0, 0, 255, 255))]

    def check(m, end):
        demand(m.signs)
        n, d = (known(1 << 32) - number if minus else number for number, minus in zip((a, b), m.signs))
        if end is None:
            m.show(*both_extreme, equal(m.number(A), known((1 << 31) - 1)))
            return
        m.show(equal(m.number(A), n), equal(m.number(B), d))
        demand(m.registers[1] == known(0))
        if not m.transfer and m.possible(both_extreme):
            m.settle()
            demand(m.solver.check() == z3.unsat)
    return check


def magnitudes(m):
    """n / d, or the saturated result"""
    m.zero(1)
    n, d = m.number(A), m.number(B)
    m.hold(0, n, 1 << 31)
    m.hold(0, d, 1 << 31)

    def check(m, end):
        times = 256 if m.registers[18] == known(0) else 1
        if end is None:
            m.show((0, n - d * (1 << 15), MANY))
            extreme = (1 << 31) - 1 if not m.transfer else 1 << 31
            for given, result in (((1, n, MANY), extreme), ((0, n, 0), 0)):
                if m.possible([given]):
                    m.show(equal(m.number(A), known(result)))
            m.possible([])
            return
        size = {".Lshort": SHORT, ".Lmedium": MEDIUM, ".Llong": LONG}[end]
        m.show((1, m.registers[size.top], 255), equal(m.number(A), n * times), equal(m.number(B), d * times),
               *(equal(m.registers[other], known(0)) for other in B if other > size.top))
        if size is SHORT:
            m.show((-MANY, n - d * (1 << 15), -1))
    return check


def reciprocal(size, m):
    """p, and y = p d"""
    n, d = m.number(A), m.number(range(18, size.top + 1))
    m.hold(1, m.registers[size.top])
    m.zero(*range(size.top + 1, 22))

    def check(m, end):
        demand(m.registers[31] == known(m.program.labels[TABLE] >> 8))
        m.show(equal(m.number(size.y), m.times(m.registers[size.p], d)), (128, m.registers[size.y[-1]], 255),
               equal(m.number(A), n), *zeros(m, size.zero))
    return check


def index(size, m):
    """V, and E = 2^k - V y"""
    n, p, y = m.number(A), m.registers[size.p], m.number(size.y)
    m.hold(128, m.registers[size.y[-1]])
    m.registers[31] = known(m.program.labels[TABLE] >> 8)
    m.zero(*size.zero)

    def check(m, end):
        # V or V + 1
        v = m.registers[size.v]
        m.show(equal(m.number(A), n), equal(m.registers[size.p], p), *zeros(m, size.zero))
        e = known(1 << size.k) - m.times(v + known(256), y)
        m.show((1, e, (1 << size.k - 8) - 1))
        demand(m.constant(m.number(size.e) - e, 1 << size.k - 8) == 0)
    return check


def scale(size, above, m):
    """x = n w; where digits are skipped, they are 0."""
    n, v, p, e = m.number(A), m.registers[size.v], m.registers[size.p], m.number(size.e)
    m.zero(*size.zero)
    # As w d = D < 2^k, and d is not below 2^(k-16).
    m.hold(0, m.times(v, p) + p * 256, 65535)

    def check(m, end):
        w = m.number((26, 27))
        # As n < 2^15 d where d is short, and n <= 2^31.
        m.possible([(0, m.times(n, w) + w, 1 << 39) if size is SHORT else (0, w * (1 << 31) - m.times(n, w), MANY)])
        m.show(equal(w, m.times(v, p) + p * 256), equal(m.number(size.x), m.times(n, w)), equal(m.number(size.e), e),
               *zeros(m, (*size.idle, *above[end])))
        if size is LONG:
            m.show((0, m.registers[23], 127))
    return check


def before_digit(size, q, above, into, m):
    """E, the digit and those above it, and what is left if it is right."""
    e = m.number(size.e)
    m.hold(1, e)
    m.zero(*size.idle)
    if size is LONG:
        m.hold(0, m.registers[23], 127 + len(above))
    return e, m.number((q, *above)), m.number(into) + m.times(m.registers[q], e)


def digit(size, q, above, into, out, rest, m):
    """One more, and what is left below it."""
    e, number, scaled = before_digit(size, q, above, into, m)
    others = m.number(rest)

    def check(m, end):
        more = m.constant(m.number((q, *above)) - number, 1 << 8 * (1 + len(above)))
        demand(more < 2)
        m.show(equal(m.number(out), scaled + (e - known(1 << size.k)) * more), equal(m.number(size.e), e),
               equal(m.number(rest), others), *zeros(m, size.idle))
        if size is LONG:
            m.show((0, m.registers[23], 128 + len(above)))
    return check


def last_digit(size, q, above, into, m):
    """The result: N / D less it is between -1/2 and 1/2, and which of them depends on the sign."""
    e, quotient, scaled = before_digit(size, q, above, into, m)

    def check(m, end):
        result = m.number(A) * (-1 if m.transfer else 1)
        more = m.constant(result - quotient, 1 << 32)
        demand(more < 3)
        d = known(1 << size.k) - e
        rest = (scaled - d * more) * 2
        m.show((0 if size is SHORT else int(m.transfer), rest + d, MANY),
               (0 if size is SHORT else int(not m.transfer), d - rest, MANY))
    return check


def stretches():
    yield NAME, entry, (".Lmagnitudes", None), ()
    yield ".Lmagnitudes", magnitudes, (".Lshort", ".Lmedium", ".Llong", None), ()
    digits = {SHORT: ((23, (), (20, 21, 22), (20, 21, 22), (31,)), (22, (23,), (31, 20, 21), (31, 20, 21), ()),
                      (21, (22, 23), (None, 31, 20), (26, 31, 20), ()), (20, (21, 22, 23), (None, 26, 31))),
              MEDIUM: ((25, (), (21, 22, 30, 23), (21, 22, 30, 23), (20,)),
                       (23, (25,), (20, 21, 22, 30), (20, 21, 22, 30), ()),
                       (30, (23, 25), (None, 20, 21, 22), (26, 20, 21, 22), ()), (22, (30, 23, 25), (None, 26, 20, 21))),
              LONG: ((23, (), (18, 19, 20, 21, 22), (18, 19, 20, 21, 22), ()),
                     (22, (23,), (None, 18, 19, 20, 21), (17, 18, 19, 20, 21), ()),
                     (21, (22, 23), (None, 17, 18, 19, 20)))}
    for size, (*upper, last) in digits.items():
        label = f".L{size.name}"
        names = [f"{label}_digit_{len(upper) - i}" for i in range(len(upper) + 1)]
        yield label, partial(reciprocal, size), (f"{label}_index",), ()
        yield f"{label}_index", partial(index, size), (f"{label}_scale",), size.saved
        above = {name: registers[1] for name, registers in zip(names, upper)}
        yield f"{label}_scale", partial(scale, size, above), tuple(above), size.saved
        for i, registers in enumerate(upper):
            yield names[i], partial(digit, size, *registers), names[i + 1:i + 2], size.saved
        yield names[-1], partial(last_digit, size, *last), (None,), size.saved


def check_table(program):
    """Checks what Reciprocals assumes about the table."""
    page = program.flash[program.labels[TABLE]:][:512]
    for i, (p, v) in enumerate(zip(page[:256], page[256:])):
        demand(i == 0 or 128 <= p * i <= 256 - p)
        demand((v + 256) * (i + 257) <= 1 << 17 and (1 << 17) - (v + 257) * (i + 256) < 512)


def main():
    program = Program(list(stretches()), Reciprocals, sources=("divide_q16_16", "reciprocal_table"))
    check_table(program)
    return program.run(EVERY, NEEDLESS)


if __name__ == "__main__":
    sys.exit(main())
