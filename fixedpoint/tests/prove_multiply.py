#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Proves that the Q16.16 multiply kernel returns floor(a b / 2^16 + 1/2) modulo 2^32 for all 2^64
pairs of operands.

usage: prove_multiply.py [ELF]    without ELF the kernel is assembled with avr-gcc

The kernel is straight code. Its disassembly is executed with every register holding a linear form:
an integer combination of the bytes that multiplications return and of carry flags, both integer
variables. A multiplication is not looked into: whatever byte of a and byte of b it takes, its two
result bytes and its carry are variables, and they make up the product. The exact a b is a linear
form of the 16 products too; a3 b3, which is not formed, has the weight 2^48. What remains is one
statement about integers without products of variables,

    0 <= (a b + 2^15 - 2^16 result) mod 2^48 < 2^16,

which z3 decides. It says that the result is right modulo 2^32. Then every instruction is left out
in turn, and the proof must fail each time.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

import z3

CALL_CLOBBERED = {0, 1, *range(18, 28), 30, 31}
SYMBOL = "fixedpoint_multiply_q16_16"
SOURCE = pathlib.Path(__file__).parent.parent / "src"
MODULUS = 1 << 48


class Unprovable(Exception):
    pass


class Form(dict):
    """Integer combination of variables; the key 1 holds the constant."""

    def __add__(self, other):
        total = Form(self)
        for name, factor in other.items():
            total[name] = total.get(name, 0) + factor
        return total

    def __mul__(self, factor):
        return Form({name: factor * value for name, value in self.items()})

    def term(self):
        return z3.Sum([value * (1 if name == 1 else z3.Int(name))
                       for name, value in self.items()] + [z3.IntVal(0)])


def variable(name):
    return Form({name: 1})


class Machine:
    def __init__(self):
        self.registers = {}
        for i in range(4):
            self.registers[22 + i] = variable(f"a{i}")
            self.registers[18 + i] = variable(f"b{i}")
        self.registers[1] = Form()
        self.carry = None
        self.products = {}  # "a1b2": its value as a form
        self.constraints = []
        self.count = 0

    def fresh(self, kind, low, high):
        self.count += 1
        name = f"{kind}_{self.count}"
        self.constraints += [low <= z3.Int(name), z3.Int(name) <= high]
        return variable(name)

    def read(self, register):
        if register not in self.registers:
            raise Unprovable(f"r{register} is read before it is set")
        return self.registers[register]

    def operand(self, register):
        form = self.read(register)
        names = [name for name, factor in form.items() if factor]
        if len(names) != 1 or form[names[0]] != 1 or not re.fullmatch(r"[ab][0-3]", str(names[0])):
            raise Unprovable(f"r{register} does not hold a byte of an operand")
        return names[0]

    def multiply(self, d, r, d_signed):
        x, y = self.operand(d), self.operand(r)
        if x[0] == y[0]:
            raise Unprovable("bytes of the same operand are multiplied")
        low, high = self.fresh("low", 0, 255), self.fresh("high", 0, 255)
        carry = self.fresh("sign", 0, 1)
        if d_signed and x not in ("a3", "b3") or d_signed and y in ("a3", "b3"):
            raise Unprovable("mulsu takes the wrong byte as the signed one")
        unsigned_range = (0, 255 * 255)
        signed_range = (-128 * 255, 127 * 255)
        signs = [byte for byte in (x, y) if byte in ("a3", "b3")]
        product = "".join(sorted((x, y)))
        # As a number: low + 256 high, less 2^16 where a signed product is negative.
        value = low + high * 256
        if d_signed:
            value = value + carry * -65536
        elif signs:
            if len(signs) == 2:
                raise Unprovable("a3 b3 is not expected")
            # Unsigned product of a byte that counts as signed: 256 times the other byte too much
            # where the byte is negative, an integer of its own.
            value = value + self.fresh("excess", 0, 255) * -256
        bounds = signed_range if signs else unsigned_range
        if product in self.products:
            raise Unprovable(f"{product} is formed twice")
        self.products[product] = value
        self.constraints += [bounds[0] <= value.term(), value.term() <= bounds[1],
                             (high.term() >= 128) == (carry.term() == 1)]
        self.registers[0], self.registers[1], self.carry = low, high, carry

    def add(self, d, r, with_carry):
        if with_carry and self.carry is None:
            raise Unprovable("the carry is read before it is set")
        total = self.read(d) + self.read(r) + (self.carry if with_carry else Form())
        carry = self.fresh("carry", 0, 1)
        self.registers[d] = total + carry * -256
        self.constraints += [self.registers[d].term() >= 0, self.registers[d].term() <= 255]
        self.carry = carry

    def step(self, mnemonic, registers):
        d, r = (registers + registers)[:2]
        if mnemonic == "mul":
            self.multiply(d, r, False)
        elif mnemonic == "mulsu":
            self.multiply(d, r, True)
        elif mnemonic in ("add", "lsl"):
            self.add(d, r, False)
        elif mnemonic in ("adc", "rol"):
            self.add(d, r, True)
        elif mnemonic == "sbc" and d == r:
            if self.carry is None:
                raise Unprovable("the carry is read before it is set")
            self.registers[d] = self.carry * 255
        elif mnemonic in ("clr", "eor") and d == r:
            self.registers[d] = Form()
        elif mnemonic == "mov":
            self.registers[d] = self.read(r)
        elif mnemonic == "movw":
            self.registers[d], self.registers[d + 1] = self.read(r), self.read(r + 1)
        else:
            raise Unprovable(f"{mnemonic} is not modelled")


