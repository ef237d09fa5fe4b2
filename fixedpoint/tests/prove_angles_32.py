#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Proves an error bound of fixedpoint_atan2_q4_28 for all pairs of operands, from its instructions
and tables.

usage: prove_angles_32.py

The kernel calls two others. It is proven what each of them returns, and that the kernel calls them
correctly:

    fixedpoint_ratio_32, n < d      Q and a byte r: Q + r / 256 is 2^32 n / d, less 0 to REST
        index       n and d are moved up by the same bits, until bit 31 of d is set            by bits
        scale       E = 2^40 - w d, 0 < E < 2^32: with D = 2^40 - E, n w / D = n / d            by linear forms
        digit       n w 2^(8 i) = q D + x, 0 <= x < 2^40, of the i digits q that are found      by linear forms
        return      the same with x < D, and r is the uppermost of the five bytes of x          by linear forms
        As n w < D, the digits are below 2^(8 i): they are right, not only modulo that. And 2^32 n / d = Q + x / D,
        where x / D >= r 2^32 / 2^40, and x / D < (r + 1) 2^32 / (2^40 - 2^32) = (r + 1) / 255 <= r / 256 + REST.
    fixedpoint_cubic_40             V + t (S - t (256 b + w t2)), t2 the upper byte of t's three, s that of S - ...
        bent        256 b + w t2, for every interval and t2                                    by running it
        fall        that times t, less 0 to LOST                                               by linear forms
        return      V + t (S - that), less 0 to LOST                                           by linear forms
    fixedpoint_atan2_q4_28          the first octant's angle is that of Q and floor(s r / 256) more, or that of
                                    2^32 - 1 and 255 where n = d; the result is that of the octant, rounded    by bits

