# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiled C++ as vectors of bits: of the functions that it calls, only the operands are known."""
import sys
from pathlib import Path

import z3

sys.path.insert(0, str(Path(__file__).resolve().parents[4] / "fixedpoint/tests"))
import machine_code  # noqa: E402
from bits import Bits  # noqa: E402
from machine_code import CALL_SAVED, demand  # noqa: E402

machine_code.STEPS = 600  # more than any path of these takes
FRAME = {"in", "out", "cli"}
A64, B64 = (18, 8), (10, 8)
# A function of libgcc, which `sums` proves.
SUMS = {"__adddi3": lambda a, b: a + b, "__subdi3": lambda a, b: a - b}


def sum_of(name, m):
    """For two 64-bit numbers; it changes no other registers."""
    exact, before = SUMS[name](m.number(*A64), m.number(*B64)), m.registers.copy()

    def check(m, _):
        shown(m, m.number(*A64) == exact)
        demand(all(m.registers[n] is before[n] for n in range(32) if n not in range(18, 26)))
    return check


class Compiled(Bits):
    """`called` has, by name of the functions that are not followed, the operands as (lowest register, bytes) and the number
    of bytes of the result, which ends in r25. `calls` has the name, the operands and the result of each call. If there is
    a frame, Y points to it, and `frame` contains its bytes."""

    def __init__(self, called, program):
        super().__init__(program)
        self.sums = {program.labels[name]: exact for name, exact in SUMS.items() if name in program.labels}
        self.called = {program.labels[name]: (name, *what) for name, what in called.items() if name in program.labels}
        self.calls, self.frame, self.has_frame = [], {}, False

    def copy(self):
        other = super().copy()
        other.calls, other.frame = self.calls[:], self.frame.copy()
        return other

    def step(self, address):
        mnemonic, _, target, following = self.program.code[address]
        if mnemonic == "call" and target in self.sums:
            total = z3.simplify(self.sums[target](z3.simplify(self.number(*A64)), z3.simplify(self.number(*B64))))
            for i in range(8):
                self.registers[18 + i] = z3.Extract(8 * i + 7, 8 * i, total)
            self.flags = {}
            return [(following, self)]
        if mnemonic != "call" or target not in self.called:
            return super().step(address)
        name, operands, size = self.called[target]
        demand(self.is_zero(1))
        given = [self.number(*place) for place in operands]
        kept = {n: self.registers[n] for n in (1, *CALL_SAVED)}
        unique = f"{name}.{len(self.calls)}"
        self.registers = {n: z3.BitVec(f"{unique}.r{n}", 8) for n in range(32)} | kept
        self.flags = {}
        result = self.number(26 - size, size)
        self.calls.append((name, given, result))
        return [(following, self)]

    def compute(self, mnemonic, d, r, target, following):
        registers = self.registers
        if mnemonic in FRAME or mnemonic in ("sbiw", "adiw") and d == 28:
            # To set up the frame and to release it.
            self.has_frame = True
            if mnemonic == "in" and d in (28, 29):
                registers[d] = z3.BitVec(f"frame.r{d}", 8)
            return [(following, self)]
        if mnemonic == "std" and d.startswith("Y+") and self.has_frame:
            self.frame[int(d[2:])] = registers[r]
            return [(following, self)]
        if mnemonic == "ldd" and self.has_frame and r.startswith("Y+"):
            demand(int(r[2:]) in self.frame, "a byte of the frame is read before it is set")
            registers[d] = self.frame[int(r[2:])]
            return [(following, self)]
        return super().compute(mnemonic, d, r, target, following)


def shown(machine, *conditions):
    demand(all(machine.impossible(z3.Not(condition)) for condition in conditions))