def prove(instructions):
    if not instructions or instructions[-1][0] != "ret":
        raise Unprovable("the kernel does not end in ret")
    machine = Machine()
    for mnemonic, registers in instructions[:-1]:
        machine.step(mnemonic, registers)
    if any(machine.registers[1].values()):
        raise Unprovable("r1 is not zero at return")
    if not CALL_CLOBBERED.issuperset(machine.registers):
        raise Unprovable("a call-saved register is changed")
    rest = Form({1: 1 << 15})
    for i in range(4):
        for j in range(4):
            product = f"a{i}b{j}"
            value = machine.products.get(product, variable(product))
            rest += value * (1 << 8 * (i + j))
    for i in range(4):
        rest += machine.read(22 + i) * -(1 << 16 + 8 * i)
    half = MODULUS // 2
    rest = Form({name: (factor + half) % MODULUS - half for name, factor in rest.items()})
    solver = z3.Solver()
    solver.set("timeout", 60000)
    solver.add(machine.constraints)
    quotient, remainder = z3.Ints("quotient remainder")
    solver.add(rest.term() == MODULUS * quotient + remainder, 1 << 16 <= remainder,
               remainder < MODULUS)
    answer = solver.check()
    if answer != z3.unsat:
        raise Unprovable("a result that is not the nearest number is not excluded"
                         if answer == z3.sat else "z3 gives up")


def disassemble(elf):
    text = subprocess.run(["avr-objdump", "-d", "--no-show-raw-insn", elf], check=True,
                          capture_output=True, text=True).stdout
    body = re.search(rf"<{SYMBOL}>:\n((?: .*\n)+)", text)
    if not body:
        sys.exit(f"{elf}: has no function {SYMBOL}")
    instructions = []
    for line in body.group(1).splitlines():
        mnemonic, _, operands = line.split("\t", 1)[1].split(";")[0].strip().partition("\t")
        instructions.append((mnemonic, [int(n) for n in re.findall(r"r(\d+)", operands)]))
        if mnemonic == "ret":
            break
    return instructions


def main():
    with tempfile.TemporaryDirectory() as folder:
        elf = sys.argv[1] if len(sys.argv) > 1 else f"{folder}/multiply.o"
        if len(sys.argv) < 2:
            subprocess.run(["avr-gcc", "-mmcu=atmega328p", "-I", SOURCE, "-c", "-o", elf,
                            SOURCE / "fixedpoint/avr/multiply_q16_16.S"], check=True)
        instructions = disassemble(elf)
    try:
        prove(instructions)
    except Unprovable as reason:
        sys.exit(f"not proven: {reason}")
    survivors = []
    for index in range(len(instructions)):
        try:
            prove(instructions[:index] + instructions[index + 1:])
            survivors.append(index)
        except Unprovable:
            pass
    if survivors:
        sys.exit(f"instructions that the proof does not need: {survivors}")
    print(f"{SYMBOL}: proven for all operands; each of its {len(instructions)} instructions is "
          "needed")


if __name__ == "__main__":
    main()
