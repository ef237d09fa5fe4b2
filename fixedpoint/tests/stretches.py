# SPDX-License-Identifier: MIT
"""Proofs about machine code that multiplies, one stretch at a time.

The code is cut at its labels. In the stretch after each label, every path is followed, with the
registers containing linear forms of bytes, of products of bytes and of carries. If the registers
satisfy the statement at a cut, they must satisfy the statement at the next one. That is a set of
linear inequalities, which z3 decides over the rationals once it knows which carries must be 0 and
which must be 1.
"""

import copy
import random
from functools import cache
from itertools import islice, product
from math import gcd, prod

import z3

from form import Form, known
from machine_code import Machine, Unprovable, demand


# The input of z3, built once for all cases: building takes longer than deciding.
real = cache(z3.Real)


@cache
def term(items):
    """The input of z3 for the names and factors of a form."""
    return z3.Sum([z3.RealVal(factor) if name == 1 else factor * real(name) for name, factor in items] + [z3.RealVal(0)])


@cache
def at_least(low, items):
    return term(items) >= low


@cache
def at_most(high, items):
    return term(items) <= high


TRIES, ENOUGH = 40, 4  # of random operands, for witnesses


class Values(dict):
    """The values of variables and of their products, from a random one for each that is not computed from others."""

    def __init__(self, machine, seed):
        super().__init__({1: 1})
        self.machine, self.random = machine, random.Random(seed)

    def __missing__(self, name):
        if "*" in name:
            value = prod(self[part] for part in name.split("*"))
        elif compute := self.machine.computed.get(name):
            value = compute(self.of)
        else:
            high = self.machine.ranges[name]
            value = self.random.choice((0, high, self.random.randint(0, high)))
        self[name] = value
        return value

    def of(self, form):
        return sum(factor * self[name] for name, factor in form.items())

    def satisfy(self, low, form, high):
        return (low is None or self.of(form) >= low) and (high is None or self.of(form) <= high)


