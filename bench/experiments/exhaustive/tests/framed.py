# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiled C++ with its data on the stack: the frame and what pointers point to, at fixed addresses."""
import re

import z3

from calling import A64, Bits, Compiled, shown
from machine_code import demand

STACK = 0x0800  # the stack pointer at the entry of a function
LOW = {"X": 26, "Y": 28, "Z": 30}
# Of libgcc, for counts in r16 below 64; `shift_of` proves them.
SHIFTS = {"__ashldi3": lambda x, n: x << n, "__lshrdi3": z3.LShR}


def pointed(word):
    """The pointer of a load or store: its lower register, what is added before and after, and the offset."""
    name, sign, offset = re.fullmatch(r"-?([XYZ])(\+?)(\d*)", word).groups()
    return LOW[name], -(word[0] == "-"), int(sign == "+" and not offset), int(offset or 0)


def single_bit(condition):
    """That a bit is not 0 as that it is 1, and so on."""
    inner, inverted = (condition.arg(0), True) if z3.is_not(condition) else (condition, False)
    if not z3.is_eq(inner) or not z3.is_bv(inner.arg(0)) or inner.arg(0).size() != 1 or not z3.is_bv_value(inner.arg(1)):
        return condition
    value = inner.arg(1).as_long() ^ 1
    return z3.Not(inner.arg(0) == value) if not inverted else inner.arg(0) == value


def constant(number, size):
    return [z3.BitVecVal(number >> 8 * i & 255, 8) for i in range(size)]


def shift_of(name, m, count):
    """It changes no other registers but r0."""
    m.registers[16] = z3.BitVecVal(count, 8)
    m.saved[16] = m.registers[16]
    exact, before = SHIFTS[name](m.number(*A64), z3.BitVecVal(count, 64)), m.registers.copy()

    def check(m, _):
        shown(m, m.number(*A64) == exact, *(m.registers[n] == before[n] for n in range(1, 32) if n not in range(18, 26)))
    return check


class Framed(Compiled):
    """`bytes` has the memory by address. `effects` has, by name of the functions that are not followed, what they do to it."""
    effects = {}

    def __init__(self, called, program):
        super().__init__(called, program)
        self.shifts = {program.labels[name]: exact for name, exact in SHIFTS.items() if name in program.labels}
        self.bytes, self.decided = {}, []

    def copy(self):
        other = super().copy()
        other.bytes = self.bytes.copy()
        return other

    def word(self, low):
        number = z3.simplify(self.number(low, 2))
        demand(z3.is_bv_value(number), "a pointer depends on the operands")
        return number.as_long()

    def place(self, low, *parts):
        """The bytes in registers from `low` on."""
        for i, byte in enumerate(parts):
            self.registers[low + i] = byte

    def store(self, address, number):
        for i in range(number.size() // 8):
            self.bytes[address + i] = z3.Extract(8 * i + 7, 8 * i, number)

    def loaded(self, address, size):
        demand(all(address + i in self.bytes for i in range(size)), "a byte of memory is read before it is set")
        return z3.Concat(*(self.bytes[address + i] for i in reversed(range(size))))

    def branch(self, condition, target, following):
        """What was decided before is not decided again."""
        condition, opposite = (z3.simplify(each) for each in (condition, z3.Not(condition)))
        if any(known.eq(condition) for known in self.decided):
            return [(target, self)]
        if any(known.eq(opposite) for known in self.decided):
            return [(following, self)]
        found = super().branch(condition, target, following)
        if len(found) == 2:
            for (_, machine), known in zip(found, (condition, opposite)):
                machine.decided = [*self.decided, known, z3.simplify(single_bit(known))]
        return found

    def step(self, address):
        mnemonic, _, target, following = self.program.code[address]
        if mnemonic == "call" and target in self.shifts:
            count = self.registers[16]
            shown(self, z3.ULT(count, 64))
            shifted = z3.simplify(self.shifts[target](self.number(*A64), z3.ZeroExt(56, count)))
            self.place(18, *(z3.Extract(8 * i + 7, 8 * i, shifted) for i in range(8)))
            self.registers[0], self.flags = z3.FreshConst(z3.BitVecSort(8)), {}
            return [(following, self)]
        if mnemonic == "call" and target in self.called and self.called[target][0] in self.effects:
            pointers = self.effects[self.called[target][0]](self)
            found = super().step(address)
            name, given, result = self.calls[-1]
            self.calls[-1] = name, [*given, *pointers], result
            return found
        return super().step(address)

    def compute(self, mnemonic, d, r, target, following):
        registers, advance = self.registers, [(following, self)]
        if mnemonic == "in":
            value = {"0x3d": STACK & 255, "0x3e": STACK >> 8}.get(r)
            registers[d] = z3.FreshConst(z3.BitVecSort(8)) if value is None else z3.BitVecVal(value, 8)
            return advance
        if mnemonic in ("out", "cli"):
            return advance
        if mnemonic in ("adiw", "sbiw"):
            number, change = self.number(d, 2), int(r, 0)
            value = z3.simplify(number + change if mnemonic == "adiw" else number - change)
            registers[d], registers[d + 1] = z3.simplify(z3.Extract(7, 0, value)), z3.simplify(z3.Extract(15, 8, value))
            carry = z3.ULT(value, number) if mnemonic == "adiw" else z3.ULT(number, change)
            self.flags |= {"C": z3.simplify(carry), "Z": value == 0, "N": value < 0, "V": None}
            return advance
        if mnemonic in ("st", "std", "ld", "ldd"):
            pointer, register = (d, r) if mnemonic.startswith("st") else (r, d)
            low, before, after, offset = pointed(pointer)
            at = self.word(low) + before
            if mnemonic.startswith("st"):
                self.bytes[at + offset] = registers[register]
            else:
                demand(at + offset in self.bytes, "a byte of memory is read before it is set")
                registers[register] = self.bytes[at + offset]
            if before or after:
                self.place(low, *constant(at + after, 2))
            return advance
        found = Bits.compute(self, mnemonic, d, r, target, following)
        for _, machine in found:
            if isinstance(d, int):
                machine.registers[d] = z3.simplify(machine.registers[d])
            for flag, value in machine.flags.items():
                if value is not None:
                    machine.flags[flag] = z3.simplify(value)
        return found
