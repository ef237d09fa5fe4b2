#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Proves the largest error of pow in Q16.16 and Q8.8 for all pairs of operands from the machine code and tables that are
measured.

usage: prove_powers.py FOLDER    the folder of the device programs

    pow             e^(y ln |x|) with the right sign, rounded and saturated, and the defined results in
                    the special cases; pow in Q8.8 is that of Q16.16, rounded again                     by bits
    logarithm_56    the normalised mantissa, then the polynomial of its distance from a node, in the
                    products of kernels that fixedpoint/prove_products proves                           by bits
    exp_wide        k ln 2 - r, the mantissa e^-r from the core, the shift                              by bits
    cubic_40        fixedpoint/prove_angles_32 proves its instructions; here, that the table meets
                    their preconditions                                                                 by running it

The products of libgcc are assumed to be exact.

The errors are added up. That of a logarithm L counts relative to L, since |y ln x| <= 15 ln 2 if a power is in range; next to
1, where it is largest, each x is looked at. That of the mantissa counts where it is largest, from 2^30.9 units on; where its
bound is too wide, the cubic is run for every t. Then instructions are left out in turn, and bytes of the tables changed, and
each time the proof must fail; in compiled code, up to a third of the instructions may be left out without the
proof failing.
"""
import sys
from functools import partial
from pathlib import Path

import numpy
import z3
from mpmath import mp, mpf

from calling import A64, B64, FRAME, SUMS, Compiled, shown, sum_of
from machine_code import CALL_SAVED, Unprovable, demand
from prove_angles_32 import CUBIC, LOST, RECORD, SLOPE, T, VALUE, Core, Rows, bent, differences, rows

LOG, POW = "_ZN10fixedpoint6kernel8composed12logarithm_56ILi16EEExm", "pow_{}_default"
NODE = "_ZN10fixedpoint8portable17LogarithmOfFactorIvE{}E"
CONVERT = "_ZN10fixedpoint8portable17convert_saturatedIiLi8ElLi16EEENS0_9ConvertedIT_EET1_"
LOAD = "_ZN10fixedpoint19load_program_memoryEPKy"
EXP, TABLE, INTERVALS = "fixedpoint_exp_wide", "fixedpoint_exp_32_table", 208
LONG_PRODUCT, SHORT_PRODUCT, WIDE_PRODUCT, FULL_PRODUCT = (
    "fixedpoint_multiply_q32_32", "fixedpoint_multiply_q0_32", "__umulsidi3", "__muldi3")
A32, B32 = (22, 4), (18, 4)
LN2_40, LN2_56 = 762123384786, 0xb17217f7d1cf7a
OFFSET, K, MOST_K = 35, 27, 104
LARGEST = 0xffffffff << 32
FIFTH, SIXTH, FOURTH, THIRD, HALF = 13107, 341, 524288, 22369621, 1 << 30
FROM = 15 * 0.6931471805599453
PIECES = 512  # of an interval
BOUND = 0.75  # ulp
# Nothing is run if a bound is wider than this, in ulp.
WIDEST = BOUND + 0.05
RUN_BITS = 20  # of t, at once
EVERY = 60
# The registers pushed by a function that uses all of them.
EVERY_SAVED = (*range(2, 18), 28, 29)
OUT, NEXT = ".Lnode", ".Lloop"
OCTAVE, SCALE = ".Loctave", ".Lscale"


# pow


def rounded(power, negative):
    """A power in units of 2^-32, rounded and saturated."""
    whole, up = z3.Extract(63, 32, power), z3.ZeroExt(31, z3.Extract(31, 31, power))
    limit = z3.BitVecVal((1 << 31) - 1 + negative, 32)
    magnitude = z3.If(z3.Or(z3.UGT(whole, limit), z3.UGT(whole + up, limit)), limit, whole + up)
    return -magnitude if negative else magnitude


def of_one_sign(m, negative):
    """Whether the path is the one for negative results."""
    found = not m.impossible(negative)
    shown(m, negative == found)
    m.holds.append(negative == found)
    return found


def narrowed(number):
    """A Q16.16 number rounded and saturated to Q8.8."""
    wide = (z3.SignExt(1, number) + 128) >> 8
    return z3.Extract(15, 0, z3.If(wide > 32767, z3.BitVecVal(32767, 33), z3.If(wide < -32768, z3.BitVecVal(-32768, 33), wide)))


def converted(m):
    number = m.number(*A32)

    def check(m, _):
        shown(m, m.number(22, 2) == narrowed(number))
    return check


def pow_of(size, m):
    """pow in Q8.8 is that of Q16.16."""
    short = size == 2
    x, y = (m.number(low, size) for low in ((24, 22) if short else (22, 18)))
    if short:
        x, y = (z3.Concat(z3.SignExt(8, number), z3.BitVecVal(0, 8)) for number in (x, y))
    fraction = z3.Extract(15, 0, y)

    def check(m, _):
        result = m.number(26 - size, size)
        if short:
            *m.calls, (convert, (wide,), narrow) = m.calls
            demand(convert == CONVERT)
            shown(m, result == z3.Extract(15, 0, narrow))
            result = wide
        if not m.calls:
            largest = z3.BitVecVal((1 << 31) - 1, 32)
            shown(m, z3.Or(z3.And(y == 0, result == 1 << 16), z3.And(y != 0, x == 0, result == z3.If(y > 0, 0, largest)),
                           z3.And(y != 0, x < 0, fraction != 0, result == 0)))
            return
        (log, (of,), logarithm), (product, factors, exponent), (exp, (argument, unit), power) = m.calls
        demand((log, product, exp) == (LOG, LONG_PRODUCT, EXP))
        negative = z3.And(x < 0, z3.Extract(16, 16, y) == 1)
        shown(m, x != 0, y != 0, z3.Or(x > 0, fraction == 0), of == z3.If(x < 0, -x, x), factors[0] == logarithm,
              factors[1] == z3.SignExt(32, y), argument == exponent, unit == 16)
        shown(m, result == rounded(power, of_one_sign(m, negative)))
    return check


# The logarithm


class Logarithm(Compiled):
    def look_up(self):
        """Whatever it is."""
        found = z3.BitVec(f"table.{len(self.calls)}", 8)
        self.calls.append(("table", [self.number(30, 2)], found))
        return found


def begun(m):
    x = m.number(*A32)

    def check(m, _):
        shown(m, m.number(*B32) == x, m.frame[1] == 15)
        demand(not m.calls)
    return check


def doubled(m):
    m.has_frame = True
    x, m.frame[1] = m.number(*B32), m.registers[2]
    exponent = m.frame[1]

    def check(m, end):
        if end == OUT:
            shown(m, x < 0, m.number(*B32) == x, m.frame[1] == exponent)
        else:
            shown(m, x >= 0, m.number(*B32) == x << 1, m.frame[1] == exponent - 1)
    return check


def distance(m):
    m.has_frame = True
    x, m.frame[1] = m.number(*B32), m.registers[2]
    exponent = m.frame[1]
    labels = m.program.labels
    m.holds.append(x < 0)

    def check(m, _):
        names, operands, results = zip(*m.calls)
        demand(names == ("table", WIDE_PRODUCT, *[SHORT_PRODUCT] * 4, LONG_PRODUCT, LONG_PRODUCT, LOAD, FULL_PRODUCT))
        (place,), (one, other), *short, bend, square, (node_place,), (count, ln2) = operands
        decrease, product, sixth, fifth, fourth, third, bent, fall, logarithm, multiple = results
        node = z3.LShR(z3.ZeroExt(8, z3.Extract(31, 24, x)) - 127, 1)
        s = product - (1 << 39)
        z = z3.Extract(31, 0, s >> 2)
        half = z3.BitVecVal(HALF, 32) - third
        shown(m, place == labels[NODE.format("8decrease")] + node, one == 256 - z3.ZeroExt(24, decrease), other == x,
              *(factors[0] == z for factors in short), short[0][1] == SIXTH, short[1][1] == FIFTH - sixth,
              short[2][1] == FOURTH - fifth, short[3][1] == THIRD - fourth,
              bend[0] == s << 11, bend[1] == z3.SignExt(32, half), square[0] == s, square[1] == bent,
              node_place == labels[NODE.format("9logarithm")] + 8 * node, count == z3.SignExt(56, exponent), ln2 == LN2_56,
              m.number(18, 8) == (s << 17) - fall + logarithm + multiple)
    return check


PARTS = 32  # of the distances from a node
# Where a bound of the relative error is above CLOSE, as many x are looked at one by one.
CLOSE, ALONE = 1.2e-12, 1 << 11


def nearest_product(a, b):
    return a * b + (1 << 31) >> 32


def logarithm_of(mantissa, factor, logarithm, exponent):
    """What `distance` shows, in units of 2^-56."""
    s = factor * mantissa - (1 << 39)
    horner = SIXTH
    for constant in FIFTH, FOURTH, THIRD, HALF:
        horner = constant - nearest_product(s >> 2, horner)
    return (s << 17) - nearest_product(s, nearest_product(s << 11, horner)) + logarithm + exponent * LN2_56


def errors_of_each(mantissas, factor, logarithm, exponent):
    """The lowest and the highest relative error."""
    errors = [0.0]
    for mantissa in mantissas:
        exact = mp.log(mpf(mantissa) / 2**31) + exponent * mp.log(2)
        computed = logarithm_of(mantissa, factor, logarithm, exponent)
        demand(exact != 0 or computed == 0)
        errors.append(float(computed / (exact * 2**56) - 1) if exact else 0.0)
    return min(errors), max(errors)


def logarithm_errors(program):
    """The lowest and the highest relative error of a logarithm over all x."""
    flash, labels = program.flash, program.labels
    first, second = (labels[NODE.format(name)] for name in ("8decrease", "9logarithm"))
    lowest = highest = 0.0
    # So the logarithm of 1 is 0.
    demand(not flash[first] and not any(flash[second:second + 8]))
    for node in range(65):
        factor = 256 - flash[first + node]
        logarithm = int.from_bytes(flash[second + 8 * node:second + 8 * node + 8], "little")
        least, most = max(2 * node + 127, 128) << 24, min((2 * node + 129 << 24) - 1, (1 << 32) - 1)
        # The exact logarithm minus that of the table, in units of 2^-56; to 2^-100.
        from_table = abs(float(logarithm - mp.log(mpf(256) / factor) * 2**56))
        s = numpy.linspace(least * factor / 2.0**39 - 1, most * factor / 2.0**39 - 1, PARTS + 1)
        low, high = s[:-1], s[1:]
        m = numpy.maximum(abs(low), abs(high))
        demand(m.max() * 2**37 + 1 < 2**31)
        u = (m * 2**37 + 1) / 2**32
        # For each sum: half a unit of the product, the constant, the previous sum, and the truncation of z.
        error = 0.5 + abs(FIFTH - 2**16 / 5) + m * abs(SIXTH * 2.0**5 - 2**16 / 6) + SIXTH / 2**32
        for constant, exact, factor_of_z in ((FOURTH, 2**21 / 4, 2**16), (THIRD, 2**26 / 3, 2**21), (HALF, 2**31 / 2, 2**26)):
            error = 0.5 + abs(constant - exact) + u * error + factor_of_z / 2**32
        error = 0.5 + m * 2**39 * (0.5 + m * 2**18 * error) / 2**32
        error += 2.0**56 * m**7 / 7 / (1 - m) + from_table
        for exponent in range(-16, 16):
            of_ln2 = abs(exponent) * abs(float(LN2_56 - mp.log(2) * 2**56))
            whole = logarithm / 2.0**56 + exponent * numpy.log(2)
            ends = whole + numpy.log1p(low), whole + numpy.log1p(high)
            # Next to 1 it is the logarithm of 1 +- 2^-16, or exactly 0.
            nearest = numpy.where(ends[0] * ends[1] <= 0, 0, numpy.minimum(abs(ends[0]), abs(ends[1])))
            relative = ((error + of_ln2) / numpy.maximum(nearest, 2.0**-16 - 2.0**-32)).max() / 2.0**56
            # x is a whole number.
            step = 1 << 15 - exponent
            mantissas = range(-(-least // step) * step, most + 1, step)
            found = (errors_of_each(mantissas, factor, logarithm, exponent) if relative > CLOSE and len(mantissas) <= ALONE else
                     (-relative, relative))
            lowest, highest = min(lowest, found[0]), max(highest, found[1])
    return lowest, highest


# The power of e


class Exponential(Compiled):
    """Calls the core, which takes r21 as zero."""

    def step(self, address):
        mnemonic, _, target, following = self.program.code[address]
        if mnemonic != "call" or target != self.program.labels[CUBIC]:
            return super().step(address)
        demand(self.is_zero(21) and not self.calls)
        given = [self.number(30, 2), self.number(18, 3), self.stack[-1]]
        kept = {n: self.registers[n] for n in (21, *CALL_SAVED)}
        self.registers = {n: z3.BitVec(f"core.r{n}", 8) for n in range(32)} | kept
        self.flags = {}
        self.calls.append((CUBIC, given, (self.number(23, 5), self.registers[22])))
        return [(following, self)]


def octave(m):
    x, unit = m.number(*A64), m.registers[16]
    upper = x >> 40
    k = z3.Extract(15, 0, upper) * 185 + z3.LShR(z3.ZeroExt(8, z3.Extract(39, 32, x)) * 185, 8) + 128 * (OFFSET + 1) + 9 >> 7

    def check(m, end):
        result = m.number(*A64)
        if end is None:
            shown(m, z3.Or(z3.And(upper >= 46, result == LARGEST), z3.And(upper < -24, result == 0)))
        else:
            shown(m, upper < 46, upper >= -24, m.number(18, 5) == z3.Extract(39, 0, x), m.registers[16] == unit,
                  z3.ZeroExt(8, m.registers[K]) == k, k <= MOST_K)
    return check


def exponential(m):
    x, unit, k = m.number(18, 5), m.registers[16], m.registers[K]
    m.holds += [unit >= 0, unit <= 29, k >= 0, k <= MOST_K]
    place = k + unit - (OFFSET - 9)

    def check(m, end):
        if end is None:
            result = m.number(*A64)
            shown(m, z3.Or(z3.And(place >= 42, result == LARGEST), z3.And(place < 0, result == 0)))
            return
        (_, (record, t, lowest), (value, slope)), = m.calls
        rest = z3.SignExt(32, k) * LN2_40 - OFFSET * LN2_40 - x
        last = z3.ZeroExt(24, z3.LShR(z3.ZeroExt(8, slope) * z3.ZeroExt(8, lowest), 8))
        shown(m, m.registers[19] == place, place >= 0, place < 42, lowest == z3.Extract(7, 0, rest), t == z3.Extract(31, 8, rest),
              record == m.program.labels[TABLE] + RECORD * z3.ZeroExt(8, z3.Extract(39, 32, rest)),
              m.number(23, 5) == (1 << 39) - 1 - value - last)
    return check


def scaled(m, place):
    mantissa = m.number(23, 5)
    m.registers[19] = z3.BitVecVal(place, 8)
    m.holds.append(z3.ULE(mantissa, 1 << 39))

    def check(m, _):
        wide = z3.ZeroExt(24, mantissa)
        shown(m, m.number(18, 8) == (wide << 25 if place > 40 else z3.LShR(wide, 40 - place) << 24))
    return check


def power_of_e(x):
    power = numpy.exp(-x)
    return 1 - power, power, -power, power


def mantissa_errors(program):
    """The lowest and the highest error of each interval, in units of 2^-39."""
    _, slope, bend, twist = (part.astype(float)[:, None] for part in rows(program))
    difference, beyond = differences(program, power_of_e, 1.0, PIECES)
    # t2 / 256 is up to a 256th below t; the error of the fall is multiplied by t.
    t = numpy.arange(1, PIECES + 1) / PIECES
    value = ((difference - beyond + numpy.minimum(twist, 0) * t**2).min(1) - LOST / 2**24,
             (difference + beyond + numpy.maximum(twist, 0) * t**2 + LOST / 2**24 * t).max(1))
    # floor(s r / 256) minus the fall of the power beyond Q.
    slopes = slope[:, 0] / 2**24, (slope - numpy.maximum(bend * 256, bend * 256 + twist * 255))[:, 0] / 2**24
    steepest, flattest = (128 * numpy.exp(-(numpy.arange(INTERVALS) + each) / 256) for each in (0, 1 + 2.0**-23))
    last = numpy.minimum(slopes[1] - 1 - steepest, 0) - 1, numpy.maximum(slopes[0] - flattest, 0)
    return -1 - value[1] - last[1], -1 - value[0] - last[0]


def every_t(found, m, interval, part):
    """Adds the lowest and the highest errors of the mantissa, in units of 2^-39."""
    t = (part << RUN_BITS) + numpy.arange(1 << RUN_BITS)
    m.place(numpy.int64(m.program.labels[TABLE] + RECORD * interval), (30, 31))
    m.place(t, T)
    m.registers[21] = 0
    power = numpy.exp(-((interval << 24) + t) / 2.0**32)

    def check(m, _):
        demand(m.transfer is None and m.is_zero(21))
        value = sum(m.registers[register].astype(numpy.int64) << 8 * i for i, register in enumerate(VALUE))
        error = (1 << 39) - 1 - value - 2.0**39 * power
        # With the lowest byte of r; what its power is beyond the linear part is below 2^-24.
        last = numpy.arange(256)
        for slope in numpy.unique(m.registers[SLOPE]):
            here = m.registers[SLOPE] == slope
            fall = slope.astype(numpy.int64) * last >> 8
            found.append((error[here].min() + (last / 2 * power[here].min() - fall).min() - 0.01,
                          error[here].max() + (last / 2 * power[here].max() - fall).max() + 0.01))
    return check


def errors_of_run(program, interval):
    """The lowest and the highest error of the mantissa in an interval, by running the cubic."""
    found, cases = [], [(interval, part) for part in range(1 << 24 - RUN_BITS)]
    program.whole.flash = program.flash
    program.whole.prove(CUBIC, partial(every_t, found), (".Lend",), (), cases, (None,))
    lowest, highest = zip(*found)
    return min(lowest), max(highest)


def bound(program):
    """The error of a power, in ulp."""
    errors, logarithm = mantissa_errors(program), logarithm_errors(program)
    x = numpy.arange(-24 << 8, 46 << 8)
    k = ((x >> 8) * 185 + ((x & 255) * 185 >> 8) + 128 * (OFFSET + 1) + 9 >> 7) - OFFSET
    # Beyond this, a power is below 2^-9 ulp or saturates.
    inside = (k + 9 + 16 >= 0) & (k + 9 + 16 < 42)
    x, k = x[inside], k[inside]
    rest = k * LN2_40 - ((x + 1) << 32) + 1, k * LN2_40 - (x << 32)
    demand((rest[0] >= 0).all())
    intervals = rest[0] >> 32, rest[1] >> 32
    demand((intervals[1] < INTERVALS).all() and (intervals[1] - intervals[0] <= 1).all())
    # From here on a power saturates, since its error is less than its distance beyond the limit.
    finite = x / 256 < FROM + 2.0**-20
    largest = numpy.minimum(2.0**16 * numpy.exp((x + 1) / 256), 2.0**31 * (1 + 2.0**-19))
    # A positive exponent errs in the direction of its logarithm; a negative one may err in either.
    down, up = (numpy.where(x < 0, max(-logarithm[0], logarithm[1]), each) for each in (-logarithm[0], logarithm[1]))
    # k ln 2 is too large by this, and the power too small in proportion.
    of_ln2 = k * float(LN2_40 - mp.log(2) * 2**40) / 2**40
    down, up = ((each * numpy.minimum(abs(x / 256) + 1 / 256, FROM + 2.0**-20) + 2.0**-41 + abs(of_ln2) / 1000) * 1.001 + more
                for each, more in ((down, of_ln2), (up, -of_ln2)))
    unit = 2.0**(16 + k - 39)

    def total(of):
        # exp_wide truncates to a 256th of an ulp.
        return numpy.where(finite, 0.5 + numpy.maximum(2.0**-8 - unit * errors[0][of] + down * largest,
                                                       unit * errors[1][of] + up * largest), 0)

    totals = [total(of) for of in intervals]
    if max(each.max() for each in totals) < WIDEST:
        for interval in sorted({int(i) for of, each in zip(intervals, totals) for i in of[each >= BOUND]}):
            errors[0][interval], errors[1][interval] = errors_of_run(program, interval)
    return float(max(total(of).max() for of in intervals))


class Powers(Core):
    table = TABLE, INTERVALS


def unnoticed(program, places, is_bounded):
    """The places in the program's tables whose byte may change by 1 without the proof failing."""
    flash, found = program.flash, []
    for place in places:
        program.flash = flash[:place] + bytes([flash[place] ^ 1]) + flash[place + 1:]
        try:
            found += [place] if is_bounded(program) else []
        except Unprovable:
            pass
    program.flash = flash
    return found