class Linear(Machine):
    """Of linear forms."""

    def __init__(self, program):
        self.names = 0
        self.ranges = {}  # variable: its largest value
        self.computed = {}  # variable: its value by those of forms, for what is computed from others
        self.facts = []   # (low, form, high), either may be None
        self.named = {}   # form: the variable that represents it
        self.solver, self.fixed, self.given = None, {}, []
        self.found = None  # values of all variables
        self.unequal = None  # what holds the exclusive or of `differing`
        self.memory = []     # bytes from address 0 on
        self.carry = self.tested = self.sign = self.signs = None
        super().__init__(program, {n: self.variable(f"r{n}") for n in range(32)})

    def copy(self):
        other = super().copy()
        other.solver, other.fixed, other.given, other.found = None, {}, [], None
        for name in ("ranges", "computed", "facts", "named"):
            setattr(other, name, copy.copy(getattr(self, name)))
        return other

    # Facts

    def is_zero(self, register):
        return self.registers[register] == known(0)

    def variable(self, kind, high=255, value=None):
        self.names += 1
        name = f"{kind}.{self.names}"
        self.ranges[name], self.computed[name] = high, value
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
        """The product of two variables, each of which may be the constant 1."""
        if 1 in (x, y):
            return Form({y if x == 1 else x: 1})
        name = "*".join(sorted((*x.split("*"), *y.split("*"))))
        if name not in self.named:
            self.named[name] = name
            both, a, b = Form({name: 1}), Form({x: 1}), Form({y: 1})
            self.hold(0, both)
            most_a, most_b = self.most(x), self.most(y)
            self.hold(0, a * most_b - both)
            self.hold(0, b * most_a - both)
            self.hold(-most_a * most_b, both - a * most_b - b * most_a)
        return Form({name: 1})

    def most(self, name):
        return prod(self.ranges[part] for part in name.split("*"))

    def bring(self, factor):
        """The known facts about bytes, carries and the high bytes of products, times a non-negative
        form."""
        for low, fact, high in self.facts[:]:
            if None not in (low, high) and len(fact) > 1 and max(str(name).count("*") for name in fact) < 2:
                product = self.times(fact, factor)
                self.hold(0, product - factor * low, 0 if low == high else None)
                if low != high:
                    self.hold(0, factor * high - product)

    # Instructions

    def byte(self, register):
        """A variable or a known number in the register."""
        form = self.registers[register]
        if not set(form) - {1} or len(form) == 1 and form[next(iter(form))] == 1:
            return form
        key = frozenset(form.items())
        if key not in self.named:
            self.named[key] = self.variable("byte", value=lambda of: of(form))
            self.hold(0, self.named[key] - form, 0)
        self.registers[register] = self.named[key]
        return self.named[key]

    def keep(self, register, total, sign):
        """The byte of a sum that leaves a carry, or of a difference that leaves a borrow."""
        if set(total) - {1}:
            self.carry = self.variable("carry", 1, lambda of: int(not 0 <= of(total) < 256))
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
        x, y = self.byte(d), self.byte(r)
        value = self.times(x, y)
        if not set(value) - {1}:
            low, high = divmod(value.get(1, 0), 256)[::-1]
            self.registers[0], self.registers[1], self.carry = known(low), known(high), None
            return
        largest = sum(factor * (1 if name == 1 else self.most(name)) for name, factor in value.items())
        high = self.variable("high", largest >> 8, lambda of: of(value) >> 8)
        # A multiple of 2^i is at most 256 - 2^i.
        self.hold(0, value - high * 256, 256 - gcd(256, *value.values()))
        self.registers[0], self.registers[1], self.carry = value - high * 256, high, None

    def look_up(self, d):
        """A byte of the tables."""
        flash, place = self.program.flash, self.registers[30].constant() + 256 * self.registers[31].constant()
        demand(place < len(flash))
        self.registers[d] = known(flash[place])

    def load(self, d, low):
        """From X+ or Z+, which must be known."""
        pointer = self.number((low, low + 1)).constant()
        demand(pointer < len(self.memory), "what is read is not of the vector")
        self.registers[d] = self.memory[pointer]
        self.registers[low], self.registers[low + 1] = known(pointer + 1 & 255), known(pointer + 1 >> 8)

    def compute(self, mnemonic, d, r, target, following):
        registers, before = self.registers, self.tested
        borrow = self.carry if mnemonic in ("adc", "sbc", "sbci", "cpc", "ror") else known(0)
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
            registers[d] = self.tested = self.sign = known(255) - registers[d]
            self.carry = known(1)
        elif mnemonic in ("inc", "dec"):
            carry, sign = self.carry, 1 if mnemonic == "inc" else -1
            self.keep(d, registers[d] + known(sign), sign)
            self.carry = carry
        elif mnemonic == "adiw":
            self.keep(d, registers[d] + known(int(r, 0)), 1)
            self.keep(d + 1, registers[d + 1] + self.carry, 1)
            self.tested = None
        elif mnemonic in ("lsr", "ror"):
            form = registers[d]
            half = self.variable("half", 127, lambda of: of(form) >> 1)
            if not set(form) - {1}:
                half = known(form.get(1, 0) >> 1)
            self.hold(0, form - half * 2, 1)
            registers[d] = self.tested = self.sign = half + (self.carry * 128 if mnemonic == "ror" else known(0))
            self.carry = form - half * 2
        elif mnemonic in ("sbrs", "sbrc"):
            skipped = self.program.code[following][3]
            if r == "7":
                return self.fork(skipped, following, registers[d], mnemonic == "sbrs", 128)
            bit = registers[d].constant() >> int(r) & 1
            return [(skipped if bit == (mnemonic == "sbrs") else following, self)]
        elif mnemonic == "swap":
            byte = registers[d].constant()
            registers[d] = known(byte >> 4 | byte << 4 & 255)
        elif mnemonic in ("clc", "sec"):
            self.carry = known(int(mnemonic == "sec"))
        elif mnemonic in ("clt", "set"):
            self.transfer = mnemonic == "set"
        elif mnemonic == "eor" and d == r:
            registers[d] = self.tested = self.sign = known(0)
        elif mnemonic == "eor":
            self.differing = registers[d], registers[r]
            one, other = self.differing
            registers[d] = self.unequal = self.variable("differing", value=lambda of: of(one) ^ of(other))
            self.tested = self.sign = None
        elif mnemonic == "bst" and r == "7" and registers[d] is self.unequal:
            return [self.of_signs(following, self.differing, signs) for signs in product((False, True), repeat=2)]
        elif mnemonic == "and" and d == r:
            self.tested = self.sign = registers[d]
        elif mnemonic == "or" and (self.apart(d, r) or self.apart(r, d)):
            registers[d] = self.tested = self.sign = registers[d] + registers[r]
        elif mnemonic == "or":
            one, other = registers[d], registers[r]
            whole = self.variable("or", value=lambda of: of(one) | of(other))
            for form in (one, other):
                self.hold(0, whole - form)
            self.hold(0, registers[d] + registers[r] - whole)
            registers[d] = self.tested = self.sign = whole
        elif mnemonic == "and":
            one, other = registers[d], registers[r]
            whole = self.variable("and", value=lambda of: of(one) & of(other))
            for form in (one, other):
                self.hold(0, form - whole)
            self.hold(-255, whole - registers[d] - registers[r])
            registers[d], self.tested, self.sign = whole, whole, whole
        elif mnemonic == "andi":
            demand(not set(registers[d]) - {1})
            registers[d] = known(registers[d].get(1, 0) & int(r, 0))
        elif mnemonic == "ldi":
            registers[d] = known(int(r, 0))
        elif mnemonic == "lpm" and r == "Z":
            self.look_up(d)
        elif mnemonic == "ld" and r in ("X+", "Z+"):
            self.load(d, 26 if r == "X+" else 30)
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
        else:
            raise Unprovable(f"{mnemonic} is not modelled")
        # Z depends on the bytes before, too: on their sum, which is 0 if all are. Or it was not followed; likewise N.
        if mnemonic in ("sbc", "sbci", "cpc") and None not in (before, self.tested):
            self.tested = before + self.tested
        elif mnemonic in ("mul", "sbc", "sbci", "cpc", "andi"):
            self.tested = None
        if mnemonic in ("mul", "andi"):
            self.sign = None
        return [(following, self)]

    def apart(self, d, r):
        """Whether the registers have no bit in common: one is a multiple of a number that exceeds
        the other."""
        upper, lower = self.registers[d], self.registers[r]
        return (len(lower) == 0 or 1 not in lower and len(lower) == 1 and lower[name := next(iter(lower))] == 1 and
                gcd(256, *upper.values()) > self.most(name))

    def fork(self, target, following, form, taken_if_above, limit):
        """One machine with the form at least `limit`, and one with the form below it."""
        if not set(form) - {1}:
            return [(target if (form.get(1, 0) >= limit) == taken_if_above else following, self)]
        self.forked = True
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
        """Whether the path is feasible under the given conditions, which are assumed from then
        on."""
        self.solver, self.told = z3.SolverFor("QF_LRA"), {}
        if given != self.given:
            self.given, self.found = given, None
        self.fixed = {}  # carries that are known
        for low, form, high in (*self.facts, *given):
            if low == high and len(form) == 1 and form[name := next(iter(form))] == 1:
                self.fixed[name] = low
            self.tell(low, form, high)
        return self.solver.check() != z3.unsat

    def feasible(self):
        if self.possible([]):
            self.settle()
        return self.solver.check() != z3.unsat

    def tell(self, low, form, high):
        items = tuple(form.items())
        self.told.update(form)
        if low is not None:
            self.solver.add(at_least(low, items))
        if high is not None:
            self.solver.add(at_most(high, items))

    def reaches(self, low, form):
        """Whether the form can be `low` or more."""
        return not self.impossible(at_least(low, tuple(form.items())))

    def impossible(self, statement):
        self.solver.push()
        self.solver.add(statement)
        answer = self.solver.check()
        self.solver.pop()
        return answer == z3.unsat

    def witnesses(self):
        """Values of all variables that satisfy everything that is known: what does not hold for them, z3 cannot show."""
        if self.found is None:
            self.told_witnesses, self.found = 0, (Values(self, seed) for seed in range(TRIES))
        facts = [*self.given, *self.facts][self.told_witnesses:]
        self.found = list(islice((values for values in self.found if all(values.satisfy(*fact) for fact in facts)), ENOUGH))
        self.told_witnesses += len(facts)
        return self.found

    def settle(self):
        """Which carries, in the order in which they arose, cannot be 1, or cannot be 0."""
        if not self.solver:
            self.possible([])
        witnesses = self.witnesses()
        carries = [name for name in self.told if name != 1 and name.startswith(("carry", "high")) and "*" not in name]
        for name in sorted(carries, key=lambda name: int(name.split(".")[1])):
            carry = real(name)
            found = {min(values[name], 1) for values in witnesses}
            if name not in self.fixed and 1 not in found and self.impossible(carry >= 1):
                self.fixed[name] = 0
            elif name not in self.fixed and 0 not in found and name.startswith("carry") and self.impossible(carry <= 0):
                self.fixed[name] = 1
            if name in self.fixed:
                self.solver.add(carry == self.fixed[name])

    def show(self, *statements):
        """Each statement is (low, form, high)."""
        for values in self.witnesses():
            for statement in statements:
                demand(values.satisfy(*statement), f"not shown: {statement}")
        if not self.solver and any(set(form) - {1} for _, form, _ in statements):
            self.possible([])

        def holds(low, form, high):
            if not set(form) - {1}:
                return (low is None or form.get(1, 0) >= low) and (high is None or form.get(1, 0) <= high)
            items = tuple(form.items())
            return ((low is None or self.impossible(at_most(low - 1, items))) and
                    (high is None or self.impossible(at_least(high + 1, items))))

        if not all(holds(*statement) for statement in statements):
            self.settle()
            for statement in statements:
                if not holds(*statement):
                    raise Unprovable(f"not shown: {statement}")

    def learn(self, *statements):
        self.show(*statements)
        for statement in statements:
            self.hold(*statement)

    def same(self, form, other, modulus):
        """Both are equal, since they are congruent modulo a power of two and differ by less than
        it."""
        demand(self.constant(form - other, modulus) == 0)
        self.learn((1 - modulus, form - other, modulus - 1))
        self.hold(0, form - other, 0)

    def constant(self, form, modulus):
        """The constant to which the form is congruent modulo a power of two."""
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


