#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Proves that the remainder, divrem and divmod of 32 bits are exact and saturated for all pairs of operands, from
their instructions.

usage: prove_remainders.py

n and d are the magnitudes of the operands, and k is the number of bits by which d is shifted left:
D = d 2^k. S = q D has been subtracted from n, where q is the quotient so far. The product is
opaque, but when D is halved q doubles, and when q is incremented S increases by D. The statements
at each label:

    bytes, bits    D has not lost a bit, the dividend is n, q is 0
    down           n = S + the dividend, which is less than D
    subtract       the same where d has come down by a bit already, to or below the dividend
    done           n = q d + the dividend, which is less than d

Before it, the remainder estimates the digits of short quotients, from x, which is n or its upper two bytes:

    magnitudes      n >= d or d = 0                                               by bits
    reciprocal      the highest byte of d is not 0                                by running it, for the upper two bytes of d
    found           P, a power of two, and v: d P (2^8 + v) <= 2^(16 + 8 j) and d P <= 2^(8 + 8 j), where d
                    has j + 1 bytes; n < 2^24                                     by linear forms
    one digit       likewise, and n < 2^8 d                                       by linear forms
    upper, three, subtract   x >= q d                                             by linear forms
    less            what is left of x, and is reduced by d until it is less       by bits

An estimate is q = floor((2^8 h + h v + l) / 2^8) with h:l at most x P / 2^(8 j). So 2^8 q d P is at most
(2^8 + v) d P h + d P l <= 2^(8 + 8 j) (2^8 h + l) <= 2^8 x P. As x < 2^8 d, q is a byte.

