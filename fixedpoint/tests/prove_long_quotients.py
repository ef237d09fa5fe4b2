#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Proves that fixedpoint_divide_q32_32 returns the quotient rounded to nearest, half up, and
saturated, for all pairs of operands, from its instructions and its table.

usage: prove_long_quotients.py short|long    the code for divisors below 2^40; that for others, and the entry

The statements about the registers at each label (stretches.py); n = |a|, d = |b|, T: the signs
differ. Q = 2^32 n / d is sought; c digits remain, at least one. For divisors below 2^40:

    short         d < 2^40; n 2^32 / d is in range where n < 2^31 d
    in_range      Q = n 256^(c-1) / d, and d of c bytes more is D, once multiplied by 2^k
    skip, digit   row = U 2^64 + the bytes to come, with the digits so far below them; U < D
                  and Q = 256^c row / (2^64 D) at first; the bytes of row that are digits then are 0
    compare       the estimate of the digit g, and u, the highest three bytes of U (long_division.py);
                  at `full`, it is 256
    estimated     u = g h + r, r < h, where h is the highest two bytes of D; at `zero`, g = 0, and at
                  `whole`, g = 256
    next          R = 256 U + the next byte - g D, and 0 <= R < D
    high          the same, and R < 0, but above -D / 2^7: the digit that is kept is g - 1
    .Lcompare     U < D; .Lround_up: U is negative, and the last digit that is kept is 1 less

So each digit turns row into row' = 256 row - (2^64 D - 1) g; after a digit that is too high, the
digits g - 1 and 256 - t give 256 g - t, which is what was subtracted. By induction the last row is
256^c row - (2^64 D - 1) G, where G consists of all digits. Since 256^c row is divisible by 2^64,
and G < 2^63, the lower bytes are G, and U = D (Q - G).

