#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Proves for all operands, from its instructions, that fixedpoint_multiply_q16_16_saturating returns the product, rounded to
nearest and saturated.

usage: prove_saturating_products.py

    entry        both highest bytes are 0 or -1; or one operand has three bytes and is a;
                 or both are so large that the product overflows, and r27 has its sign                  by bits
    both, small  R = floor(a b / 2^16 + 1/2) in five bytes, in two's complement                          by linear forms
    fits, saturate  R, saturated to four bytes                                                           by bits

Then instructions are left out in turn, and each time the proof must fail.
"""

import sys
from itertools import product

import z3

from bits import Bits
from form import Form, known
from machine_code import Program, demand
from stretches import Signed, equal, give_signs, zeros

NAME = "fixedpoint_multiply_q16_16_saturating"
A, B = 22, 18
BOTH, SMALL, FITS_BOTH, FITS_SMALL, SATURATE = ".Lboth", ".La_small", ".Lfits_both", ".Lfits_small", ".Lsaturate"
# The registers of R, and the largest |R| there.
PLACES = {FITS_BOTH: ((22, 23, 24, 25, 0), 1 << 32), FITS_SMALL: ((30, 31, 25, 26, 27), 1 << 38)}


def entry(m):
    a, b = m.number(A, 4), m.number(B, 4)

    def below(x, bits):
        return z3.And(x >= -(1 << bits), x < 1 << bits)

    def check(m, end):
        demand("T" not in m.flags and m.is_zero(1))
        if end == BOTH:
            holds = z3.And(m.number(A, 4) == a, m.number(B, 4) == b, below(a, 24), below(b, 24))
        elif end == SMALL:
            short, other = z3.SignExt(8, m.number(A, 3)), m.number(B, 4)
            holds = z3.Or(z3.And(short == a, other == b), z3.And(short == b, other == a))
        else:
            # 2^24 2^23 / 2^16 = 2^31.
            large = [z3.And(z3.Not(below(x, 24)), z3.Not(below(y, 23))) for x, y in ((a, b), (b, a))]
            holds = z3.And(z3.Or(*large), (m.registers[27] < 0) == ((a < 0) != (b < 0)))
        demand(m.impossible(z3.Not(holds)))
    return check


def shows_product(a, b):
    """A check that R is in the expected registers."""
    def check(m, end):
        demand(m.transfer is None)
        place, _ = PLACES[end]
        modulus = 1 << 8 * len(place) + 16
        rest = m.times(a, b) + known(1 << 15) - m.number(place) * (1 << 16)
        rest = Form({name: (factor + modulus // 2) % modulus - modulus // 2 for name, factor in rest.items()
                     if factor % modulus})
        m.show((0, rest, (1 << 16) - 1), *zeros(m, (1,)))
        if end == FITS_BOTH:
            m.show(equal(m.registers[26], m.registers[25]))
    return check


def both(m, *negative):
    m.zero(1)
    numbers = []
    for low, is_negative in zip((A, B), negative):
        m.registers[low + 3] = known(255 * is_negative)
        numbers.append(m.number(range(low, low + 3)) - known(is_negative << 24))
    return shows_product(*numbers)


def small(m, *negative):
    m.zero(1)
    give_signs(m, (A + 2, B + 3), negative)
    a, b = m.number(range(A, A + 3)), m.number(range(B, B + 4))
    return shows_product(a - known(negative[0] << 24), b - known(negative[1] << 32))


def fits(label, m):
    place, largest = PLACES[label]
    if label == FITS_BOTH:
        m.registers[26] = m.registers[25]
    r = z3.Concat(*(m.registers[register] for register in reversed(place)))
    m.holds += [r >= -largest, r <= largest]
    low, high = (z3.BitVecVal(number, 40) for number in (-1 << 31, (1 << 31) - 1))
    saturated = z3.Extract(31, 0, z3.If(r < low, low, z3.If(r > high, high, r)))

    def check(m, _):
        demand(m.impossible(m.number(A, 4) != saturated))
    return check


def saturate(m):
    negative = m.registers[27] < 0

    def check(m, _):
        demand(m.impossible(m.number(A, 4) != z3.If(negative, z3.BitVecVal(1 << 31, 32), z3.BitVecVal((1 << 31) - 1, 32))))
    return check


SIGNS = list(product((False, True), repeat=2))
ANY = ((),)
STRETCHES = [(NAME, entry, (BOTH, SMALL, SATURATE), (), ANY, (None,)),
             (BOTH, both, (FITS_BOTH,), (), SIGNS, (None,)),
             (SMALL, small, (FITS_SMALL,), (), SIGNS, (None,)),
             (FITS_BOTH, lambda m: fits(FITS_BOTH, m), (None,), (), ANY, (None,)),
             (FITS_SMALL, lambda m: fits(FITS_SMALL, m), (None,), (), ANY, (None,)),
             (SATURATE, saturate, (None,), (), ANY, (None,))]
CUTS = ((BOTH, NAME, "eor", "r27"), (".Lupper", BOTH, "eor", "r26"),
        (FITS_BOTH, ".Lupper", "add", "r26"), (FITS_SMALL, SMALL, "mov", "r0"))


def main():
    failed = False
    for machine, labels in ((Bits, (NAME, SATURATE)), (Signed, (BOTH, SMALL))):
        program = Program(STRETCHES, machine, cuts=CUTS, sources=("multiply_q16_16_saturating",))
        failed |= program.run(1, ("ret", "rjmp"), labels)
    # The path to the return passes the saturation.
    program = Program([each for each in STRETCHES if each[0] != SATURATE], Bits, cuts=CUTS,
                      sources=("multiply_q16_16_saturating",))
    return failed | program.run(1, ("ret", "rjmp"), (FITS_BOTH, FITS_SMALL))


if __name__ == "__main__":
    sys.exit(main())
