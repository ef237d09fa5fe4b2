#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Proves that sincos, under the policies without a kernel for it, returns the results of sin and cos, which are run over
all inputs. z3 examines the machine code of the device programs, with every register a vector of bits.

usage: prove_sincos.py FOLDER    the folder of the device programs

Then instructions are left out in turn, and each time the proof must fail.
"""
import sys
from functools import partial
from pathlib import Path

import z3

from calling import Compiled, shown
from machine_code import Program, demand

ANGLE, PLACE = (22, 4), (20, 2)
# By program: the function, and the names of the kernels.
FUNCTIONS = {"correctly_rounded_angles": ("sincos_q16_16_correctly_rounded", "fixedpoint_{}_q16_16_correctly_rounded"),
             "q16_16": ("sincos_q16_16_small", "fixedpoint_{}_q16_16_small")}


class Storing(Compiled):
    """`stored` are pairs of an address and a byte."""

    def compute(self, mnemonic, d, r, target, following):
        if mnemonic in ("st", "std") and d[0] == "Y":
            self.stored.append((self.number(28, 2) + int(d[2:] or 0), self.registers[r]))
            return [(following, self)]
        return super().compute(mnemonic, d, r, target, following)


def sincos(kernels, m):
    angle, place = m.number(*ANGLE), m.number(*PLACE)

    def check(m, _):
        demand([name for name, *_ in m.calls] == kernels and len(m.stored) == 8)
        shown(m, *(given == angle for _, (given,), _ in m.calls))
        bytes_of = [z3.Extract(8 * i + 7, 8 * i, result) for *_, result in m.calls for i in range(4)]
        shown(m, *(z3.And(address == place + i, byte == bytes_of[i]) for i, (address, byte) in enumerate(m.stored)))
    return check


def main():
    failed = False
    for program, (name, kernel) in FUNCTIONS.items():
        kernels = [kernel.format(function) for function in ("sin", "cos")]
        stretch = name, partial(sincos, kernels), (None,), (), ((),), (None,)
        machine = partial(Storing, {each: ([ANGLE], 4) for each in kernels})
        failed |= Program([stretch], machine, elf=Path(sys.argv[1]) / f"{program}.elf").run(1, ("ret",))
    return failed


if __name__ == "__main__":
    sys.exit(main())
