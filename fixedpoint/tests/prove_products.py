#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Proves that kernels of products return the exact sum of products rounded to nearest, modulo 2^W,
for all operands: multiply, multiply_add, dot2 and dot3 of every split in KERNELS, and multiply of
numbers without a sign.

usage: prove_products.py [--kernel NAME]

The kernel's instructions are executed with every register holding a linear form: a combination of
the bytes of operands, the bytes that multiplications return, and carry flags, all of them integer
variables. Multiplications are opaque: for any byte of a and byte of b, the two result bytes and the
sign are variables that together form the product. The exact sum is a linear form of the same
products; products that are not computed have weights beyond the result, or a known factor. If the
code tests the sign of an operand, or whether a byte is 0 or -1, both answers are followed. What
remains is one statement without products of variables,

    0 <= (sum a b + 2^(F-1) - 2^F result) mod 2^(F+W) < 2^F.

Carries that the code drops occur in it with a nonzero factor. Each is shown to be 0, in the order
in which they arise, and then the statement itself is shown, by linear programming over the
rationals: z3 need not search. Then instructions are left out in turn, and each time the proof must
fail.
"""

import argparse
import re
import subprocess
import sys
import tempfile
from collections import Counter
from functools import cache
from math import gcd
from pathlib import Path

import z3

from form import Form, known
from machine_code import CALL_SAVED, SAMPLE, Unprovable, disassemble, operand as decoded
from stretches import at_least, at_most, real

SOURCE = Path(__file__).parent.parent / "src"
STEPS = 3000  # more steps than any kernel takes
# Instructions that set the flags that a branch reads.
KEEP_FLAGS = {"mov", "movw", "ldi", "ld", "ldd", "push", "pop", "nop", "clt", "set", "rjmp", "brts", "brtc",
              "brpl", "brmi", "breq", "brne", "sbrs", "sbrc"}

SPLITS_16 = [(16 - f, f) for f in range(17)]
SPLITS_24 = [(24 - f, f) for f in range(24)]
SPLITS_32 = [(32 - f, f) for f in range(33)]


class Pointer:
    """The low byte of a pointer into operand a or b; its high byte is None in the next register."""

    def __init__(self, operand, offset=0):
        self.operand, self.offset = operand, offset


@cache
def named_byte(name):
    """(operand and component, index) of a variable that is a byte of an operand."""
    byte = re.fullmatch(r"([ab]\d)\.(\d)", str(name))
    return byte and (byte[1], int(byte[2]))


class Machine:
    """One path through a kernel; `answers` gives the results of the tests in the code: whether an
    operand is negative, and whether a byte equals a number."""

    def __init__(self, kernel, code, answers):
        self.kernel, self.code = kernel, code
        self.answers = dict(answers)
        self.equal = {key[0]: key[1] for key, holds in answers if holds and isinstance(key, tuple)}
        for byte, number in self.equal.items():
            operand, index = byte.split(".")
            if self.is_top((operand, int(index))):
                self.answers[operand] = number > 127
        self.ranges = {}
        # Of a variable: (low, form, high) that defines it.
        self.facts = {byte: (number, Form({byte: 1}), number) for byte, number in self.equal.items()}
        self.shifted = {}     # of a bit that a shift has moved out: the form that is the same
        self.read_carries = set()
        self.products = {}
        self.stack = []
        self.carry = self.transfer = self.tested = None
        self.registers = {n: self.variable(f"r{n}", 255) for n in range(32)}
        self.registers[1] = known(0)
        kernel.place_operands(self)
        self.before = dict(self.registers)
        self.address, self.visits = None, Counter()  # where the path is, and how often it was at each address

    def variable(self, name, high):
        self.ranges[name] = high
        return Form({name: 1})

    def fresh(self, kind, high):
        return self.variable(f"{kind}@{self.address:x}.{self.visits[self.address]}", high)

    def byte_of(self, operand, component, index):
        return self.variable(f"{operand}{component}.{index}", 255)

    def read(self, register):
        if register not in self.registers:
            raise Unprovable(f"r{register} is read before it is set")
        return self.registers[register]

    def number(self, register):
        form = self.read(register)
        if not isinstance(form, Form):
            raise Unprovable(f"r{register} holds a pointer")
        return form

    def known_carry(self):
        if self.carry is None:
            raise Unprovable("the carry is read before it is set")
        self.read_carries |= set(self.carry)
        return self.carry

    @staticmethod
    def operand_byte(form):
        """(operand and component, index)"""
        names = list(form)
        byte = named_byte(names[0]) if len(names) == 1 and form[names[0]] == 1 else None
        if byte is None:
            raise Unprovable("what ought to be a byte of an operand is not")
        return byte

    def is_top(self, byte):
        """Whether the byte has a sign."""
        return self.kernel.is_signed and byte[1] == self.kernel.size - 1

    def multiply(self, d, r, signed):
        """signed: how many of the two are."""
        x, y = self.operand_byte(self.number(d)), self.operand_byte(self.number(r))
        if {x[0][0], y[0][0]} != {"a", "b"} or x[0][1] != y[0][1]:
            raise Unprovable("bytes are multiplied that are not those of a product")
        if signed and not self.is_top(x) or signed == 2 and not self.is_top(y):
            raise Unprovable("a signed product takes the wrong byte")
        tops = self.is_top(x) + self.is_top(y)
        if signed and self.is_top(y) and signed < 2:
            raise Unprovable("a signed product takes the wrong byte")
        low, high, sign = self.fresh("low", 255), self.fresh("high", 255), self.fresh("sign", 1)
        value = low + high * 256
        if signed:
            value = value + sign * -65536
            fact = (-128 * 255, value, 127 * 255) if signed == 1 else (-128 * 127, value, 128 * 128)
        else:
            fact = (0, value, 255 * 255)
        for part in (low, high, sign):
            self.facts[next(iter(part))] = fact
        if not signed:
            # An unsigned product of a byte that counts as signed is 256 times the other too much
            # where that is negative.
            for top, other in ((x, y), (y, x)):
                if self.is_top(top):
                    if tops == 2:
                        value = value + self.fresh(f"{other[0]} excess", 255) * -256
                    else:
                        value = value + self.excess(top[0], other) * -256
            if tops == 2:
                value = value + self.fresh("both_negative", 1) * 65536
        product = tuple(sorted((x, y)))
        if product in self.products:
            raise Unprovable("a product is formed twice")
        self.products[product] = value
        self.registers[0], self.registers[1], self.carry = low, high, sign

    def excess(self, operand, other):
        """The byte `other`, where the operand is negative, else 0."""
        byte = f"{other[0]}.{other[1]}"
        if operand in self.answers:
            return Form({byte: 1}) if self.answers[operand] else known(0)
        return self.variable(f"{byte} where {operand} is negative", 255)

    def add(self, d, r, carry):
        total = self.number(d) + self.number(r) + carry
        self.carry = self.fresh("carry", 1)
        self.keep_byte(d, total - self.carry * 256)

    def subtract(self, d, subtrahend, carry):
        self.carry, borrow = self.fresh("carry", 1), carry
        self.keep_byte(d, self.number(d) - subtrahend - borrow + self.carry * 256)

    def keep_byte(self, register, form):
        """The byte that leaves the new carry."""
        self.registers[register] = form
        # A multiple of 2^k is at most 256 - 2^k: over the rationals, that says more.
        self.facts[next(iter(self.carry))] = (0, form, 256 - gcd(256, *form.values()))

    def rotate_right(self, d, carry):
        """The bit that leaves is a variable where it is added, and whole - 2 upper where it moves on."""
        upper, whole = self.fresh("upper", 127), self.number(d)
        self.registers[d] = upper + self.shifted.get(frozenset(carry), carry) * 128
        self.carry = self.fresh("bit", 1)
        moved = whole - upper * 2
        self.shifted[frozenset(self.carry)] = moved
        self.facts[next(iter(upper))] = (0, moved, 1)
        self.facts[next(iter(self.carry))] = (0, moved - self.carry, 0)

    def is_negative(self, form):
        operand, index = self.operand_byte(form)
        if not self.is_top((operand, index)):
            raise Unprovable("the sign of a byte is asked for that has none")
        return self.answer(operand)

    def answer(self, key):
        if key not in self.answers:
            raise Undecided(key)
        return self.answers[key]

    def is_zero(self, form):
        """Of a number, or of the difference of a byte of an operand and a number."""
        if not set(form) - {1}:
            return form.constant() == 0
        number = -form.get(1, 0)
        byte = "{}.{}".format(*self.operand_byte(form + known(number)))
        return self.equal[byte] == number if byte in self.equal else self.answer((byte, number))

    def load(self, d, pointer, displacement):
        if not isinstance(pointer, Pointer):
            raise Unprovable("a number is taken for a pointer")
        component, index = divmod(pointer.offset + displacement, self.kernel.size)
        if not 0 <= component < self.kernel.components:
            raise Unprovable("a load from beyond the operands")
        self.registers[d] = self.byte_of(pointer.operand, component, index)

    def run(self):
        address = self.kernel.entry
        for _ in range(STEPS):
            self.address = address
            self.visits[address] += 1
            self.kernel.visited.add(address)
            mnemonic, operands, target, following = self.code[address]
            if mnemonic == "ret":
                return
            address = self.step(mnemonic, operands, target, following)
            if address not in self.code:
                raise Unprovable("the code is left")
        raise Unprovable("the code does not return")

    def step(self, mnemonic, text, target, following):
        operands = [decoded(word) for word in text]
        d, r = (operands + operands + [None, None])[:2]
        read = self.number
        if mnemonic not in KEEP_FLAGS:
            self.tested = None
        if mnemonic == "nop":
            pass
        elif mnemonic in ("mul", "mulsu", "muls"):
            self.multiply(d, r, ("mul", "mulsu", "muls").index(mnemonic))
        elif mnemonic in ("add", "lsl"):
            self.add(d, r, known(0))
        elif mnemonic in ("adc", "rol"):
            self.add(d, r, self.known_carry())
        elif mnemonic == "sbc" and d == r:
            self.registers[d] = self.known_carry() * 255
        elif mnemonic in ("clr", "eor") and d == r:
            self.registers[d] = known(0)
        elif mnemonic in ("sub", "sbc"):
            self.subtract(d, read(r), self.known_carry() if mnemonic == "sbc" else known(0))
        elif mnemonic in ("subi", "sbci"):
            self.subtract(d, known(int(r, 0)), self.known_carry() if mnemonic == "sbci" else known(0))
        elif mnemonic == "lsr":
            self.rotate_right(d, known(0))
        elif mnemonic == "ror":
            self.rotate_right(d, self.known_carry())
        elif mnemonic == "ldi":
            self.registers[d] = known(int(r, 0))
        elif mnemonic == "mov":
            self.registers[d] = self.read(r)
        elif mnemonic == "movw":
            self.registers[d], self.registers[d + 1] = self.read(r), self.read(r + 1)
        elif mnemonic == "push":
            self.stack.append(self.read(d))
        elif mnemonic == "pop":
            if not self.stack:
                raise Unprovable("pop of an empty stack")
            self.registers[d] = self.stack.pop()
        elif mnemonic in ("ld", "ldd") and r in ("X+", "Z+"):
            low = 26 if r == "X+" else 30
            pointer = self.read(low)
            self.load(d, pointer, 0)
            self.registers[low] = Pointer(pointer.operand, pointer.offset + 1)
        elif mnemonic in ("ld", "ldd") and r.startswith("Z"):
            self.load(d, self.read(30), int(r[2:] or "0"))
        elif mnemonic in ("adiw", "sbiw"):
            pointer = self.read(d)
            if not isinstance(pointer, Pointer):
                raise Unprovable("adiw of a number")
            change = int(r, 0) if mnemonic == "adiw" else -int(r, 0)
            self.registers[d] = Pointer(pointer.operand, pointer.offset + change)
            self.carry = None
        elif mnemonic in ("clt", "set"):
            self.transfer = mnemonic == "set"
        elif mnemonic in ("brts", "brtc"):
            if self.transfer is None:
                raise Unprovable("T is read before it is set")
            return target if self.transfer == (mnemonic == "brts") else following
        elif mnemonic in ("tst", "and") and d == r:
            self.tested = read(d)
        elif mnemonic in ("brpl", "brmi"):
            if self.tested is None:
                raise Unprovable("a sign is read before it is set")
            return target if self.is_negative(self.tested) == (mnemonic == "brmi") else following
        elif mnemonic in ("sbrs", "sbrc") and r == "7":
            if self.is_negative(read(d)) == (mnemonic == "sbrs"):
                return self.code[following][3]
        elif mnemonic == "dec":
            self.registers[d] = self.tested = known(read(d).constant() - 1)
        elif mnemonic in ("breq", "brne"):
            if self.tested is None:
                raise Unprovable("Z is read before it is set")
            return target if self.is_zero(self.tested) == (mnemonic == "breq") else following
        elif mnemonic == "cpi":
            self.tested, self.carry = read(d) - known(int(r, 0)), None
        elif mnemonic == "rjmp":
            return target
        else:
            raise Unprovable(f"{mnemonic} is not modelled")
        return following

    def cone(self, form):
        """The variables on which those of the form depend, and the facts that define them."""
        waiting, needed, facts = set(form) - {1}, set(), {}
        while waiting:
            name = waiting.pop()
            needed.add(name)
            if name in self.facts:
                fact = self.facts[name]
                facts[id(fact)] = fact
                waiting |= set(fact[1]) - {1} - needed
        return needed, list(facts.values())

    def conclude(self):
        if self.stack:
            raise Unprovable("the stack does not balance")
        if self.registers[1] != known(0):
            raise Unprovable("r1 is not zero at return")
        for n in CALL_SAVED:
            if self.registers[n] != self.before[n]:
                raise Unprovable(f"r{n} is not kept")
        rest = self.kernel.exact_sum(self)
        rest = rest - self.kernel.result(self) * (1 << self.kernel.fraction)
        for byte, number in self.equal.items():
            rest += (known(number) - Form({byte: 1})) * rest.get(byte, 0)
        modulus = 1 << self.kernel.fraction + 8 * self.kernel.size
        half = modulus // 2
        rest = Form({name: (factor + half) % modulus - half for name, factor in rest.items()
                     if factor % modulus})
        self.decide(rest)

    def decide(self, rest):
        largest = 256 << -(-self.kernel.fraction // 8) * 8
        if any(abs(factor) > largest for name, factor in rest.items()
               if name != 1 and self.ranges[name] == 255):
            raise Unprovable("a byte of a product is not where it ought to be")
        needed, facts = self.cone(rest)
        # Paths that differ in the upper bytes alone leave the same question.
        question = repr((sorted(rest.items(), key=str), sorted(facts, key=str)))
        if question in self.kernel.answered:
            return
        solver = z3.SolverFor("QF_LRA")
        for low, form, high in (*((0, {name: 1}, self.ranges[name]) for name in needed), *facts):
            solver.add(at_least(low, tuple(form.items())), at_most(high, tuple(form.items())))

        def impossible(statement):
            solver.push()
            solver.add(statement)
            answer = solver.check()
            solver.pop()
            return answer == z3.unsat

        # What counts more than the bytes up to an ulp, and what no instruction reads, must be a carry
        # that does not occur.
        for name in [name for name in self.ranges if name in needed]:
            counts = self.ranges[name] == 1 and abs(rest.get(name, 0)) > largest
            if counts or name.startswith("carry") and name not in self.read_carries:
                if impossible(at_least(1, ((name, 1),))):
                    solver.add(real(name) == 0)
                elif counts:
                    raise Unprovable(f"{name} counts")
        # An integer; over the rationals, these limits are the weaker ones.
        items = tuple(rest.items())
        if not (impossible(at_most(-1, items)) and impossible(at_least(1 << self.kernel.fraction, items))):
            raise Unprovable("a result that is not the nearest number is not excluded")
        self.kernel.answered.add(question)


class Undecided(Exception):
    """A test of the operands in the code whose result is not known."""


class Kernel:
    """operation_q<integer>_<fraction> of numbers of `size` bytes, or operation_u... of those without a
    sign."""

    def __init__(self, operation, integer, fraction, letter="q"):
        self.operation, self.fraction, self.is_signed = operation, fraction, letter == "q"
        self.size = (integer + fraction) // 8
        self.name = f"{operation}_{letter}{integer}_{fraction}"
        self.components = {"dot2": 2, "dot3": 3}.get(operation, 1)
        self.in_memory = operation.startswith("dot")
        first = self.first = 26 - (self.size + 1) // 2 * 2  # arguments take an even number of registers
        self.a, self.b = range(first, first + self.size), range(2 * first - 26, 2 * first - 26 + self.size)
        self.c = range(3 * first - 52, 3 * first - 52 + self.size)
        self.entry = None
        self.visited = set()   # addresses
        self.answered = set()  # queries whose answer is that the result is right

    def place_operands(self, machine):
        registers = machine.registers
        if self.in_memory:
            registers[24], registers[25] = Pointer("a"), None
            registers[22], registers[23] = Pointer("b"), None
            return
        for i in range(self.size):
            registers[self.a[i]] = machine.byte_of("a", 0, i)
            registers[self.b[i]] = machine.byte_of("b", 0, i)
            if self.operation == "multiply_add":
                registers[self.c[i]] = machine.byte_of("c", 0, i)

    def exact_sum(self, machine):
        """And half an ulp."""
        total = known(1 << self.fraction >> 1)
        for component in range(self.components):
            for i in range(self.size):
                for j in range(self.size):
                    product = ((f"a{component}", i), (f"b{component}", j))
                    value = machine.products.get(product)
                    if value is None:
                        value = self.product_by_known(machine, *product)
                    if value is None:
                        # Of either sign.
                        value = machine.variable(f"product {component} {i}.{j}", 1 << 17) + known(-1 << 16)
                    total += value * (1 << 8 * (i + j))
        if self.operation == "multiply_add":
            for i in range(self.size):
                total += Form({f"c0.{i}": 1 << self.fraction + 8 * i})
        return total

    def product_by_known(self, machine, *factors):
        """Where a byte is known: of a highest one, 255 is -1."""
        for (operand, index), other in (factors, factors[::-1]):
            number = machine.equal.get(f"{operand}.{index}")
            if number is not None:
                signed = number - 256 if machine.is_top((operand, index)) and number > 127 else number
                byte = Form({"{}.{}".format(*other): 1})
                if machine.is_top(other):
                    byte -= machine.variable(f"{other[0]} negative", 1) * 256
                return byte * signed
        return None

    def result(self, machine):
        total = Form()
        for i in range(self.size):
            total += machine.number(self.first + i) * (1 << 8 * i)
        return total

    def prove(self, code, answers=()):
        machine = Machine(self, code, answers)
        try:
            machine.run()
        except Undecided as question:
            for holds in (False, True):
                self.prove(code, (*answers, (question.args[0], holds)))
            return
        machine.conclude()


# For three right shifts, the rationals are too weak: prove_split_products has those of multiply.
KERNELS = [Kernel(operation, *split)
           for operation, splits in [
               ("multiply", [*SPLITS_16, *SPLITS_24, *SPLITS_32, (32, 32)]),
               ("multiply_add", [(8, 16), (12, 12), (16, 16), (8, 24)]),
               ("dot2", [(8, 8), (8, 16), (12, 12), (16, 16), (8, 24), (32, 32)]),
               ("dot3", [(8, 8), (8, 16), (12, 12), (16, 16), (8, 24), (32, 32)])]
           for split in splits if split[1] % 8 != 3]
KERNELS += [Kernel("multiply", *split, "u") for split in [*SPLITS_16, *SPLITS_32] if split[1] % 8 != 3]

# The number of instructions of which a sample is left out, spread evenly over a kernel: all of them
# in short kernels. The macros of the others contain instructions that some splits do not need.
MUTATIONS = {"multiply_q8_8": 99, "multiply_q8_16": 99, "multiply_q12_12": 12, "multiply_q16_16": 99,
             "multiply_u8_8": 99, "multiply_u16_16": 99, "multiply_u8_24": 8, "multiply_q8_24": 12,
             "multiply_q32_32": 8, "multiply_add_q16_16": 99, "dot2_q16_16": 99, "dot3_q8_16": 30,
             "dot3_q16_16": 3, "dot3_q8_24": 8, "dot3_q32_32": 8}


# What chooses the shorter of two ways: the longer one returns the same.
CHOICES = ("breq", "cpi", "rjmp")


def assembled(folder):
    sources = sorted({*(SOURCE / "fixedpoint/avr").glob("multiply*.S"),
                      *(SOURCE / "fixedpoint/avr").glob("dot_[23q]*.S")})
    elf = f"{folder}/products.elf"
    subprocess.run(["avr-gcc", "-mmcu=atmega2560", "-nostartfiles", "-nostdlib", "-I", SOURCE, "-o", elf,
                    "-Wl,--no-gc-sections", *sources], check=True)
    return disassemble(elf)


def survivors(kernel, code, count):
    """The instructions without which the proof still succeeds, among `count` that are left out."""
    addresses = sorted(a for a in kernel.visited if code[a][0] not in ("ret", *CHOICES))
    found = []
    for address in addresses[::-(-len(addresses) // count) * SAMPLE]:
        mutated = dict(code)
        mutated[address] = ("nop", [], None, code[address][3])
        try:
            kernel.prove(mutated)
            found.append(f"{address:#x} {code[address][0]} {', '.join(code[address][1])}")
        except Unprovable:
            pass
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--kernel", metavar="NAME", choices=[kernel.name for kernel in KERNELS],
                        help="only this one, such as multiply_q16_16")
    chosen = parser.parse_args().kernel
    with tempfile.TemporaryDirectory() as folder:
        functions, code = assembled(folder)
    failed = False
    for kernel in KERNELS:
        if chosen not in (None, kernel.name):
            continue
        kernel.entry = functions[f"fixedpoint_{kernel.name}"]
        try:
            kernel.prove(code)
        except Unprovable as reason:
            print(f"{kernel.name}: not proven: {reason}", file=sys.stderr)
            failed = True
            continue
        print(f"{kernel.name}: proven for all operands")
        if kernel.name in MUTATIONS:
            for instruction in survivors(kernel, code, MUTATIONS[kernel.name]):
                print(f"{kernel.name}: proven without {instruction}, too", file=sys.stderr)
                failed = True
    return failed


if __name__ == "__main__":
    sys.exit(main())
