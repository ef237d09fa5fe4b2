#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Proves that the lengths of Q16.16 are the integers nearest to the root of the sum of the squares, at most 2^31 - 1, for all
vectors of two and three components, from the instructions and their tables.

usage: prove_lengths.py

The statements about the registers at each label; v is the vector, at address 0:

    component   S is the sum of the squares before Z                                             by bits
    square      x is the magnitude of the component that Z has passed, below 2^23                by linear forms
    root        S of all of them, N from here on; r1 is 0 where it is                            by bits
    table       the upper 24 bits of N 4^k, which is 2^46 at least                               by running it
    back        R <= sqrt(N 4^k) < R + 12                                                        by bits
    near        r = floor(R / 2^k + 1/2)                                                         by linear forms
    step        n = N - r (r + 1) - 1 modulo 2^32, not negative                                  by linear forms
    done        likewise, negative; or r as at `near`, the same for R + 12                       by linear forms

At `near`, -1/2 <= sqrt(N) - r < 13, so n is between -2^26 and 2^29 and its four bytes have its
sign; from there on r (r - 1) < N or r = 0, and n decreases. At `done`, r is nearest, since a root is
never an integer plus one half: either N <= r (r + 1), or r - 1/2 <= sqrt(N) < r + 1/2.

From the first component of 2^23 or more on:

    long        S, and that component, at most 2^31, with `count` components left                by bits
    square      likewise, below 2^31                                                             by linear forms
    next        S with its square                                                                by bits
    sum         n, the sum of all squares, 2^46 at least                                         by bits
    normalised  n 4^k = 2^24 M + what is cut, 2^62 at least                                      by running it, for the upper
    third       S' < sqrt(2^8 M), and the slope; what they make of d = sqrt(2^8 M) - S'           24 bits of M
    quotient    2^8 m = 2^8 M - S'^2 + less than 2^8                                             by linear forms
    eighth      q = m slope / 2^16, x = slope (S' / 2^8) / 2^10 modulo 2^8, rounded downward     by linear forms
    turn        e = floor(q / 32)                                                                by running it, for all x and e
    fine        e x                                                                              by bits
    shift       T = 2^8 S' + q - e x / 2^8, 1 less where it is 2^32 or more                      by bits
    half        r = floor(T / 2^k), its fraction f; r or r + 1 is returned where f < 1/4 or >= 3/4   by bits
    signed      n - r (r + 1) - 1 modulo 2^32                                                    by linear forms

T is less than OFF off 2^8 sqrt(2^8 M), for which `normalised` reserves 1/64 for rounding downward;
the truncated part is worth CUT / 256. Shifted, both are less than 1/4 - 1/256, for the bits after
f: if f is below 1/4 or not below 3/4, the nearest integer is known. In between, sqrt(n) is less
than 1/2 off r + 1/2, so the four bytes have the sign. If T is 1 less, k ones lead its fraction:
from k = 2 on it is rounded up to the correct value. With k = 1, r is 2^31 - 1 and sqrt(n) is
between it and 2^31, and both are returned as 2^31 - 1.

Then instructions are left out in turn, and each time the proof must fail.
"""

import sys
from functools import partial

import numpy
import z3

from arrays import Arrays
from bits import Bits, joined, same
from form import Form, known
from machine_code import Program, demand
from stretches import Bounded, equal

S, X, UPPER, POINTER = (18, 19, 20, 21, 22, 23), (24, 25, 26), 27, (30, 31)
TOP, R, N, ROUNDED = (25, 26, 30), (31, 22, 23), (18, 19, 20, 21), (22, 23, 24)
SHIFT = 27
# 2^(8 - k mod 8) modulo 2^8, plus 1 outside of the third row; whether T is set; the lower bound of N
SHIFTS = [*((k, (1 << 8 - k) % 256 + 1, True, 40) for k in range(4)),
          *((k, 1 << 8 - k, None, 32) for k in range(4, 8)),
          *((k, (1 << 8 - k % 8) % 256 + 1, False, 40 - 8 * (k // 4)) for k in range(8, 24))]
ROOT, LONG = "fixedpoint_length_root", "fixedpoint_length_long"
CHUNK = 1 << 18
A, SUM, COUNT, ZERO, BACK = (24, 25, 26, 27), (18, 19, 20, 21, 22, 23, 16, 17), 28, 29, 17
M, ROOT_3, SLOPE, QUOTIENT, TURN, EIGHTH = (24, 25, 26, 27, 30), (22, 15, 28), 14, (27, 30, 31), 16, 23
FOUND, RESULT, LARGEST, SAVED = (27, 30, 22, 15, 28), (22, 23, 24, 25), 0x7fffffff, (28, 29, 17, 16, 15, 14)
CUT = {1: 4, 2: 16, 3: 64, 4: 1, 5: 4, 6: 16, 7: 64, 8: 1}  # of n 4^k, in units of 2^24
OFF = 0.44
ANY = ((),), (None,)


def constant(m, register):
    value = z3.simplify(m.registers[register])
    demand(z3.is_bv_value(value))
    return value.as_long()


def forget_product(m):
    m.registers[1] = z3.BitVec("product", 8)


def component(count, i, m):
    forget_product(m)
    m.memory = [z3.BitVec(f"v{n}", 8) for n in range(4 * (i + 1))]
    for register, byte in zip(POINTER if i else X[:2], (4 * i, 0)):
        m.registers[register] = z3.BitVecVal(byte, 8)
    v = z3.Concat(*reversed(m.memory[4 * i:]))
    magnitude = z3.If(v < 0, -v, v)
    unchanged = same(m, S if i else ())

    def check(m, end):
        demand(m.impossible(z3.ULT(magnitude, 1 << 23) != (end != LONG)))
        unchanged(m)
        demand(m.impossible(z3.Or(joined(m, (*X, UPPER)) != magnitude, joined(m, POINTER) != 4 * (i + 1))))
        if end == LONG:
            demand(m.impossible(m.registers[COUNT] != count - i) and (i or m.impossible(joined(m, S) != 0)))
    return check


def square(i, m):
    m.zero(UPPER)
    m.registers[X[2]] = m.variable("high", 127)
    x, before = m.number(X), m.number(S) if i else known(0)
    m.hold(0, before, i << 46)
    unchanged = same(m, POINTER)

    def check(m, end):
        if end != ROOT:
            unchanged(m)
        m.possible([])
        m.same(m.number(S), before + m.times(x, x), 1 << 48)
        m.show((0, m.number(S) - m.registers[1], None))
    return check


def normalised(m):
    forget_product(m)
    n = joined(m, S)
    m.holds += [z3.ULT(n, 3 << 46), z3.Or(n != 0, m.registers[1] == 0)]
    unchanged = same(m, N)

    def check(m, end):
        if end == ".Ldone":
            demand(m.impossible(z3.Or(n != 0, joined(m, ROUNDED) != 0)))
            return
        unchanged(m)
        back, larger = constant(m, SHIFT), m.flags.get("T")
        rows = [row for row in SHIFTS if row[1] == back and (row[2] is None or larger is not None and row[2] == z3.is_true(larger))]
        fits = [z3.And(z3.UGE(n, 1 << low), z3.LShR(wide := n << 2 * k, 2 * k) == n, z3.Extract(47, 24, wide) == joined(m, TOP),
                       z3.UGE(m.registers[TOP[2]], 64)) for k, _, _, low in rows]
        demand(m.impossible(z3.Not(z3.Or(*fits))))
    return check


def estimate(m, first):
    m.given["top"] = numpy.arange(first, first + CHUNK, m.program.stride)
    m.place(m.given["top"], TOP)

    def check(m, _):
        demand(all(map(m.untouched, (*N, SHIFT))))
        top, root = m.given["top"], numpy.asarray(m.number(R), dtype=numpy.int64)
        demand((root >= 0).all() and (root < 1 << 24).all())
        demand((root * root <= top << 24).all() and ((root + 12) ** 2 >= top + 1 << 24).all())
    return check


def back(m, k, shift, larger, low):
    forget_product(m)
    root = z3.ZeroExt(1, joined(m, R))
    m.registers[SHIFT] = z3.BitVecVal(shift, 8)
    if larger is not None:
        m.flags["T"] = z3.BoolVal(larger)
    if larger is False:
        m.holds += [z3.UGE(joined(m, N), 1 << low), z3.ULT(joined(m, N), 1 << low + 8 if low < 24 else 0xffffffff)]
    unchanged = same(m, N)
    half = root + (1 << k >> 1)

    def check(m, end):
        unchanged(m)
        demand(m.impossible(z3.ZeroExt(1, joined(m, ROUNDED)) != z3.LShR(half, k)))
        if end == ".Ldone":
            demand(m.impossible(z3.LShR(half + 12 - 1, k) != z3.LShR(half, k)))
    return check


def near(m):
    r, n = m.number(ROUNDED), m.number(N)
    unchanged = same(m, ROUNDED)

    def check(m, end):
        unchanged(m)
        demand(m.constant(m.number(N) - n + m.times(r, r) + r + known(1), 1 << 32) == 0)
        falls(m, end)
    return check


def falls(m, end):
    m.possible([])
    m.show((128, m.registers[N[3]], 255) if end == ".Ldone" else (0, m.registers[N[3]], 127))


def step(m):
    r, n = m.number(ROUNDED), m.number(N)
    m.hold(0, r, (1 << 24) - 2)

    def check(m, end):
        m.possible([])
        m.same(m.number(ROUNDED), r + known(1), 1 << 24)
        demand(m.constant(m.number(N) - n + r * 2 + known(2), 1 << 32) == 0)
        falls(m, end)
    return check


def done(m):
    r = m.number(ROUNDED)

    def check(m, _):
        m.show(equal(m.number((22, 23, 24, 25)), r))
    return check


def begin_long(m):
    forget_product(m)
    m.registers[ZERO] = z3.BitVecVal(0, 8)


def saturated(m):
    demand(m.impossible(joined(m, RESULT) != LARGEST))


def first_long(m):
    forget_product(m)
    a = joined(m, A)
    m.holds.append(z3.ULE(a, 1 << 31))
    unchanged = same(m, (*S, *A, COUNT, *POINTER))

    def check(m, end):
        demand(m.impossible((a < 0) != (end is None)))
        if end is None:
            saturated(m)
            return
        unchanged(m)
        demand(all(map(m.is_zero, (*SUM[6:], ZERO))))
    return check


def long_square(m, count, high):
    m.zero(ZERO)
    m.registers[COUNT] = known(count)
    m.registers[A[2]], m.registers[A[3]] = known(high * 128) + m.variable("low", 127), m.variable("high", 127)
    a, before = m.number(A), m.number(SUM)
    m.hold(0, before, 1 << 63)
    unchanged = same(m, POINTER)

    def check(m, end):
        unchanged(m)
        demand((end == ".Lsum") == (count == 1))
        m.possible([])
        m.same(m.number(SUM), before + m.times(a, a), 1 << 64)
        m.show(equal(m.registers[COUNT], known(count - 1)), equal(m.registers[ZERO], known(0)))
    return check


def next_long(m, place):
    begin_long(m)
    m.memory = [z3.BitVec(f"v{n}", 8) for n in range(place + 4)]
    for register, byte in zip(POINTER, (place, 0)):
        m.registers[register] = z3.BitVecVal(byte, 8)
    v = z3.Concat(*reversed(m.memory[place:]))
    unchanged = same(m, (*SUM, COUNT, ZERO))

    def check(m, end):
        demand(m.impossible((v == 1 << 31) != (end is None)))
        if end is None:
            saturated(m)
            return
        unchanged(m)
        demand(m.impossible(z3.Or(joined(m, A) != z3.If(v < 0, -v, v), joined(m, POINTER) != place + 4)))
    return check


def long_sum(m):
    begin_long(m)
    n = joined(m, SUM)
    m.holds.append(z3.UGE(n, 1 << 46))
    unchanged = same(m, (*N, ZERO))

    def check(m, end):
        demand(m.impossible(z3.UGE(n, 1 << 62) != (end is None)))
        if end is None:
            saturated(m)
            return
        unchanged(m)
        k = 9 - constant(m, BACK).bit_length()
        demand(k in CUT and constant(m, BACK) == 1 << 8 - k)
        demand((OFF + CUT[k] / 256) / 2**k < 1 / 4 - 1 / 256)
        wide, kept = z3.ZeroExt(16, n) << 2 * k, z3.ZeroExt(40, joined(m, M)) << 24
        demand(m.impossible(z3.Or(z3.ULT(wide, kept), z3.UGE(wide - kept, CUT[k] << 24), z3.ULT(m.registers[M[4]], 64))))
    return check


def long_root(m, first):
    m.given["top"] = numpy.arange(first, first + CHUNK, m.program.stride)
    m.place(m.given["top"], M[2:])
    m.registers[ZERO] = 0

    def check(m, _):
        top, root, slope = m.given["top"], m.number(ROOT_3) * 1.0, m.registers[SLOPE] * 1.0
        demand(all(map(m.untouched, (*N, *M[:2], BACK))) and m.is_zero(ZERO) and (m.registers[M[2]] == top & 255).all())
        x = numpy.floor(slope * numpy.floor(root / 256) / 1024) - 8192
        demand((x >= -128).all() and (x < 128).all())
        for end in (top, top + 1):
            lack = numpy.sqrt(end * 2.0**24) - root
            q = (2 * root + lack) * lack * slope / 2**24
            demand((lack > 1e-6).all() and (q < 4095).all())
            for floor in (q / 32 - 1, q / 32):
                # The error is a parabola of the lack, which bends by less than this between the ends.
                demand((abs(q - floor * x / 256 - 256 * lack) < OFF - 1 / 64 - 1e-4).all())
    return check


def long_rest(m):
    m.zero(ZERO)
    rest, root = m.number(M[:3]) * 256, m.number(ROOT_3)
    unchanged = same(m, (*N, *ROOT_3, SLOPE, BACK, ZERO))

    def check(m, _):
        unchanged(m)
        m.possible([])
        off = m.number(M[:3]) * 256 - rest + m.times(root, root)
        left = Form({name: factor for name, factor in off.items() if factor % (1 << 32)})
        m.show((0, left, 255))
    return check


def long_quotient(m):
    m.zero(ZERO)
    slope, rest, upper = m.registers[SLOPE], m.number(M[:3]), m.number(ROOT_3[1:])
    product, turned = m.times(rest, slope), m.times(upper, slope)
    m.hold(0, product, (4096 << 16) - 1)
    unchanged = same(m, (*N, *ROOT_3, BACK, ZERO))

    def check(m, _):
        unchanged(m)
        m.possible([])
        m.show((0, product - m.number(QUOTIENT) * 256, 255), (0, turned - m.number((TURN, 1)) * 1024, 1023))
    return check


def long_eighth(m):
    begin_long(m)
    q = joined(m, QUOTIENT)
    m.holds.append(z3.ULT(q, 1 << 20))
    unchanged = same(m, (*N, *ROOT_3, *QUOTIENT, TURN, BACK, ZERO))

    def check(m, _):
        unchanged(m)
        demand(m.impossible(m.registers[EIGHTH] != z3.Extract(20, 13, q)))
    return check


def long_turn(m):
    cases = m.given["cases"] = numpy.arange(1 << 15)
    m.place(cases, (TURN, EIGHTH))

    def check(m, _):
        demand(all(map(m.untouched, (*N, *ROOT_3, *QUOTIENT, BACK, ZERO))))
        x, eighth = m.given["cases"] & 255, m.given["cases"] >> 8
        demand((m.number((0, 1)) == (x - (x >> 7) * 256) * eighth & 0xffff).all())
    return check


def long_fine(m):
    begin_long(m)
    quotient = joined(m, QUOTIENT) - z3.SignExt(8, joined(m, (0, 1)))
    total = z3.ZeroExt(1, z3.Concat(joined(m, ROOT_3), z3.BitVecVal(0, 16))) + z3.ZeroExt(17, quotient)
    m.holds.append(z3.ULT(total, (1 << 40) + 256))
    unchanged = same(m, (*N, BACK, ZERO))

    def check(m, _):
        unchanged(m)
        demand(m.impossible(joined(m, FOUND) != z3.Extract(39, 0, z3.If(z3.UGE(total, 1 << 40), total - 256, total))))
    return check


def long_shift(m, k):
    begin_long(m)
    m.registers[BACK] = z3.BitVecVal(1 << 8 - k, 8)
    root = z3.LShR(joined(m, FOUND), k)
    whole, fraction = z3.Extract(39, 8, root), z3.Extract(7, 0, root)
    unchanged = same(m, (*N, ZERO))

    def check(m, end):
        if end is None:
            demand(m.impossible(z3.Or(z3.And(z3.UGE(fraction, 64), z3.ULT(fraction, 192)),
                                      joined(m, RESULT) != raised(whole, fraction < 0))))
            return
        unchanged(m)
        demand(m.impossible(z3.Or(z3.ULT(fraction, 64), z3.UGE(fraction, 192), joined(m, RESULT) != whole,
                                  z3.Not(m.flag("C")))))
    return check


def raised(whole, up):
    more = whole + 1
    return z3.If(up, z3.If(more < 0, LARGEST, more), whole)


def long_half(m):
    m.zero(ZERO)
    m.carry = known(1)
    r, n = m.number(RESULT), m.number(N)
    unchanged = same(m, (*RESULT, ZERO))

    def check(m, _):
        unchanged(m)
        m.possible([])
        demand(m.constant(m.number(N) - n + m.times(r, r) + r + known(1), 1 << 32) == 0)
    return check


def long_signed(m):
    begin_long(m)
    whole, rest = joined(m, RESULT), joined(m, N)
    m.holds.append(whole >= 0)

    def check(m, _):
        demand(m.impossible(joined(m, RESULT) != raised(whole, rest >= 0)))
    return check


def of(count):
    """The stretches of the length of that many components, and their cuts."""
    name = f"fixedpoint_length{count}_q16_16"
    component_at = [name, *(f".Lcomponent{i}" for i in range(1, count)), ROOT]
    stretches, cuts = [], []
    for i in range(count):
        stretches += [(component_at[i], partial(component, count, i), (f".Lsquare{i}", LONG), (), *ANY),
                      (f".Lsquare{i}", partial(square, i), (component_at[i + 1],), (), *ANY)]
        cuts.append((f".Lsquare{i}", component_at[i], "mul", f"r{X[2] if i else X[0]}"))
        if i + 1 < count:
            cuts.append((component_at[i + 1], f".Lsquare{i}", "ld", "r24"))
    return name, stretches, cuts


SHARED = [(ROOT, normalised, (".Ltable", ".Ldone"), (), *ANY),
          (".Ltable", estimate, (".Lback",), (), [(i,) for i in range(1 << 22, 1 << 24, CHUNK)], (None,)),
          (".Lback", back, (".Lnear", ".Ldone"), (), SHIFTS, (None,)),
          (".Lnear", near, (".Lstep", ".Ldone"), (), *ANY),
          (".Lstep", step, (".Lstep", ".Ldone"), (), *ANY),
          (".Ldone", done, (None,), (), *ANY)]
LONGER = [(LONG, first_long, (".Lsquare", None), (28,), *ANY),
          (".Lsquare", long_square, (".Lnext", ".Lsum"), SAVED, [(i, high) for i in (1, 2, 3) for high in (0, 1)], (None,)),
          (".Lnext", next_long, (".Lsquare", None), SAVED, [(4,), (8,)], (None,)),
          (".Lsum", long_sum, (".Lnormalised", None), SAVED, *ANY),
          (".Lnormalised", long_root, (".Lthird",), SAVED, [(i,) for i in range(1 << 22, 1 << 24, CHUNK)], (None,)),
          (".Lthird", long_rest, (".Lquotient",), SAVED, *ANY),
          (".Lquotient", long_quotient, (".Leighth",), SAVED, *ANY),
          (".Leighth", long_eighth, (".Lturn",), SAVED, *ANY),
          (".Lturn", long_turn, (".Lfine",), SAVED, *ANY),
          (".Lfine", long_fine, (".Lshift",), SAVED, *ANY),
          (".Lshift", long_shift, (".Lhalf", None), SAVED, [(k,) for k in range(1, 9)], (None,)),
          (".Lhalf", long_half, (".Lsigned",), SAVED, *ANY),
          (".Lsigned", long_signed, (None,), SAVED, *ANY)]
LONG_CUTS = [(".Lnext", ".Lsquare", "ld", "r24"), (".Lthird", ".Lnormalised", "mul", "r22"),
             (".Lquotient", ".Lthird", "mul", "r26"), (".Leighth", ".Lquotient", "mov", "r23"),
             (".Lturn", ".Leighth", "mulsu", "r16"),
             (".Lfine", ".Lturn", "sbrc", "r1"), (".Lshift", ".Lfine", "mul", "r28"),
             (".Lhalf", ".Lshift", "sbc", "r18"), (".Lsigned", ".Lhalf", "add", "r21")]
CUTS = [*LONG_CUTS, (".Lstep", ".Lnear", "subi", "r22")]


def main():
    failed = False
    # Products of 0 may be added, too.
    needless = {Bits: ("ret", "rjmp", "jmp", "eor"), Arrays: ("rjmp",), Bounded: ("ret", "rjmp", "jmp", "breq")}
    by_bits = (ROOT, ".Lback", LONG, ".Lnext", ".Lsum", ".Leighth", ".Lfine", ".Lshift", ".Lsigned")
    for count in (3, 2):
        name, own, cuts = of(count)
        # Shared code is proven once.
        labels = [label for label, *_ in own + (SHARED + LONGER if count == 3 else [])]
        domains = {label: Bits if label in by_bits or label == name or label.startswith(".Lcomponent")
                   else Arrays if label in (".Ltable", ".Lnormalised", ".Lturn") else Bounded for label in labels}
        for machine in (Bits, Arrays, Bounded):
            program = Program(own + SHARED + LONGER, machine, cuts=cuts + CUTS,
                              sources=(f"length{count}_q16_16", "length_root", "length_long", "sqrt_table"))
            failed |= program.run(4, needless[machine], [label for label in labels if domains[label] is machine])
    return failed


if __name__ == "__main__":
    sys.exit(main())
