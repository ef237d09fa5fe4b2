#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Proves for all operands, from the instructions, that a product is rounded to nearest, half up, and saturated or
taken modulo 2^W: multiply_saturating of every split of 24 and of 32 bits except Q16.16, which has its own proof,
and multiply of the splits for which prove_products is too weak, those that shift right by three bits.

usage: prove_split_products.py [--kernel NAME]

    entry    P = floor(a b / 2^(8 f)) in the upper bytes of the sum, f = floor((F - 1) / 8)        by linear forms
    sum      floor((P + 2^(F - 8 f - 1)) / 2^(F - 8 f)), saturated or modulo 2^W                   by bits

Then instructions are left out in turn, and the proof must fail: of the kernel that is named, otherwise of one for
each way of shifting.
"""

import argparse
import sys
from itertools import product

import z3

from bits import Bits
from form import Form, known
from machine_code import Program, demand
from stretches import Signed, give_signs

# Of a kernel by the bytes of its numbers: the registers of the sum from its lowest byte on, and those on the stack.
SATURATING = {3: ((26, 27, 28, 29, 30, 31), (28, 29)), 4: ((26, 24, 30, 31, 25, 28, 29, 15), (15, 16, 17, 28, 29))}
WRAPPING = {2: ((24, 25, 26, 27), ()), 3: ((27, 26, 30, 31, 24, 27), ()),
            4: ((26, 25, 30, 31, 24, 26, 25, 30), (16, 17))}


class Kernel:
    """multiply or multiply_saturating of numbers of `size` bytes."""

    def __init__(self, operation, size, fraction, letter="q"):
        self.size, self.fraction, self.is_signed = size, fraction, letter == "q"
        self.name = f"{operation}_{letter}{8 * size - fraction}_{fraction}"
        self.entry, self.at_sum = f"fixedpoint_{self.name}", f"sum of {self.name}"
        self.source = f"{operation}_{8 * size}"
        self.saturates = operation == "multiply_saturating"
        arguments = 26 - (size + 1) // 2 * 2  # they take an even number of registers
        self.a, self.b = (range(low, low + size) for low in (arguments, 2 * arguments - 26))
        places, self.saved = (SATURATING if self.saturates else WRAPPING)[size]
        self.first = max(fraction - 1, 0) // 8
        self.sum = places[self.first:] if self.saturates else places[self.first:self.first + size + 1]

    def product(self, m, *negative):
        """From the entry to the sum."""
        m.zero(1)
        factors = [m.number(self.a), m.number(self.b)]
        if self.is_signed:
            give_signs(m, (self.a[-1], self.b[-1]), negative)
            factors = [factor - known(is_negative << 8 * self.size) for factor, is_negative in zip(factors, negative)]

        def check(m, _):
            modulus = 1 << 8 * (self.first + len(self.sum))
            rest = m.times(*factors) - m.number(self.sum) * (1 << 8 * self.first)
            rest = Form({name: (factor + modulus // 2) % modulus - modulus // 2 for name, factor in rest.items()
                         if factor % modulus})
            m.show((0, rest, (1 << 8 * self.first) - 1))
        return check

    def rounding(self, m):
        """From the sum to the return."""
        m.registers[1] = z3.BitVec("upper", 8)
        shift, bits, width = self.fraction - 8 * self.first, 8 * len(self.sum) + 2, 8 * self.size
        total = z3.SignExt(2, z3.Concat(*(m.registers[register] for register in reversed(self.sum))))
        exact = (total + (1 << shift >> 1)) >> shift
        if self.saturates:
            largest = 1 << 2 * width - 2 - 8 * self.first
            m.holds += [total >= -largest, total <= largest]
            low, high = (z3.BitVecVal(number, bits) for number in (-1 << width - 1, (1 << width - 1) - 1))
            exact = z3.If(exact < low, low, z3.If(exact > high, high, exact))

        def check(m, _):
            demand(m.impossible(m.number(self.a[0], self.size) != z3.Extract(width - 1, 0, exact)))
        return check


def programs(kernels):
    """The code of kernels in one source, to prove what follows their `entry` and their `at_sum`."""
    cuts = [(kernel.at_sum, kernel.entry, "eor", "r1") for kernel in kernels]
    sums = [(kernel.at_sum, None, (), kernel.saved) for kernel in kernels]
    entries = [(kernel.entry, kernel.product, (kernel.at_sum,), (),
                list(product((False, True), repeat=2)) if kernel.is_signed else [()], (None,)) for kernel in kernels]
    roundings = [(kernel.at_sum, kernel.rounding, (None,), kernel.saved, ((),), (None,)) for kernel in kernels]
    return [(label, Program(stretches, machine, cuts=cuts, sources=(kernels[0].source,)))
            for label, machine, stretches in (("entry", Signed, entries + sums), ("at_sum", Bits, roundings))]


KERNELS = [Kernel("multiply_saturating", size, fraction) for size, fractions in ((3, range(24)), (4, range(33)))
           for fraction in fractions if (size, fraction) != (4, 16)]
KERNELS += [Kernel("multiply", size, fraction, letter) for letter, sizes in (("q", (2, 3, 4)), ("u", (2, 4)))
            for size in sizes for fraction in range(3, 8 * size, 8)]

MUTATED = ("multiply_saturating_q8_16", "multiply_saturating_q12_12", "multiply_saturating_q23_1", "multiply_saturating_q8_24",
           "multiply_saturating_q26_6", "multiply_saturating_q15_17", "multiply_q13_3", "multiply_u5_11", "multiply_q13_11")
FIRST_ONLY = 1 << 20  # instruction


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--kernel", metavar="NAME", choices=[kernel.name for kernel in KERNELS],
                        help="only this one, such as multiply_saturating_q8_24")
    chosen = parser.parse_args().kernel
    failed = False
    for source in sorted({kernel.source for kernel in KERNELS if chosen in (None, kernel.name)}):
        kernels = [kernel for kernel in KERNELS if kernel.source == source and chosen in (None, kernel.name)]
        for label, program in programs(kernels):
            for kernel in kernels:
                every = 1 if chosen or kernel.name in MUTATED else FIRST_ONLY
                failed |= program.run(every, ("ret", "rjmp"), (getattr(kernel, label),))
    return failed


if __name__ == "__main__":
    sys.exit(main())