Then instructions are left out in turn, and each time the proof must fail.
"""

import sys
from functools import partial

import numpy
import z3

from arrays import Arrays
from bits import Bits, joined, same
from form import known
from machine_code import Program, demand
from stretches import Bounded, kept

DIVIDEND, DIVISOR, COUNT, SIGNS = 22, 18, 26, 27  # registers, the lowest of several
NEEDLESS = ("ret", "rjmp")
CHOICES = (*NEEDLESS, "and")  # without a test, the longer way returns the same
SPARSE, EVERY = 2, 8  # instructions of a stretch, of which one is left out


class Returning(Bits):
    returns_in_memory = True


def wide(number, size=64):
    return z3.ZeroExt(size - number.size(), number)


def magnitude(number):
    return z3.If(number < 0, -number, number)


class Division:
    """The statements at the labels of one kernel; `quotient` and `floored` say what it returns."""

    def __init__(self, name, quotient, floored):
        self.name, self.quotient, self.floored = name, quotient, floored

    def begin(self, label, m):
        """The check of the stretch, from registers that satisfy the statement at the label."""
        n, d = z3.BitVecs("n d", 32)
        negative = z3.Bools("a_negative b_negative")
        taken = z3.BitVec("taken", 32)
        address = m.number(16, 2)
        if label is None:
            a, b = m.number(DIVIDEND, 4), m.number(DIVISOR, 4)
            m.holds += [n == magnitude(a), d == magnitude(b), negative[0] == (a < 0), negative[1] == (b < 0)]
            taken = z3.BitVecVal(0, 32)
        else:
            m.flags["T"] = negative[0]
            if self.quotient:
                m.registers[1] = z3.BitVec("r1", 8)
            m.holds += self.conditions(label, m, n, d, negative, taken)
        first, dividend = wide(self.complement(m)), m.number(DIVIDEND, 4)

        def check(m, end):
            end = end and end[2:].split("_")[0]
            if end is None:
                conditions = self.results(m, n, d, negative, dividend, first if label == "done" else None, address)
            else:
                one, doubled = label == "subtract", label in ("down", "subtract") and end != "subtract"
                conditions = self.conditions(end, m, n, d, negative, taken + m.number(DIVISOR, 4) if one else taken)
                if self.quotient and label is not None:
                    conditions.append(z3.Or(d == 0, wide(self.complement(m)) == (first * 2 + int(one) if doubled else first)))
            # One after the other: together they take the solver several times as long.
            demand(all(m.impossible(z3.Not(condition)) for condition in conditions))
        return check

    def complement(self, m):
        """The quotient's magnitude."""
        parts = (m.registers[register] for register in (31, 30, 1, 0))
        return ~z3.Concat(*parts) if self.quotient else z3.BitVecVal(0, 32)

    def conditions(self, label, m, n, d, negative, taken):
        dividend, divisor, count = m.number(DIVIDEND, 4), m.number(DIVISOR, 4), wide(m.registers[COUNT], 32)
        q, top = self.complement(m), z3.BitVecVal(1 << 31, 32)
        moved = count - 1 if label == "subtract" else count
        # As S = q D.
        said = [z3.ULE(q, z3.LShR(taken, count)), z3.Implies(z3.UGT(d, 1), z3.ULE(q, z3.LShR(taken, count + 1))),
                n == taken + dividend, z3.ULE(taken, n),
                z3.ULE(moved, 31), divisor == d << moved, z3.LShR(divisor, moved) == d]
        said += {"bytes": [taken == 0, count & 7 == 0, z3.Or(count == 0, z3.ULE(divisor, n))],
                 "bits": [taken == 0, d != 0],
                 "down": [z3.ULT(dividend, divisor), count != 0],
                 "subtract": [z3.ULE(divisor, dividend), z3.Or(divisor < 0, z3.ULT(dividend, divisor * 2))],
                 "done": [z3.ULT(dividend, divisor), count == 0]}[label]
        if label == "done" and not self.floored:
            limit = z3.If(n == 0, n, top) if self.quotient else q
            said = [z3.Or(z3.And(d == 0, dividend == n, q == limit, z3.Or(count == 0, not self.quotient)), z3.And(*said))]
        return [*said, m.flags["T"] == negative[0], z3.ULE(n, top), z3.ULE(d, top), z3.Implies(n == top, negative[0]),
                z3.Implies(negative[1], d != 0),
                (m.registers[SIGNS] < 0) == z3.Xor(*negative) if self.quotient else m.registers[1] == 0]

    def results(self, m, n, d, negative, rest, q, address):
        """Of n = q d + rest, or without a quotient of d = 0."""
        quotient = z3.If(n == 0, wide(n, 34), z3.BitVecVal(1 << 31, 34)) if q is None else z3.Extract(33, 0, q)
        rest = wide(rest, 34)
        up = z3.And(self.floored, z3.Xor(*negative), rest != 0, d != 0)
        quotient = z3.If(up, quotient + 1, quotient)
        rest = z3.If(up, rest - wide(d, 34), rest)
        quotient = z3.If(z3.Xor(*negative), -quotient, quotient)
        limit = z3.BitVecVal((1 << 31) - 1, 34)
        wanted = (z3.If(quotient > limit, limit, quotient), z3.If(negative[0], -rest, rest))
        if not self.quotient:
            return [z3.SignExt(2, m.number(DIVIDEND, 4)) == wanted[1]]
        demand(len(m.stored) == 8)
        found = [z3.SignExt(2, z3.Concat(*(byte for _, byte in reversed(m.stored[i:i + 4])))) for i in (0, 4)]
        return [z3.Or(d == 0, q is not None), *(x == y for x, y in zip(found, wanted)),
                *(place == address + i for i, (place, _) in enumerate(m.stored))]

    def stretches(self):
        labels = {None: f"fixedpoint_{self.name}_q16_16"} | {
            label: f".L{label}_{self.name}" for label in ("bytes", "bits", "down", "subtract", "done")}
        ends = {"bytes": ("bytes", "bits", "done", None), "bits": ("bits", "down", "subtract", "done"),
                "down": ("down", "subtract", "done"), "subtract": ("down", "done"), "done": (None,)}
        if self.quotient:
            ends[None] = ("bytes",)
        for label in ends:
            following = tuple(end and labels[end] for end in ends[label])
            yield labels[label], partial(self.begin, label), following, (), ((),), (None,)


N, D, POWER, RECIPROCAL, DIGIT, H, L = (22, 23, 24), (18, 19, 20), 26, 27, 21, 31, 30
ENTRY, BYTES = "fixedpoint_remainder_q16_16", ".Lbytes_remainder"
ANY = ((),), (None,)
POWERS = [(i,) for i in range(8)]
REMAINDER = Division("remainder", False, False)


