#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Proves the largest error of integer powers in Q16.16 and Q8.8 for all pairs of operands from the machine code that is
measured.

usage: prove_integer_powers.py FOLDER    the folder of the device programs

    power           |x|^|n| or its reciprocal with the right sign, saturated, and the defined results if x or n is 0    by bits
    short_power     x as mantissa and exponent; a square for each digit of n, and a product with x for each 1, while
                    the power is in range; the reciprocal, and the rounding                                             by bits
        product     the 48 upper bits of a product, less LOSS of it, for the squares and the others              by linear forms
    power_in_ulps   the same for n >= 2^13, with a mantissa of 64 bits                                                  by bits
    multiply_by     there, the product of two mantissas from two of fixedpoint_multiply_q32_32                          by bits
    of libgcc       sums and shifts of 64 bits                                                                          by bits

fixedpoint/prove_products proves the product of Q32.32, fixedpoint/prove_quotients_q32_32 the quotient.

Relative errors add up: x^n counts that of a product n - 1 times, since a square doubles the errors so far. A power that
leaves the range stays outside of it, as the powers of a number only grow or only fall; its exponent, which a square at most
doubles, shows on which side.

The products of 64 bits require that the leading bits are set. That could fail only for a power next to a power of two, from
above: `far_from_powers_of_two` looks at the numbers closest to each root of a power of two, and shows that only the powers of
two themselves come that close, which are exact. Then instructions are left out in turn, and each time the proof must fail; for
compiled code, it may succeed without a third of them.
"""
import sys
from fractions import Fraction
from functools import partial
from pathlib import Path

import numpy
import z3
from mpmath import mp, mpf

from calling import A64, B64, FRAME, Bits, shown, sum_of
from form import known
from framed import SHIFTS, STACK, Framed, constant, shift_of
from machine_code import CALL_SAVED, Program, demand
from stretches import Linear, equal

SHORT, DIVIDE, PRODUCT = "fixedpoint_short_power", "fixedpoint_divide_q32_32", "fixedpoint_multiply_q32_32"
MULTIPLY = "_ZN10fixedpoint8portable11multiply_byINS_6kernel12PowerSteps64EyEEvRNS0_13FloatingPowerIT0_EERKS6_"
LONG = ("_ZN10fixedpoint8portable13power_in_ulpsIlLi{}ENS_6kernel12PowerSteps64E{}EENS_9IntegerOfIXsrNS_9RawLimitsIT_EE5widthEE8"
        "UnsignedES9_T2_b")
A32 = (22, 4)
FROM_LONG = 1 << 13  # the first exponent that is not short
ALL = z3.BitVecVal((1 << 32) - 1, 32)
EVERY = 50


class Format:
    """The registers of a format's functions: x, n, and for long powers the place of n and the register of `reciprocal`; and
    there in the loop those of n and of the digits that are left."""

    def __init__(self, width, fraction, bound, x, n, argument, reciprocal, count, digits, first, code):
        self.width, self.fraction, self.bound, self.x, self.n, self.argument = width, fraction, bound, x, n, argument
        self.reciprocal, self.count, self.digits = reciprocal, count, digits
        self.saved = (*range(first, 18), 28, 29)
        self.name, self.long = f"q{width - fraction}_{fraction}", LONG.format(fraction, code)
        self.bits = 8 * n[1]


FORMATS = (Format(32, 16, 0.635, (22, 4), (18, 4), (18, 4), 16, (4, 4), 15, 4, "m"),
           Format(16, 8, 0.50001, (24, 2), (22, 2), (20, 2), 18, (14, 2), 13, 6, "j"))


# The result


def power(of, m):
    x, n = m.number(*of.x), m.number(*of.n)
    m.flags["C"] = z3.Bool("carry")

    def check(m, _):
        result = m.number(26 - of.width // 8, of.width // 8)
        reciprocal, count = z3.If(n < 0, z3.BitVecVal(1, 8), z3.BitVecVal(0, 8)), z3.If(n < 0, -n, n)
        wide = z3.SignExt(32 - of.width, x) if of.width < 32 else x
        magnitude = z3.If(wide < 0, -wide, wide)
        if m.calls:
            (name, given, ulps), = m.calls
            shown(m, n != 0, x != 0, given[0] == magnitude)
            if name == SHORT:
                shown(m, z3.ULT(count, FROM_LONG), given[1] == z3.Extract(15, 0, count), given[2] == 32 - of.fraction,
                      given[3] == reciprocal)
            else:
                demand(name == of.long)
                shown(m, z3.UGE(count, FROM_LONG), given[1] == count, given[2] == reciprocal)
        else:
            ulps = z3.If(n == 0, z3.BitVecVal(1 << of.fraction, 32), z3.If(n < 0, ALL, z3.BitVecVal(0, 32)))
            shown(m, z3.Or(n == 0, x == 0))
        for negative in (False, True):
            largest = z3.BitVecVal((1 << of.width - 1) - 1 + negative, 32)
            limited = z3.Extract(of.width - 1, 0, z3.If(z3.UGT(ulps, largest), largest, ulps))
            shown(m, z3.Implies(z3.And(x < 0, z3.Extract(0, 0, n) == 1) == negative,
                                result == (-limited if negative else limited)))
    return check


# Powers with long exponents: a mantissa of 64 bits


LOCALS = STACK - 20
POWER, FACTOR = LOCALS + 11, LOCALS + 1
NORMALISE, COUNT, DIGIT, END = ".Lnormalise_x", ".Lcount", ".Ldigit_of_n", ".Lend_of_n"


def multiplied(m):
    """The pointers and the numbers there, and the product."""
    pointers = m.word(24), m.word(22)
    numbers = [m.loaded(pointer, 10) for pointer in pointers]
    m.store(pointers[0], z3.BitVec(f"product.{len(m.calls)}", 80))
    return [*pointers, *numbers]


class Long(Framed):
    effects = {MULTIPLY: multiplied}


def in_frame(of, m):
    """n, and whether it is the reciprocal; on the stack are the power and x."""
    m.place(28, *constant(LOCALS, 2))
    numbers = z3.BitVecs("power factor", 80)
    for address, number in zip((POWER, FACTOR), numbers):
        m.store(address, number)
    kept = [*range(of.count[0], sum(of.count)), 17, 28, 29]
    before = {n: m.registers[n] for n in kept}

    def same(m, *addresses):
        shown(m, *(m.registers[n] == before[n] for n in kept))
        for address, number in zip((POWER, FACTOR), numbers):
            if address in addresses:
                shown(m, m.loaded(address, 10) == number)
    return m.number(*of.count), numbers, same


def long_begun(of, m):
    x, n, reciprocal = m.number(*A32), m.number(*of.argument), m.registers[of.reciprocal]

    def check(m, _):
        demand(m.word(28) == LOCALS)
        shown(m, m.number(*A32) == x, m.number(18, 2) == 32 - of.fraction, m.number(*of.count) == n,
              m.registers[17] == reciprocal)
    return check


def long_normalised(of, m):
    m.place(28, *constant(LOCALS, 2))
    x, exponent, n, reciprocal = m.number(*A32), m.number(18, 2), m.number(*of.count), m.registers[17]

    def check(m, end):
        demand(m.word(28) == LOCALS)
        shown(m, m.number(*of.count) == n, m.registers[17] == reciprocal)
        if end == NORMALISE:
            shown(m, x >= 0, m.number(*A32) == x << 1, m.number(18, 2) == exponent - 1)
        else:
            shown(m, x < 0, m.number(24, of.n[1]) == n, m.registers[of.digits] == 0,
                  *(m.loaded(address, 10) == z3.Concat(exponent, x, z3.BitVecVal(0, 32)) for address in (POWER, FACTOR)))
    return check


def counted(of, m):
    _, _, same = in_frame(of, m)
    rest, digits = m.number(24, of.n[1]), m.registers[of.digits]

    def check(m, end):
        same(m, POWER, FACTOR)
        if end == COUNT:
            shown(m, rest != 0, m.number(24, of.n[1]) == z3.LShR(rest, 1), m.registers[of.digits] == digits + 1)
        else:
            shown(m, rest == 0, m.registers[of.digits] == digits)
    return check


def digit(of, m, left):
    n, (power, factor), same = in_frame(of, m)
    m.registers[of.digits] = z3.BitVecVal(left, 8)
    exponent = z3.Extract(79, 64, power)
    inside = z3.And(exponent < 70, exponent > -70)

    def check(m, end):
        same(m, FACTOR)
        if end == END:
            demand(not m.calls)
            same(m, POWER)
            shown(m, z3.BoolVal(left == 1) if left == 1 else z3.Not(inside))
            return
        demand(left > 1)
        shown(m, inside, m.registers[of.digits] == left - 1, (z3.Extract(left - 2, left - 2, n) == 1) == (len(m.calls) == 2))
        (_, square, _), *others = m.calls
        demand(square[:2] == [POWER, POWER])
        shown(m, square[2] == power, square[3] == power)
        for _, product, _ in others:
            demand(product[:2] == [POWER, FACTOR])
            shown(m, product[2] == z3.BitVec("product.0", 80), product[3] == factor)
        shown(m, m.loaded(POWER, 10) == z3.BitVec(f"product.{len(others)}", 80))
    return check


def long_rounded(of, m):
    _, (power, _), _ = in_frame(of, m)
    mantissa, exponent, reciprocal = z3.Extract(63, 0, power), z3.Extract(79, 64, power), m.registers[17]
    m.holds += [mantissa < 0, exponent >= -200, exponent <= 200, z3.ULE(reciprocal, 1)]

    def check(m, _):
        if m.calls:
            (name, (one, divisor), quotient), = m.calls
            demand(name == DIVIDE)
            shown(m, reciprocal == 1, one == 1 << 62, divisor == z3.LShR(mantissa, 24))
            word, surplus = quotient << 8, exponent + 62 - of.fraction
        else:
            shown(m, reciprocal == 0)
            word, surplus = z3.LShR(mantissa, 1), 63 - exponent - of.fraction
        wide = z3.SignExt(48, surplus)
        nearest = z3.LShR(word + (1 << wide - 1), wide)
        shown(m, m.number(*A32) == z3.If(surplus < 31, ALL, z3.If(surplus >= 64, z3.BitVecVal(0, 32), z3.If(
            z3.UGT(nearest, (1 << 32) - 1), ALL, z3.Extract(31, 0, nearest)))))
    return check


def long_product(m, square):
    a, b = z3.BitVec("a", 80), z3.BitVec("b", 80)
    b = a if square else b
    pointers = 0x300, 0x300 if square else 0x340
    for pointer, number in zip(pointers, (a, b)):
        m.store(pointer, number)
    m.place(24, *constant(pointers[0], 2))
    m.place(22, *constant(pointers[1], 2))

    def check(m, _):
        (one, (a0, lower), first), (other, (a1, upper), second) = m.calls
        demand(one == other == PRODUCT)
        part = z3.Extract(63, 0, b)
        shown(m, a0 == z3.Extract(63, 0, a), a1 == a0, lower == part & (1 << 32) - 1, upper == z3.LShR(part, 32))
        low = first + (lower << 32)
        high = second + (upper << 32) + z3.LShR(low, 32)
        short = z3.ULT(high, 1 << 63)
        exponent = z3.Extract(79, 64, a) + z3.Extract(79, 64, b)
        shown(m, m.loaded(pointers[0], 10) == z3.If(
            short, z3.Concat(exponent - 1, (high << 1) + (z3.LShR(low, 31) & 1)), z3.Concat(exponent, high)))
        if not square:
            shown(m, m.loaded(pointers[1], 10) == b)
    return check


# Powers with short exponents: a mantissa of 48 bits in r25..r20


SQUARE, TIMES, SHIFT, SHIFTED = ".Lsquare", ".Lproduct", ".Lnormalise", ".Lend"
BEGUN, DIGITS, NEXT, DONE, ROUND = ".Lbegun", ".Ldigits", ".Ldigit", ".Ldone", ".Lfound"
# What the kernel pushes: the last two are its operands.
PUSHED = (*range(8, 18), 28, 29)
PUSHED_ALL = (*PUSHED, 18, 16)
A, B = range(20, 26), range(12, 18)
# The byte columns of a product below the fifth, and that one.
LOST = sum((column + 1) * 255**2 * 256**column for column in range(4)) + 255 * 2**32
# Of a product, relative to it.
LOSS = Fraction(2**47 + LOST, 2**94)


class Products(Linear):
    """Returns with r1 as it is."""

    def is_zero(self, register):
        return register == 1 or super().is_zero(register)


def mantissas(is_square, m):
    m.zero(27)
    m.hold(128, m.registers[25])
    if not is_square:
        m.hold(128, m.registers[17])
    a, b = m.number(A), m.number(A if is_square else B)
    top = m.registers[25], m.registers[25 if is_square else 17]
    product, exponent = m.times(a, b), m.registers[10]
    m.hold(1 << 14, m.times(*top))

    def check(m, _):
        mantissa = m.number(A)
        moved = m.constant(m.registers[10] - exponent * (2 if is_square else 1), 256)
        unit = 1 << 48 - (moved == 255)
        demand(moved in (0, 255))
        m.show((0, product - mantissa * unit, unit + LOST), (128, m.registers[25], 255), *((0, m.registers[n], 255) for n in A),
               equal(m.registers[27], known(0)))
    return check


class Steps(Bits):
    """Calls the products, which take r27 as zero, and the quotient."""

    def __init__(self, program):
        super().__init__(program)
        self.saved[18], self.calls = self.registers[18], []
        self.products = {program.labels[name]: name for name in (SQUARE, TIMES)}

    def copy(self):
        other = super().copy()
        other.calls = self.calls[:]
        return other

    def step(self, address):
        mnemonic, _, target, following = self.program.code[address]
        if mnemonic in ("call", "rcall"):
            if target in self.products:
                name = self.products[target]
                demand(self.is_zero(27))
                given = [self.number(20, 6), self.registers[10], *([self.number(12, 6)] if name == TIMES else [])]
                kept = (*range(2, 10), 11, *range(27, 32))
            else:
                demand(target == self.program.labels[DIVIDE] and self.is_zero(1))
                name, given, kept = DIVIDE, [self.number(*A64), self.number(*B64)], (1, *CALL_SAVED)
            unique = f"{name}.{len(self.calls)}"
            self.registers = {n: self.registers[n] if n in kept else z3.BitVec(f"{unique}.r{n}", 8) for n in range(32)}
            self.flags = {"T": self.flags["T"]} if "T" in self.flags else {}
            result = self.number(*A64) if name == DIVIDE else z3.Concat(self.registers[10], self.number(20, 6))
            self.calls.append((name, given, result))
            return [(following, self)]
        return super().step(address)


def short_begun(m):
    a, n, exponent = m.number(*A32), m.number(20, 2), m.registers[18]
    m.holds += [a != 0, exponent >= 0, exponent <= 32]

    def check(m, _):
        x = m.number(*A32)
        moved = [z3.And(x == a << k, z3.LShR(x, k) == a, m.registers[18] == exponent - k) for k in range(32)]
        shown(m, z3.Or(*moved), x < 0, m.number(20, 2) == 0, m.registers[27] == 0, m.number(30, 2) == n)
    return check


def short_digits(m):
    n, x, exponent = m.number(30, 2), m.number(*A32), m.registers[18]
    m.registers[20] = m.registers[21] = m.registers[27] = z3.BitVecVal(0, 8)
    m.holds += [n != 0, z3.ULT(n, 1 << 15)]

    def check(m, _):
        # For the number k of digits after the first one: these, and then a 1.
        rest = [z3.And(z3.UGE(n, 1 << k), z3.ULT(n, 2 << k), m.number(30, 2) == (n - (1 << k) << 16 - k) + (1 << 15 - k))
                for k in range(15)]
        kept = z3.Concat(*(m.registers[i] for i in (29, 28, 9, 8)))
        shown(m, z3.Or(*rest), m.number(20, 6) == z3.Concat(x, z3.BitVecVal(0, 16)), kept == x, m.registers[10] == exponent,
              m.registers[11] == exponent, m.registers[27] == 0)
    return check


def short_digit(m, left):
    m.registers[27] = z3.BitVecVal(0, 8)
    rest = z3.BitVec("rest", left) if left else None
    word = z3.Concat(*([rest] if left else []), z3.BitVecVal(1, 1), z3.BitVecVal(0, 15 - left))
    m.registers[30], m.registers[31] = z3.Extract(7, 0, word), z3.Extract(15, 8, word)
    kept = [z3.Concat(*(m.registers[i] for i in (29, 28, 9, 8))), m.registers[11]]
    power, exponent = m.number(20, 6), m.registers[10]
    m.holds += [exponent >= -93, exponent <= 93, kept[1] >= -31, kept[1] <= 32]

    def check(m, end):
        def inside(exponent):
            return z3.And(exponent >= -46, exponent <= 46)
        shown(m, *(now == before for now, before in zip(
            [z3.Concat(*(m.registers[i] for i in (29, 28, 9, 8))), m.registers[11]], kept)))
        names = [name for name, _, _ in m.calls]
        results = [result for _, _, result in m.calls]
        for (name, given, _), before in zip(m.calls, [z3.Concat(exponent, power), *results]):
            wide, was = z3.Extract(47, 0, before), z3.Extract(55, 48, before)
            if name == SQUARE:
                shown(m, given[0] == wide, given[1] == was, inside(was))
            else:
                shown(m, given[0] == wide, given[1] == was + kept[1], inside(was),
                      given[2] == z3.Concat(kept[0], z3.BitVecVal(0, 16)))
        last = results[-1] if results else z3.Concat(exponent, power)
        shown(m, m.number(20, 6) == z3.Extract(47, 0, last), m.registers[10] == z3.Extract(55, 48, last))
        set_digit = z3.Extract(left - 1, left - 1, rest) == 1 if left else None
        if end == NEXT:
            demand(left > 0 and names in ([SQUARE], [SQUARE, TIMES]))
            after = z3.Concat(*([z3.Extract(left - 2, 0, rest)] if left > 1 else []),
                              z3.BitVecVal(1, 1), z3.BitVecVal(0, 16 - left))
            shown(m, m.registers[27] == 0, m.number(30, 2) == after, set_digit == (len(names) == 2))
        elif names:
            # The power is out of range, and to be multiplied by x.
            demand(names == [SQUARE])
            shown(m, set_digit, z3.Not(inside(m.registers[10])))
        elif left:
            shown(m, z3.Not(inside(exponent)))
    return check


def short_done(m):
    mantissa, exponent, unit, reciprocal = m.number(20, 6), m.registers[10], m.saved[18], m.saved[16]
    m.registers[1] = z3.BitVec("r1", 8)
    m.holds += [exponent >= -93, exponent <= 93, unit >= 0, unit <= 32, z3.Extract(47, 47, mantissa) == 1]

    def check(m, _):
        if m.calls:
            (name, (one, divisor), quotient), = m.calls
            m.holds += [z3.UGE(quotient, 1 << 38), z3.ULE(quotient, 1 << 39)]
            shown(m, reciprocal != 0, one == 1 << 62, divisor == z3.Concat(z3.BitVecVal(0, 8), mantissa, z3.BitVecVal(0, 8)))
            digits = z3.If(quotient == 1 << 39, ALL, z3.Extract(38, 7, quotient))
            shown(m, m.registers[18] == unit - 1 + exponent)
        else:
            shown(m, reciprocal == 0, m.registers[18] == unit - exponent)
            digits = z3.Extract(47, 16, mantissa)
        shown(m, m.number(*A32) == digits, m.registers[1] == 0)
    return check


def short_rounded(m, surplus):
    m.registers[18] = z3.BitVecVal(surplus, 8)
    digits = m.number(*A32)

    def check(m, _):
        half = z3.LShR(digits, surplus - 1) if 0 < surplus < 33 else None
        wanted = (ALL if surplus < 0 else digits if surplus == 0 else z3.BitVecVal(0, 32) if surplus > 32 else
                  z3.Extract(31, 0, z3.LShR(z3.ZeroExt(1, half) + 1, 1)))
        shown(m, m.number(*A32) == wanted)
    return check


ANY = ((),)
CALLED = {SHORT: ([A32, (20, 2), (18, 1), (16, 1)], 4), PRODUCT: ([A64, B64], 8), DIVIDE: ([A64, B64], 8), MULTIPLY: ([], 8)}


def compiled(of):
    pushed = of.saved
    return [(f"power_{of.name}_default", partial(power, of), (None,), (), ANY, (None,)),
            (of.long, partial(long_begun, of), (NORMALISE,), (), ANY, (None,)),
            (NORMALISE, partial(long_normalised, of), (NORMALISE, COUNT), pushed, ANY, (None,)),
            (COUNT, partial(counted, of), (COUNT, DIGIT), pushed, ANY, (None,)),
            (DIGIT, partial(digit, of), (DIGIT, END), pushed, [(left,) for left in range(1, of.bits + 1)], (None,)),
            (END, partial(long_rounded, of), (None,), pushed, ANY, (None,)),
            (MULTIPLY, long_product, (None,), (), ((False,), (True,)), (None,)),
            *((name, partial(sum_of, name), (None,), (), ANY, (None,)) for name in ("__adddi3",)),
            *((name, partial(shift_of, name), (None,), (), [(count,) for count in range(64)], (None,)) for name in SHIFTS)]


# The errors


# Of a product of 64 bits, relative to it: twice a half for the product with the upper word, and 1 for what is cut.
LOSS_64 = Fraction(2, 2**63) + Fraction(1, 2**90)
BEYOND = 71  # binary digits: more than a power has before a product of 64 bits
NEAR = 2.0**-48


def longest(fraction):
    """The largest exponent of a power, other than of 1, that is within 2^-BEYOND to 2^BEYOND."""
    return int(BEYOND / mp.log(1 + mpf(2)**-fraction, 2)) + 1


def far_from_powers_of_two():
    """No power x^m of 2 <= m <= `longest` is closer to 2^k than its error, unless x is a power of two. x is that of Q16.16, which
    has the numbers of Q8.8."""
    unit, near = 1 << 16, 0
    for k in (*range(-BEYOND, 0), *range(1, BEYOND + 1)):
        m = numpy.arange(2, int(abs(k) / mp.log(1 + mpf(1) / unit, 2)) + 3)
        root = numpy.exp2(16 + k / m)
        x = numpy.rint(root)
        # Errors of the root are up to 2^-50 of it.
        for i in numpy.flatnonzero((abs(root - x) < NEAR * root) & (x >= 1) & (x <= 2.0**31)):
            number, exponent = int(x[i]), int(m[i])
            if number & number - 1:
                near += 1
                demand(abs(exponent * mp.log(mpf(number) / unit, 2) - k) > (2 * exponent + 16) * mpf(2)**-62)
    return near


def bound(of):
    """The error of a power, in ulp."""
    short = (FROM_LONG - 2) * LOSS
    # The quotient has at least 39 bits.
    short = short / (1 - short) * (1 + Fraction(1, 2**39)) + Fraction(1, 2**39)
    long = longest(of.fraction) * LOSS_64
    # The divisor is cut to 40 bits.
    long = long / (1 - 2 * long) * Fraction(1001, 1000) + Fraction(1001, 1000) / 2**39
    return float(Fraction(1, 2) + max(short, long) * (2**(of.width - 1) + 1))


SHORT_STRETCHES = [
    (SHORT, short_begun, (BEGUN,), (), ANY, (None,)),
    (BEGUN, short_digits, (NEXT,), PUSHED_ALL, ANY, (None,)),
    (NEXT, short_digit, (NEXT, DONE), PUSHED_ALL, [(left,) for left in range(15)], (None,)),
    (DONE, short_done, (ROUND,), PUSHED_ALL, ANY, (None,)),
    (ROUND, short_rounded, (None,), PUSHED, [(surplus,) for surplus in range(-128, 128)], (None,)),
    (SQUARE, partial(mantissas, True), (SHIFTED,), PUSHED, ANY, (None,)),
    (TIMES, partial(mantissas, False), (SHIFTED,), PUSHED, ANY, (None,)),
    (SHIFTED, None, (), PUSHED)]
SHORT_CUTS = ((BEGUN, SHORT, "mov", "r10"), (ROUND, DONE, "and", "r18"), (SHIFTED, SHIFT, "ret", ""))


def main():
    folder, failed, count, needless = Path(sys.argv[1]), False, 0, []
    mp.prec = 200
    for machine, every, labels in ((Steps, 16, (SHORT, BEGUN, NEXT, DONE, ROUND)), (Products, 16, (SQUARE, TIMES))):
        program = Program(SHORT_STRETCHES, machine, cuts=SHORT_CUTS,
                          sources=("short_power", "divide_q32_32", "long_division_table"))
        failed |= program.run(every, ("ret", "rjmp"), labels)
    for of in FORMATS:
        cuts = ((NORMALISE, of.long, "mov", "r21"), (COUNT, NORMALISE, "sbiw", "r24"), (DIGIT, COUNT, "dec", f"r{of.digits}"),
                (END, DIGIT, "and", "r17"))
        program = Program(compiled(of), partial(Long, CALLED | {of.long: ([A32, of.argument, (of.reciprocal, 1)], 4)}),
                          elf=folder / f"{of.name}_auxiliary.elf", cuts=cuts)
        for stretch in program.stretches:
            visited = program.prove(*stretch)
            print(f"{stretch[0]}: proven", flush=True)
            count += len(visited)
            needless += program.survivors(stretch, visited, EVERY, ("ret", "rjmp", *FRAME))
    # Compiled code contains instructions that change nothing.
    print(f"of {count} compiled instructions one in {EVERY} was left out, without effect {needless}")
    failed |= 3 * EVERY * len(needless) > count
    print(f"{far_from_powers_of_two()} powers are close to a power of two, none too close")
    for of in FORMATS:
        found = bound(of)
        print(f"power_{of.name}_default: errs by less than {found:.6f} ulp, of at most {of.bound}")
        failed |= found >= of.bound
    return failed


if __name__ == "__main__":
    sys.exit(main())
