#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Proves the largest errors of cbrt in Q16.16 and log in Q8.24 for all operands from the machine code and tables that
are measured.

usage: prove_cube_roots.py FOLDER    the folder of the device programs

    cbrt            e^(ln |a| / 3), with the sign of a, rounded                                         by bits
    log_q8_24       for every a whose leading one is bit e: its place in the table, and e ln 2 added    by bits
    cubic_32        V + t (S - t (b + w t2 / 256)), V and S without their lowest bytes:
        bent        b + w t2 / 256, rounded downward, for every interval and t2                         by running it
        fall        that times t, minus 0 to LOST_FALL                                                  by linear forms
        return      V + t (S - that), minus 0 to LOST                                                   by linear forms
    exp_wide        bench/prove_powers proves its error

The errors are added up; that of the logarithm is largest where the root is. Then instructions are left out in turn, and bytes
of the table changed, and each time the proof must fail; in compiled code, up to a third of the
instructions may be left out without the proof failing.
"""
import sys
from functools import partial
from pathlib import Path

import numpy
import z3
from mpmath import mp

from calling import A64, B64, FRAME, Compiled, shown
from form import Form
from machine_code import CALL_SAVED, demand
from prove_angles_32 import LOST, RECORD, T, Core, Cubic, Rows, differences, rows, taken
from prove_powers import A32, EXP, INTERVALS, LN2_40, LONG_PRODUCT, TABLE, mantissa_errors, of_one_sign, rounded, unnoticed
from stretches import equal, zeros

BOUND, LOGARITHM_BOUND = 0.54, 0.554  # ulp of Q16.16 and Q8.24
ROOT, NATURAL, LOG = "cbrt_q16_16_default", "_ZN10fixedpoint6kernel8composed16NaturalLogarithmIlE2ofEm", "fixedpoint_log_q8_24"
CUBIC, LOGARITHMS, PIECES, EVERY = "fixedpoint_cubic_32", "fixedpoint_log_32_table", 64, 20
THIRD, LN2, EIGHT_LN2 = ((1 << 48) - 1) // 3, 11629080, 93032640  # 2^-48, 2^-24
HALF, LN2_24 = (1 << 6) + 1, 24 * 381061692393 >> 8  # half an ulp of 2^-24 plus the mean truncation of the core; 2^-31
BENT, FALL, VALUE, SLOPE = (24, 25), (22, 23), (22, 23, 24, 25), (24, 25, 26)
# Dropped from a product in units of 2^24: the lower bytes of two byte products, and all of three more.
LOST_FALL = 2 * 255 * 2**16 + 2 * 255**2 * 2**8 + 255**2


# The root


def root(m):
    a = m.number(*A32)

    def check(m, _):
        if not m.calls:
            shown(m, a == 0, m.number(*A32) == 0)
            return
        (log, (of,), logarithm), (product, factors, exponent), (exp, (argument, unit), power) = m.calls
        demand((log, product, exp) == (NATURAL, LONG_PRODUCT, EXP))
        shown(m, a != 0, of == z3.If(a < 0, -a, a), factors[0] == z3.SignExt(32, logarithm + EIGHT_LN2), factors[1] == THIRD,
              argument == exponent, unit == 16)
        shown(m, m.number(*A32) == rounded(power, of_one_sign(m, a < 0)))
    return check


def natural(m):
    a = m.number(*A32)

    def check(m, _):
        (_, (of,), logarithm), = m.calls
        large = a < 0
        shown(m, of == z3.If(large, z3.LShR(a, 1), a), m.number(*A32) == z3.If(large, logarithm + LN2, logarithm))
    return check


class Jumping(Compiled):
    """May leave by a jump to a function instead of a call."""

    def step(self, address):
        mnemonic, _, target, _ = self.program.code[address]
        if mnemonic == "jmp" and target in self.called:
            name, operands, size = self.called[target]
            self.calls.append((name, [self.number(*place) for place in operands], z3.BitVec("left", 8 * size)))
            for i in range(size):
                self.registers[26 - size + i] = z3.Extract(8 * i + 7, 8 * i, self.calls[-1][2])
            demand(not self.stack)
            return [(None, self)]
        return super().step(address)


# The logarithm


class Logarithm(Compiled):
    """Calls the core, which takes r21 as zero; looks up the values shared by all numbers with one leading bit."""

    def step(self, address):
        mnemonic, _, target, following = self.program.code[address]
        if mnemonic != "call":
            return super().step(address)
        demand(target == self.program.labels[CUBIC] and self.is_zero(21) and not self.calls)
        given = [self.number(30, 2), self.number(18, 3)]
        kept = {n: self.registers[n] for n in (18, 19, 20, 21, *CALL_SAVED)}
        self.registers = {n: z3.BitVec(f"core.r{n}", 8) for n in range(32)} | kept
        self.flags = {}
        self.calls.append((CUBIC, given, self.number(22, 4)))
        return [(following, self)]

    def compute(self, mnemonic, d, r, target, following):
        if mnemonic != "lpm":
            return super().compute(mnemonic, d, r, target, following)
        place = self.pointer("Z+") if r == "Z+" else z3.simplify(self.number(30, 2))
        if self.bit is None:
            self.registers[d] = z3.FreshConst(z3.BitVecSort(8))
            return [(following, self)]
        if z3.is_bv_value(place):
            first = last = place.as_long()
        else:
            # The leading byte, without its last bit.
            page, lead = z3.simplify(self.registers[31]), 1 << self.bit % 8
            demand(z3.is_bv_value(page))
            first, last = (page.as_long() * 256 + (byte >> 1) for byte in (lead, 2 * lead - 1))
            shown(self, z3.UGE(place, first), z3.ULE(place, last))
        found = set(self.program.flash[first:last + 1])
        demand(len(found) == 1)
        self.read.append(found.pop())
        self.registers[d] = z3.BitVecVal(self.read[-1], 8)
        return [(following, self)]


def logarithm(m, bit):
    m.bit, m.read = bit, []
    a = m.number(*A32)
    if bit is None:
        m.holds.append(a <= 0)
    else:
        m.holds.append(z3.LShR(a, bit) == 1)

    def check(m, _):
        if bit is None:
            demand(not m.calls)
            shown(m, m.number(*A32) == 1 << 31)
            return
        demand(len(m.calls) == 1)
        (_, (record, t), value), = m.calls
        position = a << 32 - bit if bit else z3.BitVecVal(0, 32)
        shown(m, record == m.program.labels[LOGARITHMS] + RECORD * z3.ZeroExt(8, z3.Extract(31, 24, position)),
              t == z3.Extract(23, 0, position))
        exact = sum(byte << 8 * i for i, byte in enumerate(m.read[-5:]))
        demand(m.program.multiples.setdefault(bit, exact) == exact)
        exact += HALF - LN2_24
        wide = z3.ZeroExt(8, value) + exact
        shown(m, m.number(*A32) == z3.Extract(31, 0, wide >> 7))
        # So that the upper bits are copies of the sign.
        demand(-(1 << 37) < exact < 1 << 37)
    return check


# The core


def bent(m):
    name, intervals = m.program.table
    i, t2 = (part.ravel() for part in numpy.meshgrid(numpy.arange(intervals), numpy.arange(256)))
    first = m.program.labels[name] + RECORD * i
    m.place(first, (30, 31))
    m.place(t2, T[2:])
    m.registers[21] = 0
    _, slope, bend, twist = rows(m.program)
    wanted = bend[i] + (twist[i] * t2 >> 8)

    def check(m, _):
        demand(m.transfer is None and all(map(m.untouched, T[:2])) and (m.number(T[2:]) == t2).all())
        demand(m.is_zero(21) and (m.number(BENT) == wanted).all() and (m.number((30, 31)) == first + 3).all())
        demand((wanted >= 0).all() and (wanted < slope[i] >> 8).all())
    return check


class Core32(Cubic):
    """Skips bytes of the record by adding to its address."""

    def compute(self, mnemonic, d, r, target, following):
        if mnemonic == "adiw" and d == 30:
            for _ in range(int(r, 0)):
                next(self.record)
            return [(following, self)]
        return super().compute(mnemonic, d, r, target, following)


def fall(m):
    product, t = m.times(m.number(BENT), m.number(T)), m.number(T)
    place = m.registers[30], m.registers[31]
    m.zero(21)

    def check(m, _):
        demand(m.transfer is None and place == (m.registers[30], m.registers[31]))
        m.show((0, product - m.number(FALL) * (1 << 24), LOST_FALL), equal(m.number(T), t), *zeros(m, (21,)))
    return check


def rise(m):
    fall, t = m.number(FALL), m.number(T)
    place = m.registers[30], m.registers[31]
    m.zero(21)
    upper = upper_bytes(m.next(4))
    m.hold(0, upper - fall)

    def check(m, _):
        demand(m.transfer is None)
        taken(m, place)
        m.show(equal(m.number(SLOPE), upper - fall), equal(m.number(T), t), *zeros(m, (21,)))
    return check


def upper_bytes(number):
    """A number without its lowest byte."""
    return Form({name: factor >> 8 for name, factor in number.items() if factor > 1})


def climbed(m):
    slope, t = m.number(SLOPE), m.number(T)
    place = m.registers[30], m.registers[31]
    m.zero(21)
    value = upper_bytes(m.next(5))
    m.hold(None, value + slope, (1 << 32) - 1)
    product = m.times(slope, t)
    m.hold(0, slope * (1 << 24) - product)

    def check(m, _):
        demand(m.transfer is None)
        taken(m, place)
        m.show((0, product - (m.number(VALUE) - value) * (1 << 24), LOST))
    return check


class Roots(Core):
    table = LOGARITHMS, 256
    multiples = {}  # multiples of ln 2, by the leading bit


def natural_logarithm(x):
    return numpy.log1p(x), 1 / (1 + x), -1 / (1 + x)**2, 2 / (1 + x)**3


def logarithm_errors(program):
    """The lowest and the highest error of the logarithm in Q8.24, in its ulp."""
    value, slope, _, twist = (part[:, None] for part in rows(program))
    difference, beyond = (part / 256 for part in differences(program, natural_logarithm, 6.0, PIECES))
    begin, end = ((numpy.arange(PIECES) + each) / PIECES for each in (0, 1))
    cut = (value & 255) / 256
    low = difference - beyond - cut - (slope & 255) / 256 * end + numpy.minimum(twist, 0) / 256 * end**2 - LOST / 2**24
    high = difference + beyond - cut - (slope & 255) / 256 * begin + (1 + numpy.maximum(twist, 0) / 256) * end**2
    high += LOST_FALL / 2**24 * end
    demand(sorted(program.multiples) == list(range(31)))
    constants = [float(number - mp.log(2) * bit * 2**31 + HALF - 64 - LN2_24 + mp.log(2) * 24 * 2**31)
                 for bit, number in program.multiples.items()]
    return (low.min() + min(constants)) / 128 - 0.5, (high.max() + max(constants)) / 128 + 0.5


def bound(program):
    """The error of a root, in ulp."""
    log = max(map(abs, logarithm_errors(program)))
    # The logarithm of 2^31 is that of 2^30 plus ln 2.
    log += abs(float(LN2 - mp.log(2) * 2**24)) + abs(float(EIGHT_LN2 - mp.log(2) * 8 * 2**24))
    program.table = TABLE, INTERVALS
    mantissa = max(abs(each).max() for each in mantissa_errors(program))
    program.table = LOGARITHMS, 256
    # All relative to the root: k is from -5 to 6, and a mantissa is at least e^-0.8.
    parts = log / 2**24 / 3 + 12 / 2**48 + 2.0**-41 + mantissa / (2**39 * numpy.exp(-0.8))
    parts += 6 * abs(float(LN2_40 - mp.log(2) * 2**40)) / 2**40
    # exp_wide truncates to a 256th of an ulp; the largest root is 32.
    return 0.5 + 2.0**-8 + 1.001 * 2**21 * parts


def entries(program):
    """Bytes of the table of which 1 is 2^-23 or more."""
    first = program.labels[LOGARITHMS]
    return (first + RECORD * i + byte for i in (0, 100, 255) for byte in (2, 5, 9))


CALLED = {NATURAL: ([A32], 4), LONG_PRODUCT: ([A64, B64], 8), EXP: ([A64, (16, 1)], 8)}
ANY = ((),)
STRETCHES = [(ROOT, root, (None,), (), ANY, (None,)), (NATURAL, natural, (None,), (), ANY, (None,)),
             (LOG, logarithm, (None,), (), [(bit,) for bit in (None, *range(31))], (None,)),
             (CUBIC, bent, (".Lfall",), (), ANY, (None,)),
             (".Lfall", fall, (".Lslope",), (), ANY, (None,)),
             (".Lslope", rise, (".Lrise",), (), ANY, (None,)),
             (".Lrise", climbed, (".Lend",), (), ANY, (None,)),
             (".Lend", None, (), ())]
CUTS = ((".Lfall", CUBIC, "mul", "r25"), (".Lslope", ".Lfall", "adiw", "r30"), (".Lnext", ".Lslope", "lpm", "r24"),
        (".Lrise", ".Lnext", "adiw", "r30"), (".Lend", ".Lrise", "ret", ""))


def main():
    elf, failed, count, needless = Path(sys.argv[1]) / "q16_16_powers.elf", False, 0, []
    mp.prec = 100
    for name, called in ((ROOT, CALLED), (NATURAL, {LOG: ([A32], 4)})):
        program = Roots([each for each in STRETCHES if each[0] == name], partial(Jumping, called), elf=elf)
        visited = program.prove(*program.stretches[0])
        print(f"{name}: proven", flush=True)
        count += len(visited)
        needless += program.survivors(program.stretches[0], visited, EVERY, ("ret", "rjmp", *FRAME))
    # Compiled code contains instructions that change nothing.
    print(f"of {count} compiled instructions one in {EVERY} was left out, without effect {needless}")
    failed |= 3 * EVERY * len(needless) > count
    program = Roots(STRETCHES, partial(Logarithm, {}), elf=elf, cuts=CUTS)
    (stretch,) = (each for each in STRETCHES if each[0] == LOG)
    found = program.survivors(stretch, program.prove(*stretch), 26, ("ret", "rjmp"))
    # The table begins at a page boundary.
    found = [each for each in found if not each.endswith("subi r30, 0x00")]
    print(f"{LOG}: proven; without effect {found}", flush=True)
    failed |= found != []
    for machine, every, labels in ((Rows, 1, (CUBIC,)), (Core32, 4, (".Lfall", ".Lslope", ".Lrise"))):
        program = Roots(STRETCHES, machine, elf=elf, cuts=CUTS)
        failed |= program.run(every, ("ret", "rjmp"), labels)
    found, places = bound(program), unnoticed(program, entries(program), lambda each: bound(each) < BOUND)
    of_logarithms = max(map(abs, logarithm_errors(program)))
    print(f"cbrt_q16_16_default: errs by less than {found:.6f} ulp, of at most {BOUND}; {LOG} by less than {of_logarithms:.6f}, "
          f"of at most {LOGARITHM_BOUND}; bytes of the table that could be another: {places}")
    return failed or found >= BOUND or of_logarithms >= LOGARITHM_BOUND or places != []


if __name__ == "__main__":
    sys.exit(main())