class Bounded(Linear):
    """If a form is a byte for all values of its variables, products are formed of it; if a sum
    always or never leaves a carry, that is known."""

    def carried(self, form):
        """The multiple of 256 in the form for all values of its variables; None if it depends on
        them."""
        least, most = form.get(1, 0), sum(factor * (1 if name == 1 else self.most(name)) for name, factor in form.items())
        return least >> 8 if min(form.values(), default=0) >= 0 and least >> 8 == most >> 8 else None

    def byte(self, register):
        form = self.registers[register]
        return form if self.carried(form) == 0 else super().byte(register)

    def keep(self, register, total, sign):
        carry = self.carried(total)
        if carry is None:
            super().keep(register, total, sign)
            return
        self.carry = known(carry)
        self.tested = self.sign = total - known(256 * carry)
        if register is not None:
            self.registers[register] = self.tested


class Signed(Linear):
    """Knows the signs of the highest bytes, by their names."""

    def __init__(self, program):
        super().__init__(program)
        self.negative = {}

    def as_signed(self, form):
        """The number that a byte represents."""
        name = next(iter(form), None)
        demand(name in self.negative, "the sign of a byte is asked for that has none")
        return form - known(256 * self.negative[name])

    def compute(self, mnemonic, d, r, target, following):
        registers = self.registers
        if mnemonic in ("mulsu", "muls"):
            x, y = self.as_signed(self.byte(d)), self.byte(r)
            if mnemonic == "muls":
                y = self.as_signed(y)
            value = self.times(x, y)
            # The sign is the carry.
            product = value
            self.carry = self.variable("carry", 1, lambda of: of(product) < 0) if min(x.get(1, 0), y.get(1, 0)) < 0 else known(0)
            high, value = self.variable("high", 255, lambda of: of(product) >> 8 & 255), value + self.carry * (1 << 16)
            self.hold(0, value - high * 256, 255)
            registers[0], registers[1] = value - high * 256, high
        elif mnemonic == "sbc" and d == r:
            registers[d] = self.carry * 255
        elif mnemonic == "and" and not set(registers[r]) - {1}:
            demand(registers[r].constant() in (0, 255))
            registers[d] = registers[d] if registers[r] else known(0)
        else:
            return super().compute(mnemonic, d, r, target, following)
        return [(following, self)]


def give_signs(m, places, negative):
    for register, is_negative in zip(places, negative):
        m.negative[next(iter(m.registers[register]))] = is_negative
        m.hold(128 * is_negative, m.registers[register], 127 + 128 * is_negative)


def equal(form, other):
    return 0, form - other, 0


def zeros(m, registers):
    return [equal(m.registers[register], known(0)) for register in registers]


def kept(m, *registers):
    """A check that the registers are as they are now."""
    before = {register: m.registers[register] for register in registers}
    transfer = m.transfer

    def statements(m):
        demand(m.transfer == transfer)
        return [equal(m.registers[register], form) for register, form in before.items()]
    return statements
