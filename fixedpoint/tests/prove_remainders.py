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

Then instructions are left out in turn, and each time the proof must fail.
"""

import sys
from functools import partial

import z3

from bits import Bits
from machine_code import Program, demand

DIVIDEND, DIVISOR, COUNT, SIGNS = 22, 18, 26, 27  # registers, the lowest of several
NEEDLESS = ("ret", "rjmp")
EVERY = 8  # instructions of a stretch, of which one is left out


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
        ends = {None: ("bytes",), "bytes": ("bytes", "bits", "done", None), "bits": ("bits", "down", "subtract", "done"),
                "down": ("down", "subtract", "done"), "subtract": ("down", "done"), "done": (None,)}
        for label in ends:
            following = tuple(end and labels[end] for end in ends[label])
            yield labels[label], partial(self.begin, label), following, (), ((),), (None,)


def main():
    failed = False
    # The kernels are one macro: of two, the first instruction of each stretch is left out.
    for kernel, every in ((("remainder", False, False), 99), (("divrem", True, False), 99), (("divmod", True, True), EVERY)):
        failed |= Program(list(Division(*kernel).stretches()), Returning, sources=("remainder_q16_16",)).run(every, NEEDLESS)
    return failed


if __name__ == "__main__":
    sys.exit(main())