def entries(program):
    """Bytes of the tables of which 1 is 2^-31 or 2^-40."""
    exp, logarithm = (program.labels[name] for name in (TABLE, NODE.format("9logarithm")))
    return (*(exp + RECORD * i + byte for i in (40, 70, 180) for byte in (0, 1, 4, 8)), logarithm + 8 * 2 + 2)


CALLED = {LOG: ([A32], 8), LONG_PRODUCT: ([A64, B64], 8), EXP: ([A64, (16, 1)], 8), SHORT_PRODUCT: ([A32, B32], 4),
          WIDE_PRODUCT: ([A32, B32], 8), FULL_PRODUCT: ([A64, B64], 8), LOAD: ([(24, 2)], 8), CONVERT: ([A32], 4)}
ANY = ((),)
STRETCHES = [*((POW.format(name), partial(pow_of, size), (None,), (), ANY, (None,)) for name, size in (("q16_16", 4), ("q8_8", 2))),
             (CONVERT, converted, (None,), (), ANY, (None,)),
             *((name, partial(sum_of, name), (None,), (), ANY, (None,)) for name in SUMS),
             (LOG, begun, (NEXT,), (), ANY, (None,)),
             (NEXT, doubled, (NEXT, OUT), EVERY_SAVED, ANY, (None,)),
             (OUT, distance, (None,), EVERY_SAVED, ANY, (None,)),
             (EXP, octave, (OCTAVE, None), (), ANY, (None,)),
             (OCTAVE, exponential, (SCALE, None), (), ANY, (None,)),
             (SCALE, scaled, (None,), (), [(i,) for i in range(42)], (None,)),
             (CUBIC, bent, (".Lfall",), (), ANY, (None,)),
             (".Lfall", None, (), ())]
