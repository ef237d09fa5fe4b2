#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Proves that the lengths of Q8.8 are the numbers nearest to the root of the sum of the squares, at most
2^15 - 1, for all vectors of two and three components, from the instructions and their tables.

usage: prove_short_lengths.py

The statements about the registers at each label; v is the vector, at address 0:

    component   S is the sum of the squares before X; `count` components are left            by linear forms
    magnitude   x is the magnitude of the component that X has passed                        by linear forms
    sum         S of all of them                                                             by linear forms
    root        2^30 <= M = S 4^k < 2^32, 1 <= k <= 15                                       by running it
    last        M = R^2 + D, R the root or one more, where D = `rest` - q^2, q^2 in r1:r0    by linear forms
    back        R = floor(sqrt(M))                                                           by running it
    return      floor((R + 2^(k - 1)) / 2^k), at most 2^15 - 1

The last is floor(sqrt(S) + 1/2), since nested floors can be merged; a square is never an integer
plus 1/4, so there are no ties. The lowest byte of M does not matter up to `last`: the statement
there must hold with 0 and with 255. Then instructions are left out in turn, and each time the proof
must fail.
"""

import sys
from functools import partial

import numpy

from arrays import Arrays
from form import known
from machine_code import Program, demand
from stretches import Linear, equal, kept

S, X, POINTER, ROOT = (18, 19, 20, 21), (22, 23), (26, 27), (24, 25)
COUNT, ZERO, K, REST = 30, 31, 26, (18, 19, 21)
NEEDLESS = ("ret", "rjmp")
MANY = 1 << 90


def entry(count, m):
    m.zero(1, *ROOT)

    def check(m, _):
        m.show(*(equal(m.number(S), known(0)), equal(m.registers[ZERO], known(0)), equal(m.registers[COUNT], known(count)),
                 equal(m.number(POINTER), known(0))))
    return check


def component(m, place):
    m.memory = [m.variable("component") for _ in range(6)]
    low, high = m.memory[place:place + 2]
    m.zero(ZERO, POINTER[1])
    m.registers[POINTER[0]] = known(place)
    same = kept(m, *S, COUNT, ZERO)

    def check(m, _):
        number = low + high * 256
        negative = m.possible([(128, high, 255)])
        demand(not (negative and m.possible([(0, high, 127)])))
        m.possible([])
        m.same(m.number(X), known(65536) - number if negative else number, 65536)
        m.show(*same(m), equal(m.number(POINTER), known(place + 2)))
    return check


def square(m, count):
    m.zero(ZERO)
    m.registers[COUNT] = known(count)
    x, s = m.number(X), m.number(S)
    m.hold(0, x, 32768)
    m.hold(0, s, 2 << 30)
    m.hold(0, m.times(x, x), 1 << 30)
    same = kept(m, *POINTER, ZERO)

    def check(m, end):
        m.possible([])
        m.same(m.number(S), s + m.times(x, x), 1 << 32)
        m.show(*same(m), equal(m.registers[COUNT], known(count - 1)))
        demand((end == ".Lsum") == (count == 1))
    return check


def scaled(m):
    s = m.number(S)

    def check(m, end):
        if end == ".Lroot":
            k = m.registers[K].constant()
            demand(1 <= k <= 15)
            m.same(m.number(S), s * (1 << 2 * k), 1 << 32)
            m.show((64, m.registers[S[3]], 255))
        elif m.number(ROOT) == known(32767):
            m.show((1 << 30, s, MANY))
        else:
            m.show(equal(m.number(ROOT), known(0)), equal(s, known(0)))
    return check


def root(m, top):
    upper = m.given["upper"] = numpy.arange(top << 16, top + 1 << 16)
    m.place(upper, S[1:])

    def check(m, end):
        least, found = m.given["upper"] * 256, numpy.asarray(m.number(ROOT), dtype=numpy.int64)
        demand((found < 1 << 16).all() and m.untouched(S[0]) and m.untouched(K))
        if end == ".Lback":
            demand((found * found <= least).all() and (least + 255 < (found + 1) ** 2).all())
            return
        q = m.number(ROOT[:1])
        left = m.number(REST[1:]) * 256 - q * q
        demand((m.number((0, 1)) == q * q).all() and m.is_zero(ZERO))
        demand((least == found * found + left).all() and (left + 255 <= 2 * found).all() and (left > -2 * found).all())
    return check


def last(m):
    q, rest = m.registers[ROOT[0]], m.number(REST)
    m.zero(ZERO)
    m.hold(*equal(m.number((0, 1)), m.times(q, q)))
    left = rest - m.times(q, q)
    same = kept(m, ROOT[1], K)

    def check(m, _):
        less = int(m.possible([(None, left, -1)]))
        demand(less != int(m.possible([(0, left, None)])))
        m.possible([])
        m.same(m.registers[ROOT[0]], q - known(less), 256)
        m.show(*same(m))
    return check


def back(m, k):
    found = m.given["root"] = numpy.arange(1 << 15, 1 << 16)
    m.place(found, ROOT)
    m.registers[K] = k

    def check(m, _):
        demand((m.number(ROOT) == numpy.minimum((m.given["root"] + (1 << k - 1)) >> k, 32767)).all())
    return check


STRETCHES = [("fixedpoint_length3_q8_8", partial(entry, 3), (".Lcomponent",), (), ((),), (None,)),
             ("fixedpoint_length2_q8_8", partial(entry, 2), (".Lcomponent",), (), ((),), (None,)),
             (".Lcomponent", component, (".Lmagnitude",), (), [(0,), (2,), (4,)], (None,)),
             (".Lmagnitude", square, (".Lcomponent", ".Lsum"), (), [(1,), (2,), (3,)], (None,)),
             (".Lsum", scaled, (".Lroot", None), (), ((),), (None,)),
             (".Lroot", root, (".Llast", ".Lback"), (), [(top,) for top in range(64, 256)], (None,)),
             (".Llast", last, (".Lback",), (), ((),), (None,)),
             (".Lback", back, (None,), (), [(k,) for k in range(1, 16)], (None,))]


def main():
    failed = False
    linear = [label for label, *_ in STRETCHES if label not in (".Lroot", ".Lback")]
    # .Lback shifts by 8 in single bits, too.
    for machine, labels, needless in ((Arrays, [".Lroot"], ()), (Arrays, [".Lback"], ("sbrs",)), (Linear, linear, ())):
        program = Program(STRETCHES, machine, sources=("length_q8_8", "root_table", "long_division_table"), cuts=(
            (".Lmagnitude", ".Lcomponent", "mul", "r22"), (".Lsum", ".Lmagnitude", "cpi", "r21"),
            (".Lroot", ".Lpairs", "mov", "r30"), (".Llast", ".Lroot", "cp", "r18")))
        failed |= program.run(1, NEEDLESS + needless, labels)
    return failed


if __name__ == "__main__":
    sys.exit(main())