The errors are added up for each interval of the table, in units of 2^-39. That of the cubic against
the arc tangent is expanded around PIECES points of each interval: the fourth derivative of the
difference is that of the arc tangent alone, which is below 4.7. s is the slope from the start of
the interval, not that at t, and is truncated: its contribution errs by at most the difference of
the two. Then instructions are left out in turn, and bytes of the table are changed, and each time
the proof must fail.
"""

import sys
from functools import partial

import numpy
import z3

from arrays import Arrays
from bits import Bits, joined
from form import known
from machine_code import CALL_SAVED, Program, demand
from prove_quotients import TABLE as RECIPROCALS, Reciprocals, check_table
from stretches import Linear, equal, zeros

BOUND = 0.535  # ulp, 2^-28
NAME, RATIO, CUBIC, ARCTANGENT = "fixedpoint_atan2_q4_28", "fixedpoint_ratio_32", "fixedpoint_cubic_40", "fixedpoint_atan_32_table"
HALF_PI, PI, FRACTION, ULP = 863554413089, 1727108826179, 39, 1 << 11
N, D, SAVED = (22, 23, 24, 25), (18, 19, 20, 21), (14, 15, 16, 17, 28, 29)
E, V, ZERO, TOP = (28, 29, 30, 31), 27, 16, 26
# The bits that the digits' dividend is above them in, and the digits' registers.
WIDTH = 40
DIGITS = (25, 24, 23, 22)
REST = 256 / 255 - 255 / 256
T, BENT, FALL, VALUE, SLOPE = (18, 19, 20), (23, 24, 25), (22, 26, 27), (23, 24, 25, 26, 27), 22
# Of a product in units of 2^24: the lower bytes of three products of bytes, and all of three more.
LOST = 3 * 255 * 2**16 + 2 * 255**2 * 2**8 + 255**2
RECORD, PIECES, FOURTH = 12, 64, 4.7


class Calling(Bits):
    """Knows only what is proven about the functions it calls."""
    looked_up = 256

    def __init__(self, program):
        super().__init__(program)
        self.coordinates = self.cubic = None

    def step(self, address):
        mnemonic, _, target, following = self.program.code[address]
        if mnemonic != "call":
            return super().step(address)
        labels = self.program.labels
        if target == labels[RATIO]:
            demand(self.coordinates is None and self.is_zero(1))
            self.coordinates = joined(self, N), joined(self, D)
            kept = CALL_SAVED
        else:
            demand(target == labels[CUBIC] and self.cubic is None and self.is_zero(21))
            self.cubic = self.number(30, 2), joined(self, T)
            kept = (21, *CALL_SAVED)
        self.registers = {n: self.registers[n] if n in kept else z3.BitVec(f"{target}.r{n}", 8) for n in range(32)}
        if target == labels[RATIO]:
            self.ratio = joined(self, (TOP, *N))
        else:
            self.angle, self.slope = joined(self, VALUE), self.registers[SLOPE]
            self.holds.append(self.angle >= 0)
        self.flags = {"T": self.flags["T"]}
        return [(following, self)]


def atan2(m):
    y, x = m.number(22, 4), m.number(18, 4)
    height, width = (z3.If(number < 0, -number, number) for number in (y, x))
    steep, left = z3.UGT(height, width), x < 0
    table = m.program.labels[ARCTANGENT]

    def check(m, _):
        result = m.number(22, 4)
        if m.cubic is None:
            demand(m.impossible(z3.Or(y != 0, x != 0, result != 0)))
            return
        if m.coordinates:
            ratio = m.ratio
            called = z3.And(m.coordinates[0] == z3.If(steep, width, height), m.coordinates[1] == z3.If(steep, height, width),
                            height != width)
        else:
            ratio, called = z3.BitVecVal((1 << 40) - 1, 40), z3.And(height == width, y != 0)
        place, t = m.cubic
        index = z3.ZeroExt(8, z3.Extract(39, 32, ratio))
        angle = z3.ZeroExt(8, m.angle) + z3.ZeroExt(32, z3.LShR(z3.ZeroExt(8, m.slope) * z3.ZeroExt(8, z3.Extract(7, 0, ratio)), 8))
        whole = z3.If(steep, z3.If(left, HALF_PI + angle, HALF_PI - angle), z3.If(left, PI - angle, angle))
        rounded = z3.Extract(31, 0, (whole + ULP // 2) >> 11)
        demand(m.impossible(z3.Not(z3.And(called, place == table + RECORD * index, t == z3.Extract(31, 8, ratio),
                                          result == z3.If(y < 0, -rounded, rounded)))))
    return check


# The ratio


class Ratio(Reciprocals):
    """Returns with r1 as it is."""

    def is_zero(self, register):
        return register == 1 or super().is_zero(register)


def scaled(m):
    n, d = joined(m, N), joined(m, D)
    m.holds.append(z3.ULT(n, d))

    def check(m, _):
        demand("T" not in m.flags)
        moved = [z3.And(z3.LShR(d << k, k) == d, d << k == joined(m, D), n << k == joined(m, N)) for k in range(32)]
        demand(m.impossible(z3.Not(z3.And(z3.Or(*moved), m.registers[D[3]] < 0, m.registers[ZERO] == 0,
                                          m.registers[31] == (m.program.labels[RECIPROCALS] >> 8) + 1))))
    return check


def reciprocal(m):
    n, d = m.number(N), m.number(D)
    m.hold(128, m.registers[D[3]])
    m.zero(ZERO)
    m.registers[31] = known((m.program.labels[RECIPROCALS] >> 8) + 1)

    def check(m, _):
        demand(m.transfer is None)
        e = known(1 << WIDTH) - m.times(m.registers[V] + known(256), d)
        m.show(equal(m.number(N), n), *zeros(m, (ZERO,)), (1, e, (1 << 32) - 1))
        demand(m.constant(m.number(E) - e, 1 << 32) == 0)
    return check


def dividend(m):
    n, v, e = m.number(N), m.registers[V], m.number(E)
    scaled = m.times(n, v) + n * 256
    m.zero(ZERO)
    # As n < d, and w d = D.
    m.hold(0, scaled, (1 << WIDTH) - 1)

    def check(m, _):
        demand(m.transfer is None)
        m.show(equal(m.number(range(21, 26)), scaled), equal(m.number(E), e), *zeros(m, (ZERO, *range(17, 21))))
    return check


def at_digit(m, q):
    """E, the digits so far, and the remainder below the last of them if that is right."""
    m.zero(ZERO, *range(17, q - 5))
    e = m.number(E)
    m.hold(1, e)
    return e, m.number(range(q, 26)), m.number(range(q - 5, q)) + m.times(m.registers[q], e)


def digit(q, m):
    e, digits, rest = at_digit(m, q)

    def check(m, _):
        demand(m.transfer is None)
        more = m.constant(m.number(range(q, 26)) - digits, 1 << 8 * (26 - q))
        demand(more < 2)
        m.show(equal(m.number(range(q - 5, q)), rest + (e - known(1 << WIDTH)) * more), equal(m.number(E), e),
               *zeros(m, (ZERO, *range(17, q - 5))))
    return check


def remainder(m):
    m.zero(ZERO)
    e, digits, rest = m.number(E), m.number(N), m.number(range(17, 22))

    def check(m, _):
        demand(m.transfer is None)
        more = m.constant(m.number(N) - digits, 1 << 32)
        demand(more < 2)
        left = rest + (e - known(1 << WIDTH)) * more
        # Below 2^40 - E.
        m.show((0, left, None), (None, left + e, (1 << WIDTH) - 1), (0, left - m.registers[TOP] * (1 << 32), (1 << 32) - 1))
    return check


# The cubic


class Cubic(Linear):
    """Takes the bytes of the record one after the other, whatever their values."""

    def next(self, size):
        """The number of the next bytes."""
        record = [self.variable("record") for _ in range(size)]
        self.record = iter(record)
        return sum((byte * (1 << 8 * i) for i, byte in enumerate(record)), known(0))

    def compute(self, mnemonic, d, r, target, following):
        if mnemonic == "lpm" and r == "Z+":
            self.registers[d] = next(self.record)
            return [(following, self)]
        return super().compute(mnemonic, d, r, target, following)


class Rows(Arrays):
    """Looks up one byte after the other."""

    def compute(self, mnemonic, d, r, target, following):
        if mnemonic == "lpm" and r == "Z+":
            super().compute("lpm", d, "Z", target, following)
            place = self.registers[31] * 256 + self.registers[30] + 1
            self.place(place, (30, 31))
            return [(following, self)]
        found = super().compute(mnemonic, d, r, target, following)
        if mnemonic == "mulsu":
            self.carry = self.registers[1] >> 7
        return found


class Core(Program):
    """`table` is the one whose intervals are looked at, and how many it has."""
    table = ARCTANGENT, 256


def rows(program):
    """V, S, b and w of each interval, as the record has them in the order w, b, S, V."""
    name, intervals = program.table
    first = program.labels[name]
    table = numpy.frombuffer(program.flash[first:first + intervals * RECORD], dtype=numpy.uint8)
    table = table.reshape(intervals, RECORD).astype(numpy.int64)
    parts = [sum(table[:, i] << 8 * (i - begin) for i in range(begin, end)) for begin, end in ((7, 12), (3, 7), (1, 3))]
    return *parts, numpy.where(table[:, 0] < 128, table[:, 0], table[:, 0] - 256)


def bent(m):
    name, intervals = m.program.table
    i, t2 = (part.ravel() for part in numpy.meshgrid(numpy.arange(intervals), numpy.arange(256)))
    m.place(m.program.labels[name] + RECORD * i, (30, 31))
    m.place(t2, T[2:])
    m.registers[21] = 0
    _, slope, bend, twist = rows(m.program)
    wanted = 256 * bend[i] + twist[i] * t2
    place = m.program.labels[name] + RECORD * i + 3

    def check(m, _):
        demand(m.transfer is None and all(map(m.untouched, T[:2])) and (m.number(T[2:]) == t2).all())
        demand(m.is_zero(21) and (m.number(BENT) == wanted).all() and (m.number((30, 31)) == place).all())
        # So that it is 24 bits, and that the slope never falls below 0: then it is of 32 bits.
        demand((wanted >= 0).all() and (wanted < slope[i]).all())
    return check


def fall(m):
    product, t = m.times(m.number(BENT), m.number(T)), m.number(T)
    place = m.registers[30], m.registers[31]
    m.zero(21)

    def check(m, _):
        demand(m.transfer is None and place == (m.registers[30], m.registers[31]))
        m.show((0, product - m.number(FALL) * (1 << 24), LOST), equal(m.number(T), t), *zeros(m, (21,)))
    return check


def taken(m, record_read):
    """Z moves only by reading, and everything given is read."""
    demand((m.registers[30], m.registers[31]) == record_read and next(m.record, None) is None)


def rise(m):
    fall, t = m.number(FALL), m.number(T)
    place = m.registers[30], m.registers[31]
    m.zero(21)
    slope = m.next(4)
    # As `bent` shows.
    m.hold(0, slope - fall)

    def check(m, _):
        demand(m.transfer is None)
        taken(m, place)
        m.show(equal(m.number((*BENT, SLOPE)), slope - fall), equal(m.number(T), t), *zeros(m, (21,)))
    return check


def climbed(m):
    slope, t = m.number((*BENT, SLOPE)), m.number(T)
    place = m.registers[30], m.registers[31]
    m.zero(21)
    value = m.next(5)
    # As `bound` asks of the table; and t is below 2^24.
    m.hold(None, value + slope, (1 << 39) - 1)
    upper, product = m.registers[SLOPE], m.times(slope, t)
    m.hold(0, slope * (1 << 24) - product)

    def check(m, _):
        demand(m.transfer is None)
        taken(m, place)
        m.show((0, product - (m.number(VALUE) - value) * (1 << 24), LOST), equal(m.registers[SLOPE], upper), *zeros(m, (21,)))
    return check


def differences(program, function, fourth, pieces=PIECES):
    """The polynomial minus `function` in the middle of each piece of an interval, in units of 2^-39, and how much larger
    the difference may be elsewhere in the piece. `function` returns its value and three derivatives; `fourth` bounds the
    fourth."""
    value, slope, bend, twist = (part.astype(float)[:, None] for part in rows(program))
    demand((value + slope < 2.0**39).all())
    half, unit = 1 / (2 * pieces), 2.0**FRACTION
    t = (2 * numpy.arange(pieces)[None, :] + 1) * half
    exact = [unit / 256**n * each for n, each in enumerate(function(numpy.arange(len(value))[:, None] / 256 + t / 256))]
    # The difference and its derivatives by t, and what is beyond them.
    difference = (value - exact[0] + t * (slope - 256 * t * (bend + t * twist)),
                  slope - 512 * t * bend - 768 * t * t * twist - exact[1], -512 * bend - 1536 * t * twist - exact[2],
                  -1536 * twist - exact[3])
    beyond = sum(abs(each) * half**n / factorial for n, each, factorial in zip((1, 2, 3), difference[1:], (1, 2, 6)))
    # Numbers of at most 2^40 are rounded here, to 2^-13: a hundredth is far more than their errors sum up to.
    return difference[0], beyond + fourth * unit / 256**4 * half**4 / 24 + 0.01


def arc_tangent(x):
    square = 1 + x * x
    return numpy.arctan(x), 1 / square, -2 * x / square**2, (6 * x * x - 2) / square**3


def bound(program):
    """The error bound of the result, in units of 2^-28, from the table and from what is proven."""
    _, slope, bend, twist = (part.astype(float)[:, None] for part in rows(program))
    begin = numpy.arange(256)[:, None] / 256
    difference, beyond = differences(program, arc_tangent, FOURTH)
    lost = LOST / 2**24
    # t2 / 256 is t, less up to a 256th.
    cubic = ((difference - beyond + numpy.minimum(twist, 0)).min(1) - lost,
             (difference + beyond + numpy.maximum(twist, 0)).max(1) + lost)
    # floor(s r / 256) less the arc tangent's part beyond Q.
    slopes = slope[:, 0] / 2**24, (slope - numpy.maximum(bend * 256, bend * 256 + twist * 255))[:, 0] / 2**24
    steepest, flattest = (128 / (1 + each[:, 0]**2) for each in (begin, begin + 1 / 256 + 2.0**-31))
    low = numpy.minimum(slopes[1] - 1 - steepest, 0) - 1 - REST * steepest
    # Where n = d, the ratio is 2^-40 less than 1: less than REST.
    high = numpy.maximum(slopes[0] - flattest, 0)
    # The constants are pi and half of it, less up to a unit.
    most = float(max(abs(cubic[0] + low).max(), abs(cubic[1] + high).max())) + 1
    return 0.5 + most / ULP


def unnoticed(program):
    """Bytes of the table that may differ by 1 unnoticed although that is 2^-31."""
    flash, first = program.flash, program.labels[ARCTANGENT]
    found = []
    for place in (first + RECORD * i + byte for i in range(0, 256, 16) for byte in (0, 1, 4, 8)):
        program.flash = flash[:place] + bytes([flash[place] ^ 1]) + flash[place + 1:]
        found += [place] if bound(program) < BOUND else []
    program.flash = flash
    return found


ANY = ((),)
STRETCHES = [(NAME, atan2, (None,), (), ANY, (None,)),
             (RATIO, scaled, (".Lindex",), (), ANY, (None,)),
             (".Lindex", reciprocal, (".Lscale",), SAVED, ANY, (None,)),
             (".Lscale", dividend, (f".Ldigit{DIGITS[0]}",), SAVED, ANY, (None,)),
             *((f".Ldigit{q}", partial(digit, q), (f".Ldigit{q - 1}" if q > 22 else ".Lremainder",), SAVED, ANY, (None,))
               for q in DIGITS),
             (".Lremainder", remainder, (None,), SAVED, ANY, (None,)),
             (CUBIC, bent, (".Lfall",), (), ANY, (None,)),
             (".Lfall", fall, (".Lslope",), (), ANY, (None,)),
             (".Lslope", rise, (".Lrise",), (), ANY, (None,)),
             (".Lrise", climbed, (".Lend",), (), ANY, (None,)),
             (".Lend", None, (), ())]
CUTS = ((".Lpower", RATIO, "lpm", "r17"), (".Lindex", ".Lpower", "mov", "r30"), (".Lscale", ".Lindex", "mov", "r27"),
        (".Ldigit25", ".Lscale", "mul", "r28"), *((f".Ldigit{q}", f".Ldigit{q + 1}", "mul", f"r{q}") for q in DIGITS[1:]),
        (".Lremainder", ".Ldigit22", "mov", "r26"), (".Lfall", CUBIC, "mul", "r23"), (".Lslope", ".Lfall", "lpm", "r23"),
        (".Lrise", ".Lslope", "mul", "r23"), (".Lend", ".Lrise", "ret", ""))


def main():
    failed = False
    for machine, every, labels in ((Calling, 8, (NAME, RATIO)),
                                   (Ratio, 8, (".Lindex", ".Lscale", *(f".Ldigit{q}" for q in DIGITS), ".Lremainder")),
                                   (Rows, 1, (CUBIC,)), (Cubic, 8, (".Lfall", ".Lslope", ".Lrise"))):
        program = Core(STRETCHES, machine, cuts=CUTS,
                       sources=("atan2_32", "cubic_32", "reciprocal_table", "atan_32_table", "scale_40"))
        if machine is Ratio:
            check_table(program)
        failed |= program.run(every, ("ret", "rjmp"), labels)
    found, places = bound(program), unnoticed(program)
    print(f"{NAME}: errs by less than {found:.6f} ulp, of at most {BOUND}; bytes of the table that could be another: {places}")
    return failed or found >= BOUND or places != []


if __name__ == "__main__":
    sys.exit(main())