CUTS = ((NEXT, LOG, "sbrc", "r21"), (OUT, NEXT, "mov", "r24"), (".Lproduct", EXP, "ldi", "r27"),
        (OCTAVE, ".Lproduct", "ldi", "r31"), (".Lmantissa", EXP, "pop", "r0"), (SCALE, ".Lmantissa", "ldi", "r20"),
        (".Lfall", CUBIC, "mul", "r23"))


def counted(program, labels):
    """Proves stretches of compiled code. Returns the number of their instructions, and which may be left out."""
    count, found = 0, []
    for stretch in (each for each in program.stretches if each[0] in labels):
        visited = program.prove(*stretch)
        print(f"{stretch[0]}: proven", flush=True)
        count += len(visited)
        found += program.survivors(stretch, visited, EVERY, ("ret", "rjmp", *FRAME))
    return count, found


def main():
    folder, failed, count, needless = Path(sys.argv[1]), False, 0, []
    mp.prec = 100

    def program(number_format, machine, labels):
        stretches = [each for each in STRETCHES if each[0] in (*labels, NEXT, OUT, OCTAVE, SCALE, ".Lfall")]
        return Powers(stretches, machine, elf=folder / f"{number_format}_powers.elf", cuts=CUTS)

    for number_format, machine, labels in (("q8_8", Compiled, (POW.format("q8_8"), CONVERT)),
                                           ("q16_16", Compiled, (POW.format("q16_16"), *SUMS)),
                                           ("q16_16", Logarithm, (LOG, NEXT, OUT))):
        visited, found = counted(program(number_format, partial(machine, CALLED), labels), labels)
        count, needless = count + visited, needless + found
    # Compiled code contains instructions that change nothing.
    print(f"of {count} compiled instructions one in {EVERY} was left out, without effect {needless}")
    failed |= 3 * EVERY * len(needless) > count
    for machine, every, labels in ((partial(Exponential, CALLED), 40, (EXP, OCTAVE, SCALE)), (Rows, 4, (CUBIC,))):
        last = program("q16_16", machine, labels)
        last.whole = Powers([(CUBIC, None, (), ()), (".Lend", None, (), ())], Rows, elf=folder / "q16_16_powers.elf",
                            cuts=((".Lend", CUBIC, "ret", ""),))
        failed |= last.run(every, ("ret", "rjmp"), labels)
    found, places = bound(last), unnoticed(last, entries(last), lambda program: bound(program) < BOUND)
    print(f"pow_q16_16_default: errs by less than {found:.6f} ulp, of at most {BOUND}; pow_q8_8_default: by less than "
          f"{0.5 + found / 256:.6f}; bytes of the tables that could be another: {places}")
    return failed or found >= BOUND or places != []


if __name__ == "__main__":
    sys.exit(main())
