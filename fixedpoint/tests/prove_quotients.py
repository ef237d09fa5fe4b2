#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Proves that fixedpoint_divide_q16_16 returns the quotient rounded to nearest, ties upward, clamped,
for all pairs of operands, from its instructions and its table.

usage: prove_quotients.py

The code is cut at its labels. Of the stretch behind each, every path is followed with the registers
holding linear forms of bytes, of products of two bytes and of carries. Where the registers at a cut
hold what is said of it here, they hold at the next what is said there: a statement of linear
inequalities, which z3 decides over the rationals once it knows which carries must be 0, and which
must be 1. In the order of the code:

    magnitudes            n = |a|, d = |b|, T: the signs differ
    short, medium, long   n < 2^15 d where d < 2^16; n / d is as before
    index                 y = p d
    scale                 D = V y = 2^k - E, 0 < E < 2^(k-8); so w = p V has d w = D
    digit                 x = n w at the first; at each, n w 2^16 = (the digits above) D + x, scaled
    return                n w 2^16 / D = n 2^16 / d differs from the result by 1/2 at most

A tie n 2^16 / d - 1/2 = an integer needs d divisible by 2^17, thus not a short one. Nor does rounding
carry the result beyond 2^31: n / d <= 2^15 - 1/d where d < 2^16; else n <= 2^31 without both extremes.
Then instructions are left out in turn, and each time the proof must fail.
"""

import copy
import re
import subprocess
import sys
import tempfile
from functools import partial
from itertools import product
from math import gcd, prod
from pathlib import Path

import z3
from prove_products import CALL_SAVED, SOURCE, Form, Unprovable, disassemble, known

NAME = "fixedpoint_divide_q16_16"
TABLE = "fixedpoint_reciprocal_table"
# Every eighth instruction is left out, but for those that skip digits of 0, clear what is 0 already, or
# test such bytes.
EVERY = 8
NEEDLESS = ("breq", "eor", "or", "ret")


class Machine:
    """One path through a stretch of code."""

    def __init__(self, program):
        self.program = program
        self.names = 0
        self.ranges = {}  # of a variable: its largest value
        self.facts = []   # (low, form, high), either may be None
        self.named = {}   # of a form: the variable that stands for it
        self.stack = []
        self.solver = None
        self.unequal = None  # what holds the exclusive or of `differing`
        self.carry = self.tested = self.sign = self.transfer = self.signs = None
        self.registers = {n: self.variable(f"r{n}") for n in range(32)}
        self.saved = {n: self.registers[n] for n in CALL_SAVED}

    def copy(self):
        other = copy.copy(self)
        other.solver = None
        for name in ("ranges", "facts", "named", "stack", "registers"):
            setattr(other, name, copy.copy(getattr(self, name)))
        return other

    # What holds

    def variable(self, kind, high=255):
        self.names += 1
        name = f"{kind}.{self.names}"
        self.ranges[name] = high
        self.hold(0, Form({name: 1}), high)
        return Form({name: 1})

    def hold(self, low, form, high=None):
        self.facts.append((low, form, high))
        if self.solver:
            self.tell(low, form, high)

    def zero(self, *registers):
        for register in registers:
            self.registers[register] = known(0)

    def number(self, registers):
        """Of the registers, the lowest first; None stands for 0."""
        total = Form()
        for i, register in enumerate(registers):
            if register is not None:
                total += self.registers[register] * (1 << 8 * i)
        return total

    def times(self, one, other):
        total = Form()
        for x, factor in one.items():
            for y, weight in other.items():
                total += self.monomial(x, y) * (factor * weight)
        return total

    def monomial(self, x, y):
        """Of two variables, of which each may be the constant 1."""
        if 1 in (x, y):
            return Form({y if x == 1 else x: 1})
        name = "*".join(sorted((x, y)))
        if name not in self.named:
            self.named[name] = name
            both, a, b = Form({name: 1}), Form({x: 1}), Form({y: 1})
            self.hold(0, both)
            most_a, most_b = self.ranges[x], self.ranges[y]
            self.hold(0, a * most_b - both)
            self.hold(0, b * most_a - both)
            self.hold(-most_a * most_b, both - a * most_b - b * most_a)
        return Form({name: 1})

    # Instructions

    def byte(self, register):
        """A variable or a known number in the register."""
        form = self.registers[register]
        if not set(form) - {1} or len(form) == 1 and form[next(iter(form))] == 1:
            return form
        key = frozenset(form.items())
        if key not in self.named:
            self.named[key] = self.variable("byte")
            self.hold(0, self.named[key] - form, 0)
        self.registers[register] = self.named[key]
        return self.named[key]

    def keep(self, register, total, sign):
        """The byte of a sum that leaves a carry, or of a difference that leaves a borrow."""
        if set(total) - {1}:
            self.carry = self.variable("carry", 1)
            form = total - self.carry * (256 * sign)
            # A multiple of 2^i is at most 256 - 2^i: over the rationals, that says more.
            self.hold(0, form, 256 - gcd(256, *form.values()))
        else:
            number = total.get(1, 0)
            self.carry, form = known(int(not 0 <= number < 256)), known(number % 256)
        self.tested = self.sign = form
        if register is not None:
            self.registers[register] = form

    def multiply(self, d, r):
        value, high = self.times(self.byte(d), self.byte(r)), self.variable("high")
        self.hold(0, value - high * 256, 255)
        self.registers[0], self.registers[1], self.carry = value - high * 256, high, None

    def look_up(self, d):
        page = self.registers[31].get(1, 0) - (self.program.table >> 8)
        if set(self.registers[31]) - {1} or page not in (0, 1):
            raise Unprovable("a byte is taken from elsewhere than the table")
        form, index, value = self.registers[30], self.byte(30), self.variable("table")
        self.registers[d] = value
        if page == 0:
            # power() of tables/reciprocal.py; of 0, nothing.
            demand(not self.copy().possible([(0, index, 0)]))
            scaled = self.times(value, index)
            self.hold(128, scaled)
            self.hold(0, known(256) - scaled - value)
        else:
            # What is known of the index and of the carries in it, times the value.
            self.hold(0, self.times(value, index - form), 0)
            carries = {name for name in form if str(name).startswith("carry")}
            for low, fact, high in self.facts[:]:
                if low == 0 and high and len(fact) > 1 and carries & set(fact):
                    self.hold(0, self.times(value, fact))
                    self.hold(0, value * high - self.times(value, fact))
            v, t = value + known(256), index + known(256)
            scaled = self.times(v, t)
            self.hold(0, known(1 << 17) - scaled - v)
            self.hold(None, known(1 << 17) - scaled - t, 511)

    def step(self, address):
        """The addresses that may follow, each with the machine there."""
        mnemonic, text, target, following = self.program.code[address]
        operands = [int(word[1:]) if re.fullmatch(r"r\d+", word) else word for word in text]
        d, r = (operands + operands + [None, None])[:2]
        registers = self.registers
        borrow = self.carry if mnemonic in ("adc", "sbc", "sbci", "cpc") else known(0)
        if borrow is None:
            raise Unprovable("the carry is read before it is set")
        if mnemonic == "mul":
            self.multiply(d, r)
        elif mnemonic in ("add", "adc"):
            self.keep(d, registers[d] + registers[r] + borrow, 1)
        elif mnemonic in ("sub", "sbc", "cp", "cpc"):
            self.keep(None if mnemonic in ("cp", "cpc") else d, registers[d] - registers[r] - borrow, -1)
        elif mnemonic in ("subi", "sbci", "cpi"):
            self.keep(None if mnemonic == "cpi" else d, registers[d] - known(int(r, 0)) - borrow, -1)
        elif mnemonic == "neg":
            self.keep(d, registers[d] * -1, -1)
        elif mnemonic == "com":
            registers[d], self.carry = known(255) - registers[d], known(1)
        elif mnemonic == "inc":
            carry = self.carry
            self.keep(d, registers[d] + known(1), 1)
            self.carry = carry
        elif mnemonic == "eor" and d == r:
            registers[d] = self.tested = self.sign = known(0)
        elif mnemonic == "eor":
            self.differing = registers[d], registers[r]
            registers[d] = self.unequal = self.variable("differing")
            self.tested = self.sign = None
        elif mnemonic == "bst" and r == "7" and registers[d] is self.unequal:
            return [self.of_signs(following, self.differing, signs) for signs in product((False, True), repeat=2)]
        elif mnemonic == "and" and d == r:
            self.tested = self.sign = registers[d]
        elif mnemonic == "or":
            whole = self.variable("or")
            for form in (registers[d], registers[r]):
                self.hold(0, whole - form)
            self.hold(0, registers[d] + registers[r] - whole)
            registers[d] = self.tested = self.sign = whole
        elif mnemonic == "and":
            whole = self.variable("and")
            for form in (registers[d], registers[r]):
                self.hold(0, form - whole)
            self.hold(-255, whole - registers[d] - registers[r])
            registers[d], self.tested, self.sign = whole, whole, whole
        elif mnemonic == "andi":
            demand(not set(registers[d]) - {1})
            registers[d] = known(registers[d].get(1, 0) & int(r, 0))
        elif mnemonic == "ldi":
            registers[d] = known(int(r, 0))
        elif mnemonic == "mov":
            registers[d] = registers[r]
        elif mnemonic == "movw":
            registers[d], registers[d + 1] = registers[r], registers[r + 1]
        elif mnemonic == "lpm":
            self.look_up(d)
        elif mnemonic == "push":
            self.stack.append(registers[d])
        elif mnemonic == "pop":
            if not self.stack or isinstance(self.stack[-1], int):
                raise Unprovable("the stack does not balance")
            registers[d] = self.stack.pop()
        elif mnemonic == "rcall":
            self.stack.append(following)
            return [(target, self)]
        elif mnemonic == "ret":
            if self.stack:
                if not isinstance(self.stack[-1], int):
                    raise Unprovable("the stack does not balance")
                return [(self.stack.pop(), self)]
            return [(None, self)]
        elif mnemonic == "rjmp":
            return [(target, self)]
        elif mnemonic in ("brts", "brtc"):
            return [(target if self.transfer == (mnemonic == "brts") else following, self)]
        elif mnemonic in ("brcs", "brcc"):
            if self.carry is None:
                raise Unprovable("the carry is read before it is set")
            return self.fork(target, following, self.carry, mnemonic == "brcs", 1)
        elif mnemonic in ("brmi", "brpl", "breq", "brne"):
            form, limit = (self.sign, 128) if mnemonic in ("brmi", "brpl") else (self.tested, 1)
            if form is None:
                raise Unprovable("a flag is read before it is set")
            return self.fork(target, following, form, mnemonic in ("brmi", "brne"), limit)
        elif mnemonic != "nop":
            raise Unprovable(f"{mnemonic} is not modelled")
        # Z is of more than this byte, or was not followed; likewise N.
        if mnemonic in ("mul", "com", "sbc", "sbci", "cpc", "andi"):
            self.tested = None
        if mnemonic in ("mul", "com", "andi"):
            self.sign = None
        return [(following, self)]

    def fork(self, target, following, form, taken_if_above, limit):
        """One machine where the form is at least `limit`, and one where it is below."""
        above, below = self.copy(), self.copy()
        above.hold(limit, form, limit if form is self.carry else None)
        below.hold(0, form, limit - 1)
        return [(target if taken_if_above else following, above), (following if taken_if_above else target, below)]

    def of_signs(self, following, numbers, signs):
        machine = self.copy()
        for form, negative in zip(numbers, signs):
            machine.hold(128 * negative, form, 127 + 128 * negative)
        machine.signs, machine.transfer = signs, signs[0] != signs[1]
        return following, machine

    # Conclusions

    def possible(self, given):
        """Whether the path can be, where what is given holds. It holds in what is asked from then on."""
        self.solver, self.reals = z3.SolverFor("QF_LRA"), {}
        self.fixed = {}  # carries that are known
        for low, form, high in (*self.facts, *given):
            if low == high and len(form) == 1 and form[name := next(iter(form))] == 1:
                self.fixed[name] = low
            self.tell(low, form, high)
        return self.solver.check() != z3.unsat

    def tell(self, low, form, high):
        if low is not None:
            self.solver.add(self.term(form) >= low)
        if high is not None:
            self.solver.add(self.term(form) <= high)

    def term(self, form):
        return z3.Sum([z3.RealVal(factor) if name == 1 else factor * self.reals.setdefault(name, z3.Real(name))
                       for name, factor in form.items()] + [z3.RealVal(0)])

    def impossible(self, statement):
        self.solver.push()
        self.solver.add(statement)
        answer = self.solver.check()
        self.solver.pop()
        return answer == z3.unsat

    def settle(self):
        """Which carries, in the order in which they arose, cannot be 1, or cannot be 0."""
        carries = [name for name in self.reals if name.startswith(("carry", "high")) and "*" not in name]
        for name in sorted(carries, key=lambda name: int(name.split(".")[1])):
            carry = self.reals[name]
            if name not in self.fixed and self.impossible(carry >= 1):
                self.fixed[name] = 0
            elif name not in self.fixed and name.startswith("carry") and self.impossible(carry <= 0):
                self.fixed[name] = 1
            if name in self.fixed:
                self.solver.add(carry == self.fixed[name])

    def show(self, *statements):
        """(low, form, high) each."""
        def holds(low, form, high):
            return ((low is None or self.impossible(self.term(form) <= low - 1)) and
                    (high is None or self.impossible(self.term(form) >= high + 1)))

        if not all(holds(*statement) for statement in statements):
            self.settle()
            for statement in statements:
                if not holds(*statement):
                    raise Unprovable(f"not shown: {statement}")

    def constant(self, form, modulus):
        """The number that the form is modulo a power of two."""
        for settled in (False, True):
            rest = known(0)
            for name, factor in form.items():
                parts = str(name).split("*")
                factor *= prod(self.fixed.get(part, 1) for part in parts)
                left = "*".join(part for part in parts if part not in self.fixed)
                rest += Form({name if name == 1 else left or 1: factor}) if factor else Form()
            if not any(factor % modulus for name, factor in rest.items() if name != 1):
                return rest.get(1, 0) % modulus
            if not settled:
                self.settle()
        raise Unprovable("a result is not what it ought to be")


A, B = range(22, 26), range(18, 22)  # registers, the lowest first
MANY = 1 << 64


class Size:
    """The code for divisors of one size, D = 2^k - E: in which registers its numbers are."""

    def __init__(self, name, k, **registers):
        self.name, self.k, self.top = name, k, B[k // 8 - 2]
        self.__dict__.update(registers)


SHORT = Size("short", 24, y=(26, 27), p=20, v=30, e=(19, 18), x=(31, 20, 21, 22, 23), zero=(21,), idle=(25,), saved=())
MEDIUM = Size("medium", 32, y=(26, 27, 20), p=21, v=30, e=(18, 19, 31), x=(20, 21, 22, 30, 23, 25), zero=(), idle=(24,),
              saved=())
LONG = Size("long", 40, y=(18, 19, 20, 21), p=26, v=27, e=(28, 29, 30, 31), x=(18, 19, 20, 21, 22, 23), zero=(16,),
            idle=(16,), saved=(16, 17, 28, 29))


def entry(m):
    """n = |a|, d = |b|, T: the signs differ"""
    m.zero(1)
    a, b = m.number(A), m.number(B)
    # -2^31 and -2^16, byte by byte
    both_extreme = [equal(m.registers[register], known(number))
                    for register, number in zip((*A, *B), (0, 0, 0, 128, 0, 0, 255, 255))]

    def check(m, end):
        demand(m.signs)
        n, d = (known(1 << 32) - number if minus else number for number, minus in zip((a, b), m.signs))
        if end is None:
            m.show(*both_extreme, equal(m.number(A), known((1 << 31) - 1)))
            return
        m.show(equal(m.number(A), n), equal(m.number(B), d))
        demand(m.registers[1] == known(0))
        if not m.transfer and m.possible(both_extreme):
            m.settle()
            demand(m.solver.check() == z3.unsat)
    return check


def magnitudes(m):
    """n / d, or the clamped result"""
    m.zero(1)
    n, d = m.number(A), m.number(B)
    m.hold(0, n, 1 << 31)
    m.hold(0, d, 1 << 31)

    def check(m, end):
        times = 256 if m.registers[18] == known(0) else 1
        if end is None:
            m.show((0, n - d * (1 << 15), MANY))
            extreme = (1 << 31) - 1 if not m.transfer else 1 << 31
            for given, result in (((1, n, MANY), extreme), ((0, n, 0), 0)):
                if m.possible([given]):
                    m.show(equal(m.number(A), known(result)))
            m.possible([])
            return
        size = {".Lshort": SHORT, ".Lmedium": MEDIUM, ".Llong": LONG}[end]
        m.show((1, m.registers[size.top], 255), equal(m.number(A), n * times), equal(m.number(B), d * times),
               *(equal(m.registers[other], known(0)) for other in B if other > size.top))
        if size is SHORT:
            m.show((-MANY, n - d * (1 << 15), -1))
    return check


def reciprocal(size, m):
    """p, and y = p d"""
    n, d = m.number(A), m.number(range(18, size.top + 1))
    m.hold(1, m.registers[size.top])
    m.zero(*range(size.top + 1, 22))

    def check(m, end):
        demand(m.registers[31] == known(m.program.table >> 8))
        m.show(equal(m.number(size.y), m.times(m.registers[size.p], d)), (128, m.registers[size.y[-1]], 255),
               equal(m.number(A), n), *zeros(m, size.zero))
    return check


def index(size, m):
    """V, and E = 2^k - V y"""
    n, p, y = m.number(A), m.registers[size.p], m.number(size.y)
    m.hold(128, m.registers[size.y[-1]])
    m.registers[31] = known(m.program.table >> 8)
    m.zero(*size.zero)

    def check(m, end):
        # V or V + 1
        v = m.registers[size.v]
        m.show(equal(m.number(A), n), equal(m.registers[size.p], p), *zeros(m, size.zero))
        e = known(1 << size.k) - m.times(v + known(256), y)
        m.show((1, e, (1 << size.k - 8) - 1))
        demand(m.constant(m.number(size.e) - e, 1 << size.k - 8) == 0)
    return check


def scale(size, above, m):
    """x = n w; where digits are skipped, they are 0."""
    n, v, p, e = m.number(A), m.registers[size.v], m.registers[size.p], m.number(size.e)
    m.zero(*size.zero)
    # As w d = D < 2^k, and d is not below 2^(k-16).
    m.hold(0, m.times(v, p) + p * 256, 65535)

    def check(m, end):
        w = m.number((26, 27))
        # As n < 2^15 d where d is short, and n <= 2^31.
        m.possible([(0, m.times(n, w) + w, 1 << 39) if size is SHORT else (0, w * (1 << 31) - m.times(n, w), MANY)])
        m.show(equal(w, m.times(v, p) + p * 256), equal(m.number(size.x), m.times(n, w)), equal(m.number(size.e), e),
               *zeros(m, (*size.idle, *above[end])))
        if size is LONG:
            m.show((0, m.registers[23], 127))
    return check


def before_digit(size, q, above, into, m):
    """E, the digit and those above it, and what is left if it is right."""
    e = m.number(size.e)
    m.hold(1, e)
    m.zero(*size.idle)
    if size is LONG:
        m.hold(0, m.registers[23], 127 + len(above))
    return e, m.number((q, *above)), m.number(into) + m.times(m.registers[q], e)


def digit(size, q, above, into, out, rest, m):
    """One more, and what is left below it."""
    e, number, scaled = before_digit(size, q, above, into, m)
    others = m.number(rest)

    def check(m, end):
        more = m.constant(m.number((q, *above)) - number, 1 << 8 * (1 + len(above)))
        demand(more < 2)
        m.show(equal(m.number(out), scaled + (e - known(1 << size.k)) * more), equal(m.number(size.e), e),
               equal(m.number(rest), others), *zeros(m, size.idle))
        if size is LONG:
            m.show((0, m.registers[23], 128 + len(above)))
    return check


def last_digit(size, q, above, into, m):
    """The result: N / D less it is between -1/2 and 1/2, and which of them depends on the sign."""
    e, quotient, scaled = before_digit(size, q, above, into, m)

    def check(m, end):
        result = m.number(A) * (-1 if m.transfer else 1)
        more = m.constant(result - quotient, 1 << 32)
        demand(more < 3)
        d = known(1 << size.k) - e
        rest = (scaled - d * more) * 2
        m.show((0 if size is SHORT else int(m.transfer), rest + d, MANY),
               (0 if size is SHORT else int(not m.transfer), d - rest, MANY))
    return check


def stretches():
    yield NAME, entry, (".Lmagnitudes", None), ()
    yield ".Lmagnitudes", magnitudes, (".Lshort", ".Lmedium", ".Llong", None), ()
    digits = {SHORT: ((23, (), (20, 21, 22), (20, 21, 22), (31,)), (22, (23,), (31, 20, 21), (31, 20, 21), ()),
                      (21, (22, 23), (None, 31, 20), (26, 31, 20), ()), (20, (21, 22, 23), (None, 26, 31))),
              MEDIUM: ((25, (), (21, 22, 30, 23), (21, 22, 30, 23), (20,)),
                       (23, (25,), (20, 21, 22, 30), (20, 21, 22, 30), ()),
                       (30, (23, 25), (None, 20, 21, 22), (26, 20, 21, 22), ()), (22, (30, 23, 25), (None, 26, 20, 21))),
              LONG: ((23, (), (18, 19, 20, 21, 22), (18, 19, 20, 21, 22), ()),
                     (22, (23,), (None, 18, 19, 20, 21), (17, 18, 19, 20, 21), ()),
                     (21, (22, 23), (None, 17, 18, 19, 20)))}
    for size, (*upper, last) in digits.items():
        label = f".L{size.name}"
        names = [f"{label}_digit_{len(upper) - i}" for i in range(len(upper) + 1)]
        yield label, partial(reciprocal, size), (f"{label}_index",), ()
        yield f"{label}_index", partial(index, size), (f"{label}_scale",), size.saved
        above = {name: registers[1] for name, registers in zip(names, upper)}
        yield f"{label}_scale", partial(scale, size, above), tuple(above), size.saved
        for i, registers in enumerate(upper):
            yield names[i], partial(digit, size, *registers), names[i + 1:i + 2], size.saved
        yield names[-1], partial(last_digit, size, *last), (None,), size.saved


def equal(form, other):
    return 0, form - other, 0


def zeros(m, registers):
    return [equal(m.registers[register], known(0)) for register in registers]


def demand(holds):
    if not holds:
        raise Unprovable("a result is not what it ought to be")


class Program:
    """The kernel and its table, linked."""

    def __init__(self, folder):
        avr = SOURCE / "fixedpoint/avr"
        elf = f"{folder}/quotients.elf"
        subprocess.run(["avr-gcc", "-mmcu=atmega328p", "-nostartfiles", "-nostdlib", "-I", SOURCE, "-o", elf,
                        "-Wa,--keep-locals", "-Wl,--no-gc-sections,--discard-none",
                        avr / "divide_q16_16.S", avr / "reciprocal_table.S"], check=True)
        symbols = subprocess.run(["avr-nm", elf], check=True, capture_output=True, text=True).stdout
        self.labels = {name: int(address, 16) for address, _, name in map(str.split, symbols.splitlines())}
        self.cuts = {self.labels[label]: label for label, *_ in stretches()}
        self.saved = {label: saved for label, *_, saved in stretches()} | {None: ()}
        self.code = disassemble(elf)[1]
        subprocess.run(["avr-objcopy", "-O", "binary", "-j", ".text", elf, f"{folder}/flash"], check=True)
        self.table = self.labels[TABLE]
        self.check_table(Path(f"{folder}/flash").read_bytes()[self.table:][:512])

    @staticmethod
    def check_table(page):
        """What Machine.look_up says of it."""
        for i, (p, v) in enumerate(zip(page[:256], page[256:])):
            demand(i == 0 or 128 <= p * i <= 256 - p)
            demand((v + 256) * (i + 257) <= 1 << 17 and (1 << 17) - (v + 257) * (i + 256) < 512)

    def prove(self, label, begin, ends, saved):
        """Of the stretch behind a label; returns the addresses that were visited."""
        start = Machine(self)
        start.stack = [start.saved[register] for register in saved]
        check = begin(start)
        visited, waiting = {self.labels[label]}, []
        for transfer in (False, True):
            machine = start.copy()
            machine.transfer = transfer
            waiting += machine.step(self.labels[label])
        while waiting:
            address, machine = waiting.pop()
            if address is not None and address not in self.cuts:
                visited.add(address)
                if address not in self.code:
                    raise Unprovable("the code is left")
                waiting += machine.step(address)
            elif machine.possible([]):
                end = self.cuts.get(address)
                demand(end in ends)
                pushed = self.saved[end]
                demand(machine.stack == [machine.saved[n] for n in pushed])
                demand(all(machine.registers[n] == machine.saved[n] for n in CALL_SAVED if n not in pushed))
                demand(end is not None or machine.registers[1] == known(0))
                check(machine, end)
        return visited

    def survivors(self, stretch, visited):
        """Instructions without which the proof still goes through."""
        found = []
        for address in sorted(visited)[::EVERY]:
            mnemonic, operands, target, following = self.code[address]
            if mnemonic in NEEDLESS:
                continue
            self.code[address] = ("nop", [], None, following)
            try:
                self.prove(*stretch)
                found.append(f"{address:#x} {mnemonic} {', '.join(operands)}")
            except Unprovable:
                pass
            self.code[address] = (mnemonic, operands, target, following)
        return found


def main():
    with tempfile.TemporaryDirectory() as folder:
        program = Program(folder)
    failed = False
    for stretch in stretches():
        try:
            visited = program.prove(*stretch)
        except Unprovable as reason:
            print(f"{stretch[0]}: not proven: {reason}", file=sys.stderr)
            failed = True
            continue
        print(f"{stretch[0]}: proven", flush=True)
        for instruction in program.survivors(stretch, visited):
            print(f"{stretch[0]}: proven without {instruction}, too", file=sys.stderr, flush=True)
            failed = True
    return failed


if __name__ == "__main__":
    sys.exit(main())
