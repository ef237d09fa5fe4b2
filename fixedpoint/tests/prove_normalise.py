#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Proves error bounds of fixedpoint_normalise3_q8_8 and _q16_16 for all vectors, from their
instructions and tables.

usage: prove_normalise.py

The statements about the registers at each label; v is the vector, at address 0:

    bits, bytes      the magnitudes, that of the smallest number 1 less, and the signs         by bits
    scaled           X = these 2^k, cut to 24 bits in Q16.16, the largest in its upper half    by bits
    root             s = the upper digits of |X|^2 or 4 |X|^2, and which                       by linear forms
    component        R, nearly ONE / |X|                                                       by running it for every s
    sign             floor((x R - what is dropped) / UNIT + 1/2), x a component of X           by linear forms
    next, return     that with its sign, stored                                                by bits

|X| is known from s except for the dropped part; R |X| / ONE is the length of the result. A
magnitude that is 1 too small, or truncated to 23 bits, rotates the vector: unit vectors of a and b
differ by at most |a - b| / sqrt(|a| |b|). Then instructions are left out in turn, and each time the
proof must fail.
"""

import sys
from functools import partial

import numpy
import z3

from arrays import Arrays
from bits import Bits, joined, same
from form import known
from machine_code import Program, demand
from stretches import Bounded, equal

BOUNDS = {"q8_8": 0.66, "q16_16": 0.77}  # ulp
SHORT, LONG = "fixedpoint_normalise3_q8_8", "fixedpoint_normalise3_q16_16"
# The components of each: before they are scaled and after, the lowest byte first.
SHORT_VECTOR = ((18, 19), (20, 21), (22, 23))
WIDE_VECTOR, LONG_VECTOR = ((18, 5, 6, 7), (19, 9, 10, 11), (24, 25, 26, 27)), ((5, 6, 7), (9, 10, 11), (12, 13, 14))
SHORT_SIGNS, LONG_SIGNS, POINTER = 27, 23, (28, 29)
SHORT_SUM, SHORT_ROOT, LONG_SUM, LONG_ROOT = (24, 25, 26), (24, 26), (18, 19, 20, 21), (18, 19, 20)
SHORT_SAVED, LONG_SAVED = (28, 29), (5, 6, 7, *range(9, 15), 28, 29)
# Of |X|^2 what the sums of squares drop, and of x R what the product drops.
SHORT_DROPPED, LONG_DROPPED = 3 * 255, 3 * 255 * 255 * 513
SHORT_LOST, LONG_LOST = 255 * 255, 255 * 255 * 513
LIMIT = 2**29 + 2**20  # of x R in Q8.8
CHUNK = 1 << 18
# Of a length of 1: magnitudes of 2^15 are 1 less; those of 2^31, too, and all lose less than 2^8 of 2^30.
SHORT_TURN, LONG_TURN = 1 / (2**15 - 1), 1 / (2**31 - 1) + 3**.5 * 2**8 / (2**30 - 2**9)


class Stores(Bits):
    returns_in_memory = True


def entry(vector, signs, pattern, m):
    size = len(vector[0])
    m.memory = [z3.BitVec(f"v{i}", 8) for i in range(3 * size)]
    m.registers[24] = m.registers[25] = z3.BitVecVal(0, 8)
    numbers = [z3.Concat(*reversed(m.memory[i:i + size])) for i in range(0, 3 * size, size)]
    unit = joined(m, (22, 23))

    def check(m, _):
        least = 1 << 8 * size - 1
        magnitudes = [z3.If(v < 0, z3.If(v == least, least - 1, -v), v) for v in numbers]
        expected = z3.Concat(*(z3.Extract(8 * size - 1, 8 * size - 1, v) for v in numbers))
        demand(m.impossible(z3.Or(m.registers[signs] != pattern(expected), joined(m, POINTER) != unit, m.registers[1] != 0,
                                  *(joined(m, place) != v for place, v in zip(vector, magnitudes)))))
    return check


def scaled(before, after, signs, m):
    numbers, bits = [joined(m, place) for place in before], 8 * len(before[0])
    m.holds += [v >= 0 for v in numbers]
    unchanged = same(m, (signs, *POINTER))

    def check(m, end):
        unchanged(m)
        if end == ".Lbits":
            demand(m.impossible(z3.Or(*(z3.Or(z3.UGE(v, 256), joined(m, place) != v << 7) for v, place in zip(numbers, before)))))
            return
        if end != ".Lscaled":
            # Of a zero vector, every component stays zero.
            demand(m.impossible(z3.Or(m.registers[1] != 0, *(v != 0 for v in numbers),
                                      *(joined(m, place) != 0 for place in before))))
            return
        low = bits - 8 * len(after[0])
        found = [joined(m, place) for place in after]
        shifted = [z3.And(*(z3.And(z3.LShR(v << k, k) == v, z3.Extract(bits - 1, low, v << k) == x)
                            for v, x in zip(numbers, found))) for k in range(bits)]
        upper = found[0] | found[1] | found[2]
        demand(m.impossible(z3.Not(z3.And(z3.Or(*shifted), z3.LShR(upper, 8 * len(after[0]) - 2) == 1))))
    return check


def components(m, vector, largest):
    """The numbers; their highest bytes are below 128, and that of the largest one is at least
    64."""
    for place in vector:
        m.registers[place[-1]] = m.variable("high", 127)
    high = m.registers[vector[largest][-1]]
    m.hold(64 * 64, m.times(high, high))
    return [m.number(place) for place in vector]


def short_squares(m, largest):
    total = known(0)
    for x in components(m, SHORT_VECTOR, largest):
        total += m.times(x, x)
    unchanged = same(m, (*sum(SHORT_VECTOR, ()), SHORT_SIGNS, *POINTER))

    def check(m, _):
        unchanged(m)
        scale = 4 if m.transfer else 1
        m.possible([])
        m.show((0, total * scale - m.number(SHORT_SUM) * 256, SHORT_DROPPED * scale), (1 << 22, m.number(SHORT_SUM), None))
    return check


def long_squares(m, largest):
    components(m, LONG_VECTOR, largest)
    part = known(0)
    for low, middle, high in (map(m.registers.get, place) for place in LONG_VECTOR):
        part += m.times(high * (1 << 16) + middle * (1 << 9) + low * 2, high) + m.times(middle, middle)
    unchanged = same(m, (*sum(LONG_VECTOR, ()), LONG_SIGNS, *POINTER))

    def check(m, _):
        unchanged(m)
        m.possible([])
        m.same(m.number(LONG_SUM), part * (1 if m.transfer else 4), 1 << 32)
        m.show((1 << 30, m.number(LONG_SUM), None), equal(m.registers[25], known(0)))
    return check


def bounded(number_format, product, low, high, one, lost, turn):
    """`product` is R |X| if |X|^2 or 4 |X|^2 is in `low`..`high`."""
    unit = {"q8_8": 2**8, "q16_16": 2**16}[number_format]
    longer, shorter = (product * numpy.sqrt(high) / one - 1).max(), (1 - product * numpy.sqrt(low) / one).max()
    bound = 0.5 + unit * (max(longer, shorter + lost / one) + turn) + 1e-6
    demand(bound < BOUNDS[number_format])


def short_root(m):
    m.given["sum"] = numpy.arange(1 << 14, 1 << 16)
    m.place(m.given["sum"], SHORT_SUM[1:])

    def check(m, _):
        demand(all(map(m.untouched, (*sum(SHORT_VECTOR, ()), SHORT_SIGNS))))
        found, scale = m.number(SHORT_ROOT), 4 if m.transfer else 1
        low = m.given["sum"] * 65536.0 / scale
        high = low + 65280 / scale + SHORT_DROPPED
        demand((found < 1 << 16).all() and (found * numpy.sqrt(high) < LIMIT - 1).all())
        bounded("q8_8", found, low, high, 2**29, SHORT_LOST, SHORT_TURN)
    return check


def long_root(m, first):
    m.given["sum"] = numpy.arange(first, first + CHUNK, m.program.stride)
    m.place(m.given["sum"], LONG_SUM[1:])
    m.registers[25] = 0

    def check(m, _):
        demand(all(map(m.untouched, (*sum(LONG_VECTOR, ()), LONG_SIGNS))))
        demand((m.number(LONG_ROOT) < 1 << 23).all())
        low = m.given["sum"] * 2.0**24
        bounded("q16_16", m.number(LONG_ROOT), low, low + 255 * 2**16 + 4 * LONG_DROPPED, 2**46, LONG_LOST, LONG_TURN)
    return check


def doubled(m):
    m.registers[LONG_ROOT[-1]] = m.variable("high", 127)
    root = m.number(LONG_ROOT)
    unchanged = same(m, (*sum(LONG_VECTOR, ()), LONG_SIGNS, *POINTER))

    def check(m, _):
        unchanged(m)
        m.possible([])
        m.same(m.number(LONG_ROOT), root * (1 if m.transfer else 2), 1 << 24)
    return check


def short_component(m):
    x, root = SHORT_VECTOR[0], SHORT_ROOT
    m.registers[x[1]] = m.variable("high", 127)
    product = m.times(m.number(x), m.number(root))
    m.hold(0, product, LIMIT)
    kept = product - m.times(m.registers[x[0]], m.registers[root[0]])
    unchanged = same(m, (*sum(SHORT_VECTOR[1:], ()), *root, SHORT_SIGNS, *POINTER))

    def check(m, _):
        unchanged(m)
        m.possible([])
        m.show((0, kept + known(1 << 20) - m.number((31, 30)) * (1 << 21), (1 << 21) - 1))
    return check


def long_component(i, m):
    low, middle, high = LONG_VECTOR[i]
    m.registers[high] = m.variable("high", 127)
    r0, r1, _ = (m.registers[register] for register in LONG_ROOT)
    low, middle = m.registers[low], m.registers[middle]
    kept = (m.times(m.number(LONG_VECTOR[i]), m.number(LONG_ROOT)) - m.times(middle, r0) * 256 -
            m.times(low, r1) * 256 - m.times(low, r0))
    unchanged = same(m, (*sum(LONG_VECTOR[i:], ()), *LONG_ROOT, LONG_SIGNS, *POINTER))

    def check(m, _):
        unchanged(m)
        m.possible([])
        m.show((0, kept + known(1 << 29) - m.number((24, 25, 26)) * (1 << 30), (1 << 30) - 1),
               equal(m.registers[27], known(0)))
    return check


def begin_sign(m):
    m.registers[1] = z3.BitVec("product", 8)
    for register in POINTER:
        m.registers[register] = z3.BitVec(f"unit{register}", 8)
    return joined(m, POINTER)


def stored(m, end, place, value, negative):
    """Checks that the value, or its negative, and nothing else has been stored from `place` on."""
    value = z3.If(negative, -value, value)
    wrong = [z3.Or(where != place + i, byte != z3.Extract(8 * i + 7, 8 * i, value)) for i, (where, byte) in enumerate(m.stored)]
    demand(8 * len(m.stored) == value.size() and m.impossible(z3.Or(*wrong)))
    demand(end is None or m.impossible(joined(m, POINTER) != place + len(wrong)))


def short_sign(m, passed):
    place, value, signs = begin_sign(m), joined(m, (31, 30)), m.registers[SHORT_SIGNS]
    m.holds.append(signs & (1 << passed + 5) - 1 == 1 << passed + 4)
    following = joined(m, sum(SHORT_VECTOR[1:], ()))
    unchanged = same(m, SHORT_ROOT)

    def check(m, end):
        demand((end is None) == (passed == 2))
        unchanged(m)
        stored(m, end, place, value, signs < 0)
        demand(m.impossible(z3.Or(joined(m, sum(SHORT_VECTOR[:2], ())) != following, m.registers[SHORT_SIGNS] != signs << 1)))
    return check


def long_sign(i, m):
    m.registers[27] = z3.BitVecVal(0, 8)
    place, value = begin_sign(m), joined(m, (24, 25, 26, 27))
    negative = z3.Extract(2 - i, 2 - i, m.registers[LONG_SIGNS]) == 1
    unchanged = same(m, (*sum(LONG_VECTOR[i + 1:], ()), *LONG_ROOT, LONG_SIGNS) if i < 2 else ())

    def check(m, end):
        unchanged(m)
        stored(m, end, place, value, negative)
    return check


def zero(m):
    place = joined(m, POINTER)

    def check(m, end):
        stored(m, end, place, z3.BitVecVal(0, 96), z3.BoolVal(False))
    return check


ANY, LARGEST = ((),), [(i,) for i in range(3)]
SHORT_STRETCHES = [
    (SHORT, partial(entry, SHORT_VECTOR, SHORT_SIGNS, lambda signs: z3.Concat(signs, z3.BitVecVal(16, 5))),
     (".Lbits",), (), ANY, (None,)),
    (".Lbits", partial(scaled, SHORT_VECTOR, SHORT_VECTOR, SHORT_SIGNS), (".Lbits", ".Lscaled", ".Lcomponent"),
     SHORT_SAVED, ANY, (None,)),
    (".Lscaled", short_squares, (".Lroot",), SHORT_SAVED, LARGEST, (None,)),
    (".Lroot", short_root, (".Lcomponent",), SHORT_SAVED),
    (".Lcomponent", short_component, (".Lsign",), SHORT_SAVED, ANY, (None,)),
    (".Lsign", short_sign, (".Lcomponent", None), SHORT_SAVED, LARGEST, (None,))]
LONG_STRETCHES = [
    (LONG, partial(entry, WIDE_VECTOR, LONG_SIGNS, lambda signs: z3.Concat(z3.BitVecVal(0, 5), signs)),
     (".Lbytes",), (), ANY, (None,)),
    (".Lbytes", partial(scaled, WIDE_VECTOR, LONG_VECTOR, LONG_SIGNS), (".Lscaled", ".Lzero"), LONG_SAVED, ANY, (None,)),
    (".Lscaled", long_squares, (".Lroot",), LONG_SAVED, LARGEST, (None,)),
    (".Lroot", long_root, (".Lreciprocal_root",), LONG_SAVED, [(i,) for i in range(1 << 22, 1 << 24, CHUNK)], (None,)),
    (".Lreciprocal_root", doubled, (".Lcomponent0",), LONG_SAVED),
    *((f".Lcomponent{i}", partial(long_component, i), (f".Lsign{i}",), LONG_SAVED, ANY, (None,)) for i in range(3)),
    *((f".Lsign{i}", partial(long_sign, i), (f".Lcomponent{i + 1}" if i < 2 else None,), LONG_SAVED, ANY, (None,))
      for i in range(3)),
    (".Lzero", zero, (None,), LONG_SAVED, ANY, (None,))]
SHORT_CUTS = ((".Lscaled", ".Lbits", "eor", "r31"), (".Lroot", ".Lscaled", "lsr", "r26"), (".Lsign", ".Lcomponent", "add", "r27"))
LONG_CUTS = ((".Lbytes", LONG, "ldi", "r21"), (".Lroot", ".Lscaled", "mov", "r30"),
             (".Lcomponent0", ".Lroot", "mul", "r7"), (".Lsign0", ".Lcomponent0", "sbrs", "r23"),
             (".Lcomponent1", ".Lsign0", "mul", "r11"), (".Lsign1", ".Lcomponent1", "sbrs", "r23"),
             (".Lcomponent2", ".Lsign1", "mul", "r14"), (".Lsign2", ".Lcomponent2", "sbrs", "r23"))
# By bits, by running it; the others by linear forms.
DOMAINS = {SHORT: Stores, LONG: Stores, ".Lbits": Stores, ".Lbytes": Stores, ".Lsign": Stores, ".Lzero": Stores,
           **{f".Lsign{i}": Stores for i in range(3)}, ".Lroot": Arrays}


def main():
    failed = False
    for stretches, cuts, sources in (
            (SHORT_STRETCHES, SHORT_CUTS, ("normalise3_q8_8", "long_division_table", "reciprocal_sqrt_q8_8_table")),
            (LONG_STRETCHES, LONG_CUTS, ("normalise3_q16_16", "reciprocal_sqrt_table"))):
        for machine in (Stores, Arrays, Bounded):
            labels = [label for label, *_ in stretches if DOMAINS.get(label, Bounded) is machine]
            failed |= Program(stretches, machine, sources=sources, cuts=cuts).run(4, ("ret", "rjmp"), labels)
    return failed


if __name__ == "__main__":
    sys.exit(main())