Others: the same without a row, since all further bytes are 0; the digits are on the stack, above
the saved registers, and at the end there are 7 bytes, with leading zeros. Q <= 2^55. U = D (Q - G),
likewise. Then instructions are left out in turn, and each time the proof must fail.
"""

import sys
from functools import partial

from arrays import Arrays
from form import Form, known
from long_division import DIGIT, ESTIMATES, MANY, begin_compared, hold_reciprocal, invert, show_estimate
from machine_code import Program, demand
from stretches import Linear, equal, kept, zeros

NAME = "fixedpoint_divide_q32_32"
TABLE = "fixedpoint_long_division_table"
Q, D = range(18, 26), range(10, 18)
EVERY = 8  # instructions, of which one is left out
NEEDLESS = ("ret", "push", "pop")
ON_ENTRY = (14, 13, 12, 11, 10, 29, 28, 9, 8, 7)


class Divisors(Linear):
    """The powers of two that move the leading one of a byte to its highest bit: check_table()."""

    power = None

    def look_up(self, d):
        if self.power is None:
            return super().look_up(d)
        demand(self.registers[31] == known(self.program.labels[TABLE] >> 8) and self.registers[30] == self.top)
        self.registers[d] = known(self.power)
        return None


def check_table(program):
    for i, power in enumerate(program.flash[program.labels[TABLE]:][:128]):
        demand(i == 0 or 128 <= power * i < 256 and power & power - 1 == 0)


class Way:
    """Of divisors of one size: the registers of D, of what a digit divides, the lowest first, of the
    row below that, highest first, and what was pushed."""

    def __init__(self, name, d, r, row, saved, zero, count, inverse):
        self.name, self.d, self.r, self.row, self.saved = name, d, r, row, saved
        self.zero, self.count, self.inverse = zero, count, inverse
        self.h, self.tail, self.low, self.u = d[-2:], d[:-2], r[:-3], r[-3:]
        self.rest = r[:-1]  # of R
        self.row_digits = row[::-1]
        self.modulus = 1 << 8 * len(self.rest)
        self.least = -1 << 8 * len(self.tail) + 8  # what R exceeds

    def label(self, place):
        return f".L{self.name}_{place}"

    def same(self, m, *registers):
        return kept(m, *self.d, self.inverse, *registers)


SHORT = Way("short", D[:5], (25, 7, 8, 9, 28, 29), (24, 23, 22, 21, 20, 19, 18), (*ON_ENTRY, (17, 16, 15)), 16, 17, 15)
LONG = Way("long", D, (*Q, 29), (), (*ON_ENTRY, 17, 16, 15, 6, 5, 4), 28, 4, 5)
U, ROW = SHORT.r[1:], (*Q, *SHORT.r[1:])


def entry(m):
    m.zero(1)
    a, b = m.number(Q), m.number(D)

    def check(m, end):
        demand(m.signs)
        n, d = (known(1 << 64) - number if minus else number for number, minus in zip((a, b), m.signs))
        m.show(equal(m.number(Q), n), (0, n, 1 << 63))
        if end == ".Lshort":
            m.show(equal(m.number(SHORT.d), d))
        else:
            m.show(equal(m.number(D), d), (1 << 40, d, MANY))
    return check


def magnitudes(m, bytes_of_d):
    n, d = m.number(Q), m.number(bytes_of_d)
    m.hold(0, n, 1 << 63)
    return n, d


def short(m):
    n, d = magnitudes(m, SHORT.d)
    same = kept(m, *Q, *SHORT.d)

    def check(m, end):
        fits = end == ".Lin_range"
        m.show((-MANY, n - d * (1 << 31), -1) if fits else (0, n - d * (1 << 31), MANY), *same(m))
    return check


def out_of_range(m):
    """The quotient is at least 2^63, or 0 / 0."""
    n = m.number(Q)

    def check(m, end):
        for given, result in (((1, n, MANY), 1 << 63 if m.transfer else (1 << 63) - 1), ((0, n, 0), 0)):
            if m.possible([given]):
                m.show(equal(m.number(Q), known(result)))
        m.possible([])
    return check


def moved(of, m, d, c):
    """D = d 256^(c - 5)"""
    return [equal(m.number(of.d), d * (1 << 8 * c - 40)), (1, m.registers[of.d[-1]], 255),
            equal(m.registers[of.zero], known(0))]


def in_range(m):
    n, d = magnitudes(m, SHORT.d)
    m.hold(None, n - d * (1 << 31), -1)
    same = kept(m, *Q)

    def check(m, end):
        c = m.registers[SHORT.count].constant()
        demand(5 <= c <= 9)
        m.show(*moved(SHORT, m, d, c), *same(m))
    return check


def begin_scale(of, m, k):
    m.zero(of.zero)
    m.power, m.top = 1 << k, m.registers[of.d[-1]]
    m.hold(128 >> k, m.top, 255 >> k)
    return magnitudes(m, of.d)


def shown_scaled(of, m, d, k):
    return [equal(m.number(of.d), d * (1 << k)), (128, m.registers[of.d[-1]], 255), equal(m.registers[of.zero], known(0))]


def short_scale(m, k):
    n, d = begin_scale(SHORT, m, k)
    count = m.registers[SHORT.count]
    m.hold(5, count, 9)
    transfer = m.transfer

    def check(m, end):
        demand(m.transfer == transfer)
        more = m.constant(m.registers[SHORT.count] - count, 256)
        demand(more < 4)
        # 256^more row = 2^56 n 2^k
        m.show(equal(m.number(ROW), n * (1 << 56 - 8 * more + k)), equal(m.registers[SHORT.count], count + known(more)),
               (1, m.number(SHORT.d) - m.number(U), MANY), *shown_scaled(SHORT, m, d, k), *zeros(m, Q[:4]))
    return check


def long_count(m):
    n, d = magnitudes(m, D)
    m.hold(1 << 40, d)
    same = kept(m, *Q)

    def check(m, end):
        c = m.registers[30].constant()
        demand(5 <= c <= 7)
        for _ in range(7 - c):
            demand(m.stack.pop() == known(0))
        m.show(*moved(LONG, m, d, c), *same(m))
    return check


def long_scale(m, k):
    n, d = begin_scale(LONG, m, k)
    count = m.registers[30]
    transfer = m.transfer

    def check(m, end):
        demand(m.transfer == transfer)
        m.show(equal(m.number(LONG.r), n * (1 << k)), *shown_scaled(LONG, m, d, k), equal(m.registers[LONG.count], count),
               (1, m.number(D) * 256 - m.number(LONG.r), MANY))
    return check


def inverse(of):
    idle = {*of.d, *of.r, *of.row, of.zero, of.count} - {*of.h}
    return partial(invert, h=of.h, inverse=of.inverse, idle=idle)


def begin_digit(of, m):
    """h, the rest of D, D, and what the digit divides"""
    m.zero(of.zero)
    m.hold(128, m.registers[of.h[1]])
    m.hold(1, m.registers[of.count])
    return m.number(of.h), m.number(of.tail), m.number(of.d), m.number(of.r)


def skip(m):
    _, _, d, _ = begin_digit(SHORT, m)
    m.zero(*Q[:4])
    m.hold(1, d - m.number(U))
    row, count = m.number(ROW), m.registers[SHORT.count]
    same, still = SHORT.same(m, SHORT.zero), kept(m, *ROW, SHORT.count)

    def check(m, end):
        m.show(*same(m))
        if end in (".Lskip", ".Lcompare"):
            m.show(equal(m.number(ROW), row * 256), (1, d - m.number(U), MANY), *zeros(m, Q[:4]))
            counted(m, SHORT, count, end == ".Lcompare")
        else:
            m.show(*still(m), *zeros(m, D[:3] if end == ".Lexact_digit" else ()))
    return check


def counted(m, of, before, last):
    if last:
        m.show(equal(before, known(1)))
    else:
        m.show(equal(m.registers[of.count], before - known(1)), (1, m.registers[of.count], MANY))


def estimate(of, m, small, exact=False):
    """The digits that are exact have one way for all estimates."""
    h, _, d, divided = begin_digit(of, m)
    m.zero(*(D[:3] if exact else ()))
    hold_reciprocal(m, of.inverse, h, small)
    m.hold(1, d * 256 - divided)
    u0, u1, u2 = (m.registers[register] for register in of.u)
    v = m.registers[of.inverse]
    same = of.same(m, *of.low, of.u[2], *of.row, of.zero, of.count)

    def check(m, end):
        show_estimate(m, small, v, h, u2, u1, u0, *of.u[:2])
        m.show(*same(m))
        if not exact:
            m.show((0, m.registers[DIGIT], 0) if end == of.label("full") else (1, m.registers[DIGIT], 255))
    return check


def begin_estimate(of, m, over, which):
    h, _, d, _ = begin_digit(of, m)
    u = begin_compared(m, over, which, h, *of.u[::-1])
    m.hold(1, d * 256 - u * (1 << 8 * len(of.low)) - m.number(of.low))
    return h, m.registers[DIGIT] + known(over), u


def corrected(m, h, t, u, byte, rest):
    """The digit, and what shows that u = digit h + rest, rest < h."""
    more = (m.constant(byte - t, 256) + 1) % 256 - 1
    demand(more in (-1, 0, 1))
    digit = t + known(more)
    return digit, [equal(u, m.times(digit, h) + rest), (0, rest, MANY), (1, h - rest, MANY)]


def compare(of, m, over, which):
    h, t, u = begin_estimate(of, m, over, which)
    same = of.same(m, *of.low, of.u[2], *of.row, of.zero, of.count)

    def check(m, end):
        digit, right = corrected(m, h, t, u, m.registers[DIGIT], m.number(of.u[:2]))
        least = {of.label("zero"): 0, of.label("whole"): 256}
        m.show(*right, (least.get(end, 0), digit, least.get(end, 255)), *same(m),
               equal(m.registers[DIGIT], known(0) if end == of.label("whole") else digit))
    return check


def exact_compare(m, over, which):
    """Here u < 2^8 h."""
    of = SHORT
    h, t, u = begin_estimate(of, m, over, which)
    m.zero(*D[:3])
    m.hold(1, h * 256 - u)
    low, row, count = m.number(of.low), m.number(of.row_digits), m.registers[of.count]
    same = of.same(m, of.zero)

    def check(m, end):
        rest = m.number(of.u[1:])  # where it has moved to
        digit, right = corrected(m, h, t, u, m.registers[Q[0]], rest)
        if m.feasible():
            m.show(*right, equal(m.number(U), rest * (1 << 24) + low), equal(m.number(Q), row * 256 + digit), *same(m))
            counted(m, of, count, end == ".Lcompare")
    return check


def subtract(of, m, over, zero=False):
    h, tail, d, _ = begin_digit(of, m)
    if over or zero:
        m.zero(DIGIT)
    digit, rest = m.registers[DIGIT] + known(over), m.number(of.u[:2])
    m.hold(1, h - rest)
    m.hold(0, m.times(digit, h) + rest - m.registers[of.u[2]] * 65536, 65535)
    lower, before = m.number(of.low), m.registers[DIGIT]
    left = rest * (1 << 8 * len(of.low)) + lower - m.times(digit, tail)
    # Of divisors of six bytes, the lowest two are 0.
    two = m.number(of.tail[:2])
    left_of_six = left + m.times(digit, two)
    if over:
        # Then u = 2^8 h + r.
        m.hold(1, (tail - rest * (1 << 8 * len(of.tail) - 8)) * 256 - lower)
    same = of.same(m, *of.row, of.zero, of.count)

    def check(m, end):
        high = end == of.label("high")
        m.possible([])
        six = of is LONG and not m.reaches(1, two)
        m.same(m.number(of.rest) - known(of.modulus * high), left_of_six if six else left, of.modulus)
        m.show((of.least + 1, left, -1) if high else (0, left, MANY), equal(m.registers[DIGIT], before), *same(m))
        if not high:
            m.show((1, d - left, MANY), equal(before, digit))
    return check


def following(of, m):
    _, _, d, _ = begin_digit(of, m)
    left, row, digit, count = m.number(of.rest), m.number(of.row_digits), m.registers[DIGIT], m.registers[of.count]
    m.hold(1, d - left)
    same = of.same(m, of.zero)

    def check(m, end):
        last = end in (".Lcompare", ".Llong_round")
        m.show(*same(m))
        if of is SHORT:
            m.show(equal(m.number(U), left), equal(m.number(Q), row * 256 + digit))
        else:
            demand(m.stack.pop() == digit)
            m.show(equal(m.number(of.rest if last else of.r), left * (1 if last else 256)))
        counted(m, of, count, last)
    return check


def high(of, m, over):
    _, _, d, _ = begin_digit(of, m)
    left, count = m.number(of.rest) - known(of.modulus), m.registers[of.count]
    m.hold(of.least + 1, left, -1)
    if over:
        m.zero(DIGIT)
    else:
        m.hold(1, m.registers[DIGIT])
    digit = m.registers[DIGIT] + known(over - 1)
    row, coming = m.number(of.row_digits), known(0) if of is LONG else m.registers[of.row[0]]
    upper = m.number(of.row_digits[:-1])
    transfer = m.transfer
    same = of.same(m, of.zero)

    def check(m, end):
        demand(m.transfer == transfer)
        last = end in (".Lround_up", ".Llong_round_up")
        if of is LONG:
            m.learn(equal(m.stack.pop(), digit))
        elif last:
            m.show(equal(m.number(Q), row * 256 + digit))
        else:
            m.show(equal(m.number(of.row_digits), upper * 256 + digit))
        if not last:
            less = 256 - m.registers[DIGIT].constant()
            rest = left * 256 + coming + d * less
            m.possible([])
            m.same(m.number(of.r), rest, of.modulus * 256)
            m.show((0, rest, MANY), (1, d - rest, MANY), equal(m.registers[of.r[-1]], known(0)), *same(m))
        counted(m, of, count, last)
    return check


def begin_last(of, m):
    """U, D, the digits"""
    if of is SHORT:
        quotient = m.number(Q)
        m.hold(0, quotient, (1 << 63) - 1)
        return m.number(U), m.number(of.d), quotient
    left, digits, quotient = m.number(of.rest), [m.variable("digit") for _ in range(7)], known(0)
    m.stack += digits
    for digit in digits:
        quotient = quotient * 256 + digit
    m.hold(0, quotient, 1 << 55)
    return left, m.number(of.d), quotient


def congruent(form, modulus):
    """The same modulo a power of two, with small factors."""
    half = modulus // 2
    return Form({name: (factor + half) % modulus - half for name, factor in form.items() if factor % modulus})


def rounded(of, m, up):
    """The remainder rounds; if it is negative, upward."""
    left, d, quotient = begin_last(of, m)
    m.hold(128, m.registers[of.d[-1]])
    m.hold(1, d - left)
    same, digits = kept(m, *Q if of is SHORT else ()), m.stack[len(of.saved):]

    def check(m, end):
        if end is not None:
            demand(m.stack[len(of.saved):] == digits)
            del m.stack[len(of.saved):]
            m.show((1, left * 2 - d, MANY), *same(m))
            return
        result = m.number(Q)
        if not set(result) - {1}:
            # The nearest number is beyond the largest, by 1.
            demand(not m.transfer)
            m.show(equal(result, known((1 << 63) - 1)), equal(quotient, result))
            rounds_up = known(1)
        else:
            rounds_up = congruent(result * (-1 if m.transfer else 1) - quotient, 1 << 64)
            m.show((int(up), rounds_up, 1), (0, known(0) if m.transfer else result, (1 << 63) - 1))
        for more in () if up else (0, 1):
            if m.possible([equal(rounds_up, known(more))]):
                twice = (left - d * more) * 2
                m.show((int(m.transfer), twice + d, MANY), (int(not m.transfer), d - twice, MANY))
    return check


def of_digits(of):
    label = of.label
    corrected_at = label("zero"), label("estimated"), label("whole")
    for place, over in ("compare", 0), ("full", 256):
        yield label(place), partial(compare, of), corrected_at, of.saved, [case for case in ESTIMATES if case[0] == over]
    yield label("digit"), partial(estimate, of), (label("compare"), label("full")), of.saved, [(True,), (False,)]
    ends = (label("next"), label("high"))
    yield label("estimated"), partial(subtract, of), ends, of.saved, [(0,)]
    yield label("zero"), partial(subtract, of, zero=True), ends, of.saved, [(0,)]
    yield label("whole"), partial(subtract, of), ends, of.saved, [(256,)]


POWERS = [(k,) for k in range(8)]


def short_stretches():
    saved = SHORT.saved
    yield ".Lshort", short, (".Lin_range", ".Lout_of_range"), saved
    yield ".Lout_of_range", out_of_range, (None,), saved
    yield ".Lin_range", in_range, (".Lshort_scale",), saved
    yield ".Lshort_scale", short_scale, (".Lshort_invert",), saved, POWERS
    yield ".Lshort_invert", inverse(SHORT), (".Lskip",), saved, ((),), (None,)
    yield ".Lskip", skip, (".Lskip", ".Lcompare", ".Lexact_digit", ".Lshort_digit"), saved
    yield ".Lexact_digit", partial(estimate, SHORT, exact=True), (".Lexact_compare",), saved, [(True,), (False,)]
    yield ".Lexact_compare", exact_compare, (".Lexact_digit", ".Lcompare"), saved, ESTIMATES
    yield from of_digits(SHORT)
    yield ".Lshort_next", partial(following, SHORT), (".Lshort_digit", ".Lcompare"), saved
    yield ".Lshort_high", partial(high, SHORT), (".Lshort_next", ".Lround_up"), saved, [(0,), (256,)]
    yield ".Lcompare", partial(rounded, SHORT, up=False), (None,), saved
    yield ".Lround_up", partial(rounded, SHORT, up=True), (None,), saved


def long_stretches():
    saved = LONG.saved
    yield NAME, entry, (".Lshort", ".Llong_count"), ()
    yield ".Llong_count", long_count, (".Llong_scale",), saved[:-3]
    yield ".Llong_scale", long_scale, (".Llong_invert",), saved, POWERS
    yield ".Llong_invert", inverse(LONG), (".Llong_digit",), saved, ((),), (None,)
    yield from of_digits(LONG)
    yield ".Llong_next", partial(following, LONG), (".Llong_digit", ".Llong_round"), saved
    yield ".Llong_high", partial(high, LONG), (".Llong_next", ".Llong_round_up"), saved, [(0,), (256,)]
    yield ".Llong_round", partial(rounded, LONG, up=False), (None,), saved
    yield ".Llong_round_up", partial(rounded, LONG, up=True), (None,), saved


STRETCHES = {"short": short_stretches, "long": long_stretches}


def main():
    if len(sys.argv) != 2 or sys.argv[1] not in STRETCHES:
        print("usage: prove_long_quotients.py short|long", file=sys.stderr)
        return 2
    cuts = [(f".L{name}_compare", f".L{name}_digit", "cp", "r26") for name in ("short", "exact", "long")]
    tried = f".L{sys.argv[1]}_invert"
    others = [label for label, *_ in STRETCHES[sys.argv[1]]() if label != tried]
    failed = False
    for machine, labels in ((Arrays, [tried]), (Divisors, others)):
        program = Program([*short_stretches(), *long_stretches()], machine,
                          sources=("divide_q32_32", "long_division_table"), cuts=cuts)
        check_table(program)
        failed |= program.run(EVERY, NEEDLESS, labels)
    return failed


if __name__ == "__main__":
    sys.exit(main())
