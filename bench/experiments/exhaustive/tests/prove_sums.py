#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Proves for all operands that sums and similar operations are exact: z3 examines the machine code of the device
programs, with every register a vector of bits. multiply_add and lerp call a product kernel that
fixedpoint/prove_products proves, and quotients and remainders of 24 bits call those of Q16.16, proven by
fixedpoint/prove_quotients and prove_remainders: here the kernel's result may be any number, but its operands must be
right.

usage: prove_sums.py FOLDER    the folder of the device programs

Then instructions of 32-bit functions are left out in turn, and each time the proof must fail; for multiply_add and lerp,
whose compiled code contains instructions that change nothing, it may succeed without a third of them, which are
printed."""
import sys
from functools import partial
from pathlib import Path

import z3

sys.path.insert(0, str(Path(__file__).resolve().parents[4] / "fixedpoint/tests"))
from bits import Bits  # noqa: E402
from machine_code import CALL_SAVED, Program, demand  # noqa: E402

WIDTHS = {"q16_16": 32, "q8_24": 32, "q8_16": 24, "q12_12": 24, "q32_32": 64}


def saturated(exact, width):
    low, high = (z3.BitVecVal(number, exact.size()) for number in (-(1 << width - 1), (1 << width - 1) - 1))
    return z3.If(exact < low, low, z3.If(exact > high, high, exact))


def magnitude(a):
    return z3.If(a < 0, -a, a)


# By the program of a format; on operands extended by two bits: the result is the lower bits.
EXACT = {
    "": {
        "add_{}_default": lambda a, b, width: a + b,
        "subtract_{}_default": lambda a, b, width: a - b},
    "_angles": {
        "add_{}_saturating": lambda a, b, width: saturated(a + b, width),
        "subtract_{}_saturating": lambda a, b, width: saturated(a - b, width)},
    "_auxiliary": {
        "abs_diff_{}_default": lambda a, b, width: magnitude(a - b),
        "copysign_{}_default": lambda a, b, width: z3.If((a < 0) != (b < 0), ~a + 1, a),
        # (a + b) / 2 rounded up, since a + b = 2 (a | b) - (a ^ b): common bits count twice.
        "midpoint_{}_default": lambda a, b, width: (a | b) - ((a ^ b) >> 1)},
}


class Calling(Bits):
    """Does not follow calls of the kernels `called`, one after the other: name, number of operands, and their width.
    `calls` are the operands and the result of each; with more than two operands, minus the sum of the others."""

    def __init__(self, called, program):
        super().__init__(program)
        self.called, self.calls = called, []

    def copy(self):
        other = super().copy()
        other.calls = self.calls[:]
        return other

    def step(self, address):
        mnemonic, _, target, following = self.program.code[address]
        if target not in [self.program.labels[name] for name, *_ in self.called]:
            return super().step(address)
        demand(mnemonic == "call" and len(self.calls) < len(self.called) and self.is_zero(1))
        name, count, width = self.called[len(self.calls)]
        demand(target == self.program.labels[name])
        operands, result = [self.number(low, width // 8) for low in places(width, count)], z3.BitVec(f"{name}.result", width)
        kept = {n: self.registers[n] for n in (1, *CALL_SAVED)}
        self.registers = {n: z3.BitVec(f"{name}.r{n}", 8) for n in range(32)} | kept
        self.flags = {}
        self.calls.append((operands, result))
        total = result + sum(operands[2:])
        for i in range(width // 8):
            self.registers[places(width, 1)[0] + i] = z3.Extract(8 * i + 7, 8 * i, total)
        return [(following, self)]

    def all_calls(self):
        demand(len(self.calls) == len(self.called))
        return self.calls


def places(width, count):
    """The lowest registers of operands, each of which takes an even number."""
    return [26 - (width + 8) // 16 * 2 * (i + 1) for i in range(count)]


def multiply_add(width, _, machine):
    a, b, c = (machine.number(low, width // 8) for low in places(width, 3))

    def check(machine, end):
        (factors, product), = machine.all_calls()
        demand(machine.impossible(z3.Not(z3.And(
            factors[0] == a, factors[1] == b, machine.number(places(width, 1)[0], width // 8) == product + c))))
    return check


def lerp(width, fraction, machine):
    """a + t (b - a) / 2^F, rounded, where b - a = d + s 2^W, d has W bits and s is -1, 0 or 1: t d / 2^F, rounded, plus
    a + s t 2^(W-F), an integer."""
    a, b, t = (machine.number(low, width // 8) for low in places(width, 3))
    d = b - a
    s = z3.Extract(width, width, z3.SignExt(2, b) - z3.SignExt(2, a) - z3.SignExt(2, d))

    def check(machine, end):
        (factors, product), = machine.all_calls()
        whole = z3.If(s == 0, z3.BitVecVal(0, width), z3.If(b < a, -t, t) << width - fraction)
        demand(machine.impossible(z3.Not(z3.And(
            factors[0] == t, factors[1] == d,
            machine.number(places(width, 1)[0], width // 8) == product + a + whole))))
    return check


def quotient(_, fraction, machine):
    """Of 24 bits: that of a and b 2^(16-F) in Q16.16, saturated."""
    a, b = (z3.SignExt(8, machine.number(low, 3)) for low in places(24, 2))

    def check(machine, end):
        (operands, result), = machine.all_calls()
        demand(machine.impossible(z3.Not(z3.And(
            operands[0] == a, operands[1] == b << 16 - fraction,
            machine.number(places(24, 1)[0], 3) == z3.Extract(23, 0, saturated(result, 24))))))
    return check


def remainder(_, fraction, machine):
    """Of 24 bits: that of 32 bits, which is smaller than b or is a."""
    numbers = [z3.SignExt(8, machine.number(low, 3)) for low in places(24, 2)]

    def check(machine, end):
        (operands, result), = machine.all_calls()
        demand(machine.impossible(z3.Not(z3.And(
            *(number == operand for number, operand in zip(numbers, operands)),
            machine.number(places(24, 1)[0], 3) == z3.Extract(23, 0, result)))))
    return check


EVERY = 3
FIRST_ONLY = 1 << 20  # instruction
# (program, function, check, called kernel, fraction bits)
OF_PRODUCTS = [("q8_8", "multiply_add_q8_8_default", multiply_add, ("fixedpoint_multiply_q8_8", 2, 16), 8),
               ("q8_8_auxiliary", "lerp_q8_8_default", lerp, ("fixedpoint_multiply_q8_8", 2, 16), 8),
               ("q16_16_auxiliary", "lerp_q16_16_default", lerp, ("fixedpoint_multiply_add_q16_16", 3, 32), 16),
               ("q8_24_auxiliary", "lerp_q8_24_default", lerp, ("fixedpoint_multiply_add_q8_24", 3, 32), 24),
               ("q8_16_auxiliary", "lerp_q8_16_default", lerp, ("fixedpoint_multiply_add_q8_16", 3, 24), 16),
               ("q12_12_auxiliary", "lerp_q12_12_default", lerp, ("fixedpoint_multiply_add_q12_12", 3, 24), 12),
               *((name, f"{operation}_{name}_default", function,
                  (f"fixedpoint_{operation}_q16_16", 2, 32), fraction)
                 for name, fraction in (("q8_16", 16), ("q12_12", 12))
                 for operation, function in (("divide", quotient), ("remainder", remainder)))]


def operands(exact, width, machine):
    size = width // 8
    first, second = places(width, 2)
    a, b = (z3.SignExt(2, machine.number(low, size)) for low in (first, second))
    wanted = z3.Extract(width - 1, 0, exact(a, b, width))

    def check(machine, end):
        demand(machine.impossible(machine.number(first, size) != wanted))
    return check


def main():
    failed = False
    for number_format, width in WIDTHS.items():
        for suffix, functions in EXACT.items():
            if width == 64 and suffix == "_angles":
                continue  # These sums are in memory.
            stretches = [(name.format(number_format), partial(operands, exact, width), (None,), (), ((),), (None,))
                         for name, exact in functions.items()]
            program = Program(stretches, Bits, elf=Path(sys.argv[1]) / f"{number_format}{suffix}.elf")
            failed |= program.run(1 if width == 32 else FIRST_ONLY, ("ret",))
    for program, name, exact, called, fraction in OF_PRODUCTS:
        stretch = name, partial(exact, called[2], fraction), (None,), (), ((),), (None,)
        program = Program([stretch], partial(Calling, [called]), elf=Path(sys.argv[1]) / f"{program}.elf")
        visited = program.prove(*stretch)
        # Compiled code contains instructions that change nothing.
        found = program.survivors(stretch, visited, EVERY, ("ret",))
        print(f"{name}: proven; of {len(visited)} instructions one in {EVERY} was left out, without effect {found}")
        failed |= 3 * EVERY * len(found) > len(visited)
    return failed


if __name__ == "__main__":
    sys.exit(main())