def signs(m):
    a, b = joined(m, (*N, 25)), joined(m, (*D, 21))

    def check(m, end):
        if end is None:
            demand(m.impossible(z3.Or(joined(m, (*N, 25)) != a, z3.Not(z3.Or(b == 0, z3.ULT(magnitude(a), magnitude(b)))))))
            return
        demand(m.impossible(z3.Or(joined(m, (*N, 25)) != magnitude(a), joined(m, (*D, 21)) != magnitude(b),
                                  m.flag("T") != (a < 0), z3.ULT(magnitude(a), magnitude(b)))) and m.is_zero(1))
    return check


def magnitudes(m):
    n, d, negative = joined(m, (*N, 25)), joined(m, (*D, 21)), z3.Bools("a_negative b_negative")
    m.flags["T"] = negative[0]
    m.holds += [z3.UGE(n, d), z3.ULE(n, 1 << 31), z3.Implies(n == 1 << 31, negative[0]), z3.Implies(negative[1], d != 0)]
    unchanged = same(m, (*N, *D))

    def check(m, end):
        unchanged(m)
        demand(m.flag("T") is negative[0])
        if end == BYTES:
            said = REMAINDER.conditions("bytes", m, n, d, negative, z3.BitVecVal(0, 32))
            demand(all(m.impossible(z3.Not(condition)) for condition in said))
            return
        demand(m.impossible(z3.Or(z3.UGE(n, 1 << 24), (m.registers[D[2]] == 0) == (end == ".Lthree_bytes"),
                                  z3.ULT(d, 256))))
    return check


def reciprocal(upper, m):
    m.given["upper"] = numpy.arange(1 << 8, 1 << 16)
    m.place(m.given["upper"], upper)

    def check(m, _):
        demand(all(map(m.untouched, (*N, *(register for register in D if register not in upper)))) and m.transfer is None)
        power, above = m.number((POWER,)), m.given["upper"] + 1
        demand((m.number(upper) == above - 1).all() and numpy.isin(power, [1 << i for i, in POWERS]).all())
        demand((above * power * (256 + m.number((RECIPROCAL,))) <= 1 << 24).all() and (above * power <= 1 << 16).all())
    return check


def estimate(size, label, m, i):
    """By the reciprocal of a divisor of `size` bytes and P = 2^i."""
    m.zero(25)
    m.hold(1, m.registers[D[size - 1]])
    if size == 2:
        m.zero(D[2])
    m.registers[POWER] = known(1 << i)
    n, d, v = m.number(N), m.number(D), m.registers[RECIPROCAL]
    shifted, w = d * (1 << i), v + known(256)
    left = known(1 << 8 + 8 * size) - m.times(shifted, w), known(1 << 8 * size) - shifted
    for form in left:
        m.hold(0, form)
    if label == ".Lone_digit":
        m.hold(1, d * 256 - n)
    unchanged, found = kept(m, *N, *D, 25), kept(m, POWER, RECIPROCAL)

    def check(m, end):
        h, l, q = m.registers[H], m.registers[L], m.registers[DIGIT]
        x = m.number(N[1:]) if end == ".Lupper" else n
        m.possible([])
        m.show(*unchanged(m))
        if end == ".Lone_digit":
            m.show((1, d * 256 - n, None), *found(m))
            return
        total = m.times(h, w) + l
        m.learn((0, m.registers[0], 255), (0, x * (1 << i) - (h * 256 + l) * (1 << 8 * size - 8), None), (0, h, 255), (0, l, 255))
        for one, other in ((h, left[0]), (l, left[1]), (m.registers[0], shifted), (q, d)):
            m.hold(0, m.times(one, other))
        m.show((0, x - m.times(q, d), None), (0, total - q * 256, 255), *(found(m) if end == ".Lupper" else ()))
    return check


