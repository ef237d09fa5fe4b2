#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Proves that atan2 of CorrectlyRounded is correctly rounded in Q16.16 for all pairs of operands, from the machine code that is
measured.

usage: prove_nearest_angles.py FOLDER    the folder of the device programs

The kernel first computes the angle with the 32-bit core; less than DOUBT units of 2^-31 from a tie, the compiled code decides:

    octant       the smaller magnitude and the larger one, n and d, and what has been folded             by bits
    ratio        2^32 n / d, less up to RATIO_REST, by the digits that prove_angles_32 proves            by linear forms
    core         V + t (S - t (b + w t2 / 256)) with all parts in units of 2^-31                         by running it, by linear forms
    unfold       the angle of the octant, rounded, if the sum is not in doubt                            by bits
    decided      in doubt: compares the direction with one that depends only on tie and octant           by bits
    ties         for each of the 205,887 ties, this direction is between the two fractions with
                 denominators up to 2^31 that are closest to the tie, from below and from above          by running it

So no direction of two operands is between the tie and what it is compared with. The fractions are found exactly, by continued
fractions. What the decision compares is a fraction of 128-bit numbers, multiplied out: it is monotonic. No tie is within 2^-21
of a multiple of pi/4: directions in doubt are in the octant of their tie.

Then instructions are left out in turn, and each time the proof must fail; for compiled code, it may succeed without a third of
them.
"""
import sys
from functools import partial
from pathlib import Path

import numpy
import z3
from mpmath import mp, mpf

from calling import FRAME, Bits, machine_code, shown
from arrays import Arrays
from framed import STACK, Framed, pointed
from machine_code import Program, Unprovable, demand
from form import Form
from prove_angles_32 import (ARCTANGENT, FOURTH, LOST, RECORD, Core, Ratio, Rows, arc_tangent, differences, digit, dividend, reciprocal,
                             rows, scaled)
from prove_quotients import check_table
from stretches import Linear, equal, zeros

machine_code.STEPS = 6000
TIMEOUT = 60000  # milliseconds of a question to z3
DECIDED = "_ZN10fixedpoint6kernel13decided_atan2IlLi16EEET_S2_S2_S2_"
SCALED = "_ZN10fixedpoint6kernel18shorter_and_longerEmm"
UPPER, WORDS = "_ZN10fixedpoint6kernel19exact_upper_productEyy", "fixedpoint_multiply_words"
ADD, SUBTRACT = "__adddi3", "__subdi3"
# Of the products that the decision calls, those by these; and how many there are, with those of the angle.
ALONG, ACROSS, SLOPE, REST, CALLS = 4, 5, 8, 10, 11
TABLE = "_ZN10fixedpoint8portable20CorrectRoundingTableIvE{}E"
LOAD = "_ZN10fixedpoint19read_program_memoryIyEET_RKS1_"
A32, B32, A64, B64, ABOVE = (22, 4), (18, 4), (18, 8), (10, 8), (14, 4)


# The decision


class Decision(Framed):
    """Sums are calls. Where `brcc` skips a carry, both ways are joined."""

    def step(self, address):
        mnemonic, _, target, following = self.program.code[address]
        if mnemonic == "call" and target in self.sums:
            name = ADD if target == self.program.labels[ADD] else SUBTRACT
            total = z3.BitVec(f"{name}.{len(self.calls)}", 64)
            self.calls.append((name, [self.number(*A64), self.number(*B64)], total))
            self.place(18, *(z3.Extract(8 * i + 7, 8 * i, total) for i in range(8)))
            self.flags = {}
            return [(following, self)]
        found = super().step(address)
        if len(found) == 1 or self.program.code[address][0] != "brcc":
            return found
        (target, skipped), (at, other) = found
        while at != target:
            other.visited.append(at)
            (at, other), = other.step(at)
        carried = skipped.holds[-1]
        demand(skipped.calls == other.calls and skipped.stack == other.stack)
        for mine, others in ((skipped.registers, other.registers), (skipped.bytes, other.bytes)):
            demand(mine.keys() == others.keys())
            for place, byte in mine.items():
                mine[place] = byte if byte.eq(others[place]) else z3.If(carried, byte, others[place])
        skipped.holds, skipped.flags, skipped.visited = self.holds[:], {}, other.visited
        return [(target, skipped)]

    def compute(self, mnemonic, d, r, target, following):
        if mnemonic == "lpm":
            # Whatever it is.
            place = self.number(30, 2)
            self.registers[d] = z3.BitVec(f"lpm.{len(self.calls)}.r", 8)
            self.calls.append(("lpm", [place], self.registers[d]))
            if r == "Z+":
                self.place(30, z3.simplify(z3.Extract(7, 0, place + 1)), z3.simplify(z3.Extract(15, 8, place + 1)))
            return [(following, self)]
        return super().compute(mnemonic, d, r, target, following)


SEEN = {}  # keeps the expressions, too, so that their numbers stay theirs


def variables(expression):
    """The names of the variables in an expression."""
    key = expression.get_id()
    if key not in SEEN:
        if z3.is_const(expression):
            found = {str(expression)} if expression.decl().kind() == z3.Z3_OP_UNINTERPRETED else set()
        else:
            found = set().union(*(variables(part) for part in expression.children()))
        SEEN[key] = found, expression
    return SEEN[key][0]


def follows_from_tie(m, *expressions):
    """Whether numbers depend on nothing but the tie, and the octant of the path."""
    names = set().union(*map(variables, expressions))
    done = set()
    while names - done:
        name = (names - done).pop()
        done.add(name)
        if name in ("r14", "r15", "r16", "r17"):
            continue
        kind, *call = name.split(".")
        demand(call and kind != SCALED, f"{name} is not of the tie")
        names = names.union(*map(variables, m.calls[int(call[0])][1]))


def same(given, one, other):
    return z3.Or(z3.And(given[0] == one, given[1] == other), z3.And(given[0] == other, given[1] == one))


def parts(number):
    """The bytes of a number."""
    return [number] if number.size() == 8 else [byte for part in number.children() for byte in parts(part)]


def equals(number, other, *given):
    """Without what else the path knows, which would take long."""
    solver = z3.SolverFor("QF_BV")
    solver.add(*given, number != other)
    return solver.check() == z3.unsat


def decided(m):
    y, x, above = m.number(*A32), m.number(*B32), m.number(*ABOVE)

    def check(m, _):
        coordinates, = [(given, result) for name, given, result in m.calls if name == SCALED]
        signs = m.holds[:2]
        demand(all(equals(magnitude, z3.If(number < 0, -number, number), *signs)
                   for number, magnitude in zip((y, x), coordinates[0])))
        steep, left = z3.UGT(*coordinates[0]), x < 0
        shorter, longer = z3.Extract(63, 32, coordinates[1]), z3.Extract(31, 0, coordinates[1])
        _, *words = [(given, result) for name, given, result in m.calls if name == WORDS]
        *_, fall = [(given, result) for name, given, result in m.calls if name == UPPER]
        (one, other, third, fourth, first, second) = words
        along, across = one[0][1], other[0][1]
        slope, rest = first[0][1], fall[0][1]
        follows_from_tie(m, along, across, slope, rest)
        names, sums = zip(*[(name, (given, result)) for name, given, result in m.calls if name in (ADD, SUBTRACT)][-5:])
        demand(names == (ADD, SUBTRACT, ADD, ADD, SUBTRACT))
        (of_x, turned_x), (of_y, turned_y), (of_rest, rest_sum), (of_slope, at_tie), (last, difference) = sums
        shown(m, one[0][0] == longer, other[0][0] == shorter, third[0][0] == shorter, fourth[0][0] == longer,
              third[0][1] == along, fourth[0][1] == across, second[0][1] == slope,
              same(of_x, one[1], other[1]), of_y[0] == third[1], of_y[1] == fourth[1],
              first[0][0] == z3.Extract(63, 32, turned_x), second[0][0] == z3.Extract(31, 0, turned_x), fall[0][0] == turned_x,
              same(of_rest, second[1], fall[1]), same(of_slope, first[1], z3.LShR(rest_sum, 32)),
              last[0] == at_tie, last[1] == turned_y)
        exceeded = difference < 0
        reached = z3.Xor(z3.Xor(exceeded, steep), left)
        # The magnitudes are whatever they are: their bytes become variables.
        bytes_of = [(byte, z3.FreshConst(z3.BitVecSort(8))) for given in coordinates[0] for byte in parts(given)]

        def known(condition):
            solver = z3.SolverFor("QF_BV")
            solver.add(*(z3.substitute(each, *bytes_of) for each in (*m.holds, z3.Not(condition))))
            return solver.check() == z3.unsat
        is_reached, negative = known(reached), known(y < 0)
        demand((is_reached or known(z3.Not(reached))) and (negative or known(y >= 0)))
        nearest = above if is_reached else above - 1
        demand(equals(m.number(*A32), -nearest if negative else nearest))
    return check


# The tie


class Runs(Arrays):
    """Runs compiled code. `given` has the second operands of the products that it calls, in turn."""

    def __init__(self, program):
        super().__init__(program)
        self.registers[1] = 0
        self.bytes, self.calls = {}, 0
        # The stack pointer, as it is without what is pushed, which is in `stack`.
        self.pointer = {"0x3d": STACK & 255, "0x3e": STACK >> 8}

    def copy(self):
        other = super().copy()
        other.bytes = self.bytes.copy()
        return other

    def of(self, cases):
        other = super().of(cases)

        def part(byte):
            return byte[cases] if isinstance(byte, numpy.ndarray) else byte
        other.bytes = {place: part(byte) for place, byte in self.bytes.items()}
        other.stack = [(part(item[0]),) if isinstance(item, tuple) else item for item in self.stack]
        return other

    def step(self, address):
        mnemonic, operands, target, following = self.program.code[address]
        if mnemonic == "push":
            self.stack.append((self.registers[int(operands[0][1:])],))
            return [(following, self)]
        if mnemonic == "pop":
            demand(self.stack and isinstance(self.stack[-1], tuple), "the stack does not balance")
            self.registers[int(operands[0][1:])], = self.stack.pop()
            return [(following, self)]
        names = {self.program.labels[name]: places for name, places in ((WORDS, range(18, 22)), (UPPER, range(10, 18)))}
        if mnemonic == "call" and target in names and not any(isinstance(item, int) for item in self.stack):
            self.given = self.given | {f"{self.calls}.{i}": self.registers[n] + 0 * self.given["tie"]
                                       for i, n in enumerate(names[target])}
            self.calls += 1
        try:
            return super().step(address)
        except (KeyError, TypeError, ValueError, IndexError) as reason:
            raise Unprovable("something is read before it is set") from reason

    def compute(self, mnemonic, d, r, target, following):
        registers, advance = self.registers, [(following, self)]
        if mnemonic == "in":
            registers[d] = self.pointer[r] if r in self.pointer else 0
        elif mnemonic in ("adiw", "sbiw"):
            value = registers[d] + 256 * registers[d + 1] + (int(r, 0) if mnemonic == "adiw" else -int(r, 0))
            registers[d], registers[d + 1], self.carry = value & 255, value >> 8 & 255, value >> 16 & 1
            self.tested = self.sign = None
        elif mnemonic in ("st", "std", "ld", "ldd"):
            low, before, after, offset = pointed(d if mnemonic.startswith("st") else r)
            place = registers[low] + 256 * registers[low + 1] + before
            if mnemonic.startswith("st"):
                self.bytes[place + offset] = registers[r]
            else:
                registers[d] = self.bytes[place + offset]
            registers[low], registers[low + 1] = place + after & 255, place + after >> 8
        elif mnemonic == "lpm":
            super().compute(mnemonic, d, "Z", target, following)
            if r == "Z+":
                place = registers[30] + 256 * registers[31] + 1
                registers[30], registers[31] = place & 255, place >> 8
        elif mnemonic == "asr":
            self.carry, value = registers[d] & 1, registers[d] >> 1 | registers[d] & 128
            self.keep(d, value)
        elif mnemonic == "cpse":
            return self.fork(self.program.code[following][3], following, registers[d] == registers[r])
        elif mnemonic == "out":
            self.pointer = self.pointer | ({d: registers[r]} if d in self.pointer else {})
        elif mnemonic != "cli":
            return super().compute(mnemonic, d, r, target, following)
        return advance


WIDE = 320  # bits of sines and cosines
TIES = 411775  # pi, in units of 2^-17


def neighbours(numerator, denominator):
    """The fractions with denominators up to 2^31 next to a number in (0, 1), below and above it."""
    a, b, c, d = 0, 1, 1, 1
    while True:
        up, rest = denominator * c - numerator * d, numerator * b - denominator * a
        k = min(rest // up, ((1 << 31) - b) // d)
        a, b, rest = a + k * c, b + k * d, rest - k * up
        if b + d > 1 << 31:
            return (a, b), (c, d)
        k = min(up // rest, ((1 << 31) - d) // b)
        c, d, up = c + k * a, d + k * b, up - k * rest
        if b + d > 1 << 31:
            return (a, b), (c, d)


def ties():
    """For each tie the octant and the directions next to it."""
    found = []
    with mp.workprec(WIDE + 40):
        cosine, sine, cos1, sin1 = (int(mp.nint(f(mpf(1) / unit) * 2**WIDE)) for unit in (1 << 17, 1 << 16) for f in (mp.cos, mp.sin))
    # Directions in doubt are in the octant of their tie.
    for k in (1, 2, 3, 4):
        quarter = k * mp.pi / 4 * 2**16 - mpf(1) / 2
        demand(abs(quarter - mp.nint(quarter)) / 2**16 > 2.0**-21)
    # Each step errs by a few units of the last place.
    for tie in range(1, TIES, 2):
        low, high = sorted((abs(cosine), sine))
        found.append((sine > abs(cosine), cosine < 0, *neighbours(low, high)))
        cosine, sine = cosine * cos1 - sine * sin1 >> WIDE, sine * cos1 + cosine * sin1 >> WIDE
    return found


def at_ties(all_ties, m):
    """Each tie, for a direction next to it."""
    indices = numpy.arange(0, len(all_ties), m.program.stride)
    chosen = [all_ties[i] for i in indices]
    coordinates = []
    for steep, left, (p, q), _ in chosen:
        scale = (1 << 31) - 1 >> q.bit_length()
        scale = 1 << scale.bit_length() if q < 1 << 30 else 1
        p, q = p * scale, q * scale
        y, x = (q, p) if steep else (p, q)
        coordinates.append((y, -x if left else x))
    y, x = (numpy.array(numbers, dtype=numpy.int64) for numbers in zip(*coordinates))
    m.given["tie"] = indices
    m.place(y & 0xffffffff, range(22, 26))
    m.place(x & 0xffffffff, range(18, 22))
    m.place(indices + 1, range(14, 18))

    def check(m, _):
        def operand(call, size):
            return sum(m.given[f"{call}.{i}"].astype(object) << 8 * i for i in range(size))
        demand(m.calls == CALLS)
        for n in range(14, 18):
            demand((m.registers[n] == m.given["tie"] + 1 >> 8 * (n - 14) & 255).all())
            m.saved[n] = m.registers[n] = n
        along, across, slope, rest = operand(ALONG, 4), operand(ACROSS, 4), operand(SLOPE, 4), operand(REST, 8)
        demand((along <= 1 << 28).all() and (across <= 9 << 25).all() and (slope < 1 << 22).all() and (along >= 15 << 24).all())
        tangent = (slope << 64) + rest
        # The direction that the others are compared with.
        numerator, denominator = (across << 96) + along * tangent, (along << 96) - across * tangent
        for i, n, d in zip(m.given["tie"], numerator, denominator):
            _, _, (a, b), (c, e) = all_ties[i]
            demand(a * d <= n * b and n * e < c * d, f"next to {2 * i + 1} / 2^17")
    return check


# Called by the decision


def longer(m):
    a, b = m.number(*A32), m.number(*B32)
    m.holds.append(z3.Or(a != 0, b != 0))

    def check(m, _):
        high, low = m.number(*A32), m.number(*B32)
        less, more = z3.If(z3.UGT(a, b), b, a), z3.If(z3.UGT(a, b), a, b)
        shown(m, z3.Or(*(z3.And(low == more << k, high == less << k, z3.LShR(low, k) == more) for k in range(32))), low < 0)
    return check


def upper_product(m):
    a, b = m.number(*A64), m.number(*B64)

    def check(m, _):
        demand([name for name, *_ in m.calls] == [WORDS, WORDS, ADD, WORDS, ADD, WORDS, ADD, ADD])
        upper_lower, lowest, one, lower_upper, other, highest, carries, total = ((given, result) for _, given, result in m.calls)
        (a0, b0), (a1, b1) = ([z3.Extract(high, high - 31, number) for number in (a, b)] for high in (31, 63))
        for call, wanted in ((upper_lower, (a1, b0)), (lowest, (a0, b0)), (lower_upper, (a0, b1)), (highest, (a1, b1))):
            shown(m, same(call[0], *wanted))
        upper = partial(z3.LShR, b=32)
        shown(m, same(one[0], upper_lower[1], upper(lowest[1])), same(other[0], lower_upper[1], one[1] & (1 << 32) - 1),
              same(carries[0], upper(one[1]), upper(other[1])), same(total[0], carries[1], highest[1]), m.number(*A64) == total[1])
    return check


def word_product(m):
    m.zero(1)
    product = m.times(m.number(range(22, 26)), m.number(range(18, 22)))

    def check(m, _):
        m.show(equal(m.number(range(18, 26)), product))
    return check


# The kernel


ATAN2, RATIO, POWER, INDEX, SCALE, ROUGH = "atan2_q16_16_correctly_rounded", ".Lratio", ".Lpower", ".Lindex", ".Lscale", ".Lrough"
LOOK_UP, BENT, SLOPE_READ, RISE, UNFOLD = ".Llook_up", ".Lbent", ".Lslope", ".Lrise", ".Lunfold"
DIGITS = (25, 24, 23)
# On the stack: the operands and the octant, and what the ratio pushes.
OPERANDS = (*range(18, 26), 30)
PUSHED = (*OPERANDS, 14, 15, 16, 17, 28, 29)
T = (18, 19, 20)
LOST_FALL = 2 * 255 * 2**16 + 2 * 255**2 * 2**8 + 255**2
HALF_PI, PI, DOUBT = 3373259426, 6746518852, 10  # in units of 2^-31
LARGEST = 0x64880000  # above pi/4


def on_stack(base, unknown):
    class Kept(base):
        def __init__(self, *arguments):
            super().__init__(*arguments)
            self.saved = self.saved | {n: unknown(self, n) for n in OPERANDS}
    return Kept


class Kernel(Framed):
    looked_up = 256

    def compute(self, mnemonic, d, r, target, following):
        return Bits.compute(self, mnemonic, d, r, target, following)


def entry(m):
    y, x = m.number(*A32), m.number(*B32)
    m.saved |= {n: m.registers[n] for n in OPERANDS[:-1]}
    height, width = (z3.If(number < 0, -number, number) for number in (y, x))
    steep, left = z3.UGT(height, width), x < 0

    def check(m, end):
        if end is None:
            shown(m, y == 0, x == 0, m.number(*A32) == 0)
            return
        demand(len(m.stack) == len(OPERANDS), "the stack does not balance")
        m.saved[30] = octant = m.stack[-1]
        shown(m, octant == z3.If(steep, z3.BitVecVal(1, 8), z3.BitVecVal(0, 8)) + z3.If(left, z3.BitVecVal(2, 8), z3.BitVecVal(0, 8)),
              m.flags["T"] == (y < 0))
        if end == RATIO:
            shown(m, height != width, m.number(*A32) == z3.If(steep, width, height), m.number(*B32) == z3.If(steep, height, width))
        else:
            shown(m, height == width, y != 0, m.number(*A32) == (1 << 32) - 1)
    return check


def popped(m):
    kept = {n: m.registers[n] for n in range(22, 26)}

    def check(m, _):
        demand(m.transfer is None and all(m.registers[n] is form for n, form in kept.items()))
    return check


def bent(m):
    i, t2 = (part.ravel() for part in numpy.meshgrid(numpy.arange(256), numpy.arange(256)))
    m.place(i, (25,))
    m.place(t2, (24,))
    _, slope, bend, twist = rows(m.program)
    wanted, place = bend[i] + (twist[i] * t2 >> 8), m.program.labels[ARCTANGENT] + RECORD * i + 3

    def check(m, _):
        demand(m.transfer is None and (m.registers[18], m.registers[19]) == ("r22", "r23") and (m.number((20,)) == t2).all())
        demand(m.is_zero(21) and (m.number((24, 25)) == wanted).all() and (m.number((30, 31)) == place).all())
        demand((wanted >= 0).all() and (wanted < slope[i] >> 8).all())
    return check


class Cubic(Linear):
    """Takes the bytes of the record one after the other, whatever their values."""

    def read(self, size):
        record = [self.variable("record") for _ in range(size)]
        self.record = iter(record)
        return sum((byte * (1 << 8 * i) for i, byte in enumerate(record[1:])), Form())

    def compute(self, mnemonic, d, r, target, following):
        if mnemonic == "lpm" and r == "Z+":
            self.registers[d] = next(self.record)
            return [(following, self)]
        if mnemonic == "adiw" and d == 30:
            demand(r == "0x01")
            next(self.record)
            return [(following, self)]
        return super().compute(mnemonic, d, r, target, following)


def fall(m):
    product, t = m.times(m.number((24, 25)), m.number(T)), m.number(T)
    place = m.registers[30], m.registers[31]
    m.zero(21)

    def check(m, _):
        demand(m.transfer is None and place == (m.registers[30], m.registers[31]))
        m.show((0, product - m.number((22, 23)) * (1 << 24), LOST_FALL), equal(m.number(T), t), *zeros(m, (21,)))
    return check


def slope_read(m):
    fall, t, place = m.number((22, 23)), m.number(T), (m.registers[30], m.registers[31])
    m.zero(21)
    slope = m.read(4)
    following = m.variable("record")
    m.record = iter([*m.record, following])
    # As `bent` shows.
    m.hold(0, slope - fall)

    def check(m, _):
        demand(m.transfer is None and place == (m.registers[30], m.registers[31]) and next(m.record, None) is None)
        m.show(equal(m.number((24, 25, 26)), slope - fall), equal(m.number(T), t), *zeros(m, (21,)))
    return check


def risen(m):
    slope, t = m.number((24, 25, 26)), m.number(T)
    m.zero(21)
    value = m.read(5)
    next(m.record)
    # As `core_errors` asks of the table; and t is below 2^24.
    m.hold(None, value + slope, (1 << 32) - 1)
    product = m.times(slope, t)
    m.hold(0, slope * (1 << 24) - product)

    def check(m, _):
        demand(m.transfer is None and next(m.record, None) is None)
        m.show((0, product - (m.number(range(22, 26)) - value) * (1 << 24), LOST))
    return check


def unfolded(m, octant):
    angle, m.flags["T"] = m.number(*A32), z3.Bool("below")
    m.stack[-1] = m.saved[30] = z3.BitVecVal(octant, 8)
    y, x = (z3.Concat(*(m.saved[n] for n in reversed(range(low, low + 4)))) for low in (22, 18))
    m.registers[1] = z3.BitVec("r1", 8)
    m.holds.append(z3.ULT(angle, LARGEST))
    wide = z3.ZeroExt(8, angle)
    whole = (wide + 1, HALF_PI - 1 - wide, PI - 1 - wide, HALF_PI + 1 + wide)[octant] + (1 << 14) + DOUBT
    above, in_doubt = z3.Extract(31, 0, z3.LShR(whole, 15)), z3.ULT(whole & 0x7fff, 2 * DOUBT)

    def check(m, _):
        result = m.number(*A32)
        if m.calls:
            (name, given, nearest), = m.calls
            demand(name == DECIDED)
            shown(m, in_doubt, given[0] == y, given[1] == x, given[2] == above, result == nearest)
        else:
            shown(m, z3.Not(in_doubt), result == z3.If(z3.Bool("below"), -above, above))
    return check


def core_errors(program):
    """The lowest and the highest error of the angle in the first octant, in units of 2^-31."""
    value, slope, _, twist = (part.astype(float)[:, None] for part in rows(program))
    demand((value / 256 + slope / 256 < 2.0**32).all())
    difference, beyond = differences(program, arc_tangent, FOURTH)
    pieces = difference.shape[1]
    t = numpy.arange(1, pieces + 1)[None, :] / pieces
    steepest = 1 / (1 + (numpy.arange(256)[:, None] / 256)**2)
    # Value and slope are cut to 2^-31; bend + twist t2 / 256 is rounded downward, and t2 / 256 is up to a 256th below t.
    low = (difference - beyond) / 256 - 1 - t + t * t * numpy.minimum(twist, 0) / 256 - LOST / 2**24 - RATIO_REST / 2 * steepest
    high = (difference + beyond) / 256 + t * t * (numpy.maximum(twist, 0) / 256 + 1) + t * LOST_FALL / 2**24
    return float(low.min()), float(high.max())


# In units of 2^-32: x 2^8 / D - floor(x / 2^32) for x < 2^40 and D >= 2^40 - 2^32.
RATIO_REST = 1 + 256 / 255


def sum_errors(program):
    """Of the angle in any octant."""
    low, high = core_errors(program)
    found = []
    for constant, exact in ((1, mpf(0)), (HALF_PI + 1, mp.pi / 2)):
        found += [low + float(constant - exact * 2**31), high + float(constant - exact * 2**31)]
    for constant, exact in ((HALF_PI - 1, mp.pi / 2), (PI - 1, mp.pi)):
        found += [float(constant - exact * 2**31) - high, float(constant - exact * 2**31) - low]
    return min(found), max(found)


def main():
    folder, failed = Path(sys.argv[1]), False
    elf = folder / "correctly_rounded_angles.elf"
    mp.prec = 100
    z3.set_param("timeout", TIMEOUT)
    any_case = ((),)
    kernel = [(ATAN2, entry, (RATIO, LOOK_UP, None), (), any_case, (None,)),
              (RATIO, scaled, (INDEX,), OPERANDS, any_case, (None,)),
              (INDEX, reciprocal, (SCALE,), PUSHED, any_case, (None,)),
              (SCALE, dividend, (f".Ldigit{DIGITS[0]}",), PUSHED, any_case, (None,)),
              *((f".Ldigit{q}", partial(digit, q), (f".Ldigit{q - 1}" if q > 23 else ROUGH,), PUSHED, any_case, (None,)) for q in DIGITS),
              (ROUGH, popped, (LOOK_UP,), PUSHED, any_case, (None,)),
              (LOOK_UP, bent, (BENT,), OPERANDS, any_case, (None,)),
              (BENT, fall, (SLOPE_READ,), OPERANDS, any_case, (None,)),
              (SLOPE_READ, slope_read, (RISE,), OPERANDS, any_case, (None,)),
              (RISE, risen, (UNFOLD,), OPERANDS, any_case, (None,)),
              (UNFOLD, unfolded, (None,), OPERANDS, [(octant,) for octant in range(4)], (None,))]
    cuts = ((RATIO, ATAN2, "push", "r14"), (POWER, RATIO, "lpm", "r17"), (INDEX, POWER, "mov", "r30"), (SCALE, INDEX, "mov", "r27"),
            (".Ldigit25", SCALE, "mul", "r28"), *((f".Ldigit{q}", f".Ldigit{q + 1}", "mul", f"r{q}") for q in DIGITS[1:]),
            (ROUGH, ".Ldigit23", "pop", "r29"), (LOOK_UP, ROUGH, "mov", "r30"), (BENT, LOOK_UP, "mul", "r25"),
            (SLOPE_READ, BENT, "adiw", "r30"), (RISE, SLOPE_READ, "mul", "r24"), (UNFOLD, RISE, "eor", "r26"))
    bits = partial(on_stack(Kernel, lambda _, n: z3.BitVec(f"stack.{n}", 8)), {DECIDED: ([A32, B32, ABOVE], 4)})
    linear = [on_stack(base, lambda machine, _: machine.variable("stack")) for base in (Ratio, Cubic)]
    arrays = on_stack(Rows, lambda _, n: f"stack{n}")
    for machine, every, labels in ((bits, 12, (ATAN2, RATIO, UNFOLD)),
                                   (linear[0], 12, (INDEX, SCALE, *(f".Ldigit{q}" for q in DIGITS), ROUGH)),
                                   (arrays, 4, (LOOK_UP,)), (linear[1], 8, (BENT, SLOPE_READ, RISE))):
        program = Core(kernel, machine, elf=elf, cuts=cuts)
        if machine is linear[0]:
            check_table(program)
        failed |= program.run(every, ("ret", "rjmp"), labels)
    found = sum_errors(program)
    print(f"{ATAN2}: the sum errs by {found[0]:.3f} to {found[1]:.3f}, by less than {DOUBT}, in units of 2^-31")
    failed |= not -DOUBT < found[0] <= found[1] < DOUBT

    count, needless, called = 0, [], {UPPER: ([A64, B64], 8), WORDS: ([A32, B32], 8), LOAD: ([(24, 2)], 8)}
    directions = ties()
    for machine, every, stretch in (
            (partial(Decision, called), 40, (SCALED, longer, (None,), (), any_case, (None,))),
            (partial(Decision, called), 40, (UPPER, upper_product, (None,), (), any_case, (None,))),
            (Linear, 40, (WORDS, word_product, (None,), (), any_case, (None,))),
            (partial(Decision, called | {SCALED: ([A32, B32], 8)}), 250, (DECIDED, decided, (None,), (), any_case, (None,))),
            (Runs, 300, (DECIDED, partial(at_ties, directions), (None,), (), any_case, (None,)))):
        program = Program([stretch], machine, elf=elf)
        visited = program.prove(*stretch)
        print(f"{stretch[0]}: proven", flush=True)
        count += len(visited) // every
        # What z3 does not decide soon is not proven.
        z3.set_param("timeout", 1000)
        needless += program.survivors(stretch, visited, every, ("ret", "rjmp", *FRAME))
        z3.set_param("timeout", TIMEOUT)
    # A change of the tables by 2^-64 is noticed.
    program.stride = 10
    for table, index in (("6coarse", 16), ("4fine", 40)):
        flash, place = program.flash, program.labels[TABLE.format(table)] + 8 * index
        program.flash = flash[:place] + bytes([flash[place] ^ 1]) + flash[place + 1:]
        try:
            program.prove(*stretch)
            needless.append(f"{table}[{index}]")
            failed = True
        except Unprovable as reason:
            print(f"{table}[{index}] changed by one unit: {reason}")
        program.flash = flash
    # Compiled code contains instructions that change nothing.
    print(f"of {count} instructions that were left out, without effect {needless}")
    failed |= 3 * len(needless) > count
    return failed


if __name__ == "__main__":
    sys.exit(main())