def multiple(top, x, m):
    """Subtracts from x the digit times the lower two bytes of the divisor, or `top`, times its third one."""
    m.zero(25)
    before, q = m.number(x), m.registers[DIGIT]
    lower, upper = m.times(q, m.number(D[:2])), m.times(q, m.registers[D[2]]) * 65536
    taken = upper if top else lower
    m.hold(0, before - lower - (upper if top else known(0)))
    unchanged = kept(m, *D, DIGIT, 25, *(register for register in (*N, POWER, RECIPROCAL) if register not in x))

    def check(m, _):
        m.possible([])
        m.same(m.number(x), before - taken, 1 << 8 * len(x))
        m.show((0, before - taken - (lower if top else known(0)), None), *unchanged(m))
    return check


def less(x, m):
    left, d, negative = joined(m, x), joined(m, D[:len(x)]), z3.Bool("negative")
    m.registers[25], m.flags["T"] = z3.BitVecVal(0, 8), negative
    m.registers[1] = z3.BitVec("product", 8)
    unchanged = same(m, (*D, 25, *(register for register in N if register not in x), *((POWER, RECIPROCAL) if x != N else ())))

    def check(m, end):
        if end is None:
            rest = wide(left, 32)
            demand(m.impossible(z3.Or(z3.UGE(left, d), joined(m, (*N, 25)) != z3.If(negative, -rest, rest))))
            return
        unchanged(m)
        demand(m.flag("T") is negative)
        again = end != ".Lone_digit"
        demand(m.impossible(z3.Or(z3.UGE(left, d) != again, joined(m, x) != (left - d if again else left))))
    return check


SHORT = [(ENTRY, signs, (".Lmagnitudes", None), (), *ANY),
         (".Lmagnitudes", magnitudes, (".Lreciprocal", ".Lthree_bytes", BYTES), (), *ANY),
         (".Lreciprocal", partial(reciprocal, D[:2]), (".Lfound_two",), (), *ANY),
         (".Lthree_bytes", partial(reciprocal, D[1:]), (".Lfound_three",), (), *ANY),
         (".Lfound_two", partial(estimate, 2, ".Lfound_two"), (".Lupper", ".Lone_digit"), (), POWERS, (None,)),
         (".Lupper", partial(multiple, False, N[1:]), (".Lless_upper",), (), *ANY),
         (".Lless_upper", partial(less, N[1:]), (".Lless_upper", ".Lone_digit"), (), *ANY),
         (".Lone_digit", partial(estimate, 2, ".Lone_digit"), (".Lsubtract",), (), POWERS, (None,)),
         (".Lfound_three", partial(estimate, 3, ".Lfound_three"), (".Lthree",), (), POWERS, (None,)),
         (".Lthree", partial(multiple, True, N), (".Lsubtract",), (), *ANY),
         (".Lsubtract", partial(multiple, False, N), (".Lless",), (), *ANY),
         (".Lless", partial(less, N), (".Lless", None), (), *ANY)]
CUTS = [(".Lreciprocal", ".Lmagnitudes", "mov", "r30"), (".Lfound_two", ".Lmagnitudes", "cp", "r23"),
        (".Lupper", ".Ltwo_digits", "mul", "r21"), (".Lless_upper", ".Lupper", "sub", "r18"),
        (".Lfound_three", ".Lthree_bytes", "mul", "r24"), (".Lthree", ".Lfound_three", "mul", "r21"),
        (".Lless", ".Lsubtract", "sub", "r18")]
DOMAINS = {Arrays: (".Lreciprocal", ".Lthree_bytes"),
           Bounded: (".Lfound_two", ".Lupper", ".Lone_digit", ".Lfound_three", ".Lthree", ".Lsubtract")}


def main():
    failed = False
    sources = ("remainder_q16_16", "long_division_table")
    restoring = list(REMAINDER.stretches())
    others = [label for label, *_ in SHORT if not any(label in labels for labels in DOMAINS.values())]
    for machine, labels in ((Returning, others), *DOMAINS.items()):
        failed |= Program(SHORT + restoring, machine, sources=sources, cuts=CUTS).run(SPARSE, CHOICES, labels)
    # The kernels are one macro: of two, the first instruction of each stretch is left out.
    for kernel, every in ((("remainder", False, False), 99), (("divrem", True, False), 99), (("divmod", True, True), EVERY)):
        failed |= Program(list(Division(*kernel).stretches()), Returning, sources=sources).run(every, NEEDLESS)
    return failed


if __name__ == "__main__":
    sys.exit(main())
