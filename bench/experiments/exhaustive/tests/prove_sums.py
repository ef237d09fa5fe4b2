#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Proves for all pairs of operands that sums and their like are exact: the device programs' machine
code, every register a vector of bits, by z3.

usage: prove_sums.py FOLDER    that of the device programs

Then instructions are left out in turn, and each time the proof must fail."""
import re
import sys
from pathlib import Path

import z3

sys.path.insert(0, str(Path(__file__).resolve().parents[4] / "fixedpoint/tests"))
from prove_products import CALL_SAVED, Unprovable, disassemble  # noqa: E402

WIDTHS = {"q16_16": 32, "q8_24": 32}


def clamped(exact, width):
    low, high = -(1 << width - 1), (1 << width - 1) - 1
    return z3.If(exact < low, z3.BitVecVal(low, width + 2),
                 z3.If(exact > high, z3.BitVecVal(high, width + 2), exact))


def magnitude(a):
    return z3.If(a < 0, -a, a)


# Of operands two bits wider than they are; the result is the lower bits.
EXACT = {
    ("add", "default"): lambda a, b, width: a + b,
    ("subtract", "default"): lambda a, b, width: a - b,
    ("add", "saturating"): lambda a, b, width: clamped(a + b, width),
    ("subtract", "saturating"): lambda a, b, width: clamped(a - b, width),
    ("abs_diff", "default"): lambda a, b, width: magnitude(a - b),
    ("copysign", "default"): lambda a, b, width: z3.If((a < 0) != (b < 0), ~a + 1, a),
    # (a + b) / 2 rounded up, as a + b = 2 (a | b) - (a ^ b): what both have counts twice.
    ("midpoint", "default"): lambda a, b, width: (a | b) - ((a ^ b) >> 1),
}


class State:
    """One path."""

    def __init__(self):
        self.registers = [z3.BitVec(f"r{n}", 8) for n in range(32)]
        self.registers[1] = z3.BitVecVal(0, 8)
        self.begin = list(self.registers)
        self.stack, self.holds = [], []
        self.C = self.Z = self.N = self.V = self.T = None

    def copy(self):
        other = State.__new__(State)
        other.__dict__ = dict(self.__dict__)
        other.registers, other.stack, other.holds = self.registers[:], self.stack[:], self.holds[:]
        return other

    def result(self, value, zero=None):
        self.N, self.Z = value < 0, value == 0 if zero is None else z3.And(zero, value == 0)
        return value

    def add(self, x, y, carry):
        wide = z3.ZeroExt(2, x) + z3.ZeroExt(2, y) + carry
        value = z3.Extract(7, 0, wide)
        self.C = z3.UGT(wide, 255)
        self.V = z3.And((x < 0) == (y < 0), (x < 0) != (value < 0))
        return self.result(value)

    def subtract(self, x, y, borrow, zero=None):
        wide = z3.ZeroExt(2, x) - z3.ZeroExt(2, y) - borrow
        value = z3.Extract(7, 0, wide)
        self.C = wide < 0
        self.V = z3.And((x < 0) != (y < 0), (x < 0) != (value < 0))
        return self.result(value, zero)

    def shift_right(self, value, top):
        self.C = z3.Extract(0, 0, value) == 1
        return self.result(z3.Concat(top, z3.Extract(7, 1, value)))


def bit(flag):
    return z3.If(flag, z3.BitVecVal(1, 10), z3.BitVecVal(0, 10))


BRANCHES = {"brcs": lambda s: s.C, "brcc": lambda s: z3.Not(s.C), "breq": lambda s: s.Z, "brne": lambda s: z3.Not(s.Z),
            "brmi": lambda s: s.N, "brpl": lambda s: z3.Not(s.N), "brvs": lambda s: s.V, "brvc": lambda s: z3.Not(s.V),
            "brlt": lambda s: z3.Xor(s.N, s.V), "brge": lambda s: z3.Not(z3.Xor(s.N, s.V)),
            "brts": lambda s: s.T, "brtc": lambda s: z3.Not(s.T)}


class Program:
    def __init__(self, elf):
        self.functions, self.code = disassemble(elf)

    def paths(self, name):
        """The states in which the function returns."""
        waiting, visited = [(self.functions[name], State())], set()
        returned = []
        while waiting:
            address, state = waiting.pop()
            visited.add(address)
            if address not in self.code or len(state.holds) > 100:
                raise Unprovable("the code is left")
            for following, after in self.step(address, state):
                (returned if following is None else waiting).append((following, after))
        return [state for _, state in returned], visited

    def step(self, address, s):
        mnemonic, text, target, following = self.code[address]
        words = [int(word[1:]) if re.fullmatch(r"r\d+", word) else word for word in text]
        d, r = (words + [None, None])[:2]
        registers, none = s.registers, z3.BitVecVal(0, 10)
        number = z3.BitVecVal(int(r, 0), 8) if isinstance(r, str) and re.fullmatch(r"(0x)?[0-9A-Fa-f]+", r) else None
        if mnemonic in ("add", "adc"):
            registers[d] = s.add(registers[d], registers[r], bit(s.C) if mnemonic == "adc" else none)
        elif mnemonic in ("sub", "cp"):
            value = s.subtract(registers[d], registers[r], none)
            registers[d] = value if mnemonic == "sub" else registers[d]
        elif mnemonic in ("sbc", "cpc"):
            value = s.subtract(registers[d], registers[r], bit(s.C), s.Z)
            registers[d] = value if mnemonic == "sbc" else registers[d]
        elif mnemonic in ("subi", "cpi"):
            value = s.subtract(registers[d], number, none)
            registers[d] = value if mnemonic == "subi" else registers[d]
        elif mnemonic == "sbci":
            registers[d] = s.subtract(registers[d], number, bit(s.C), s.Z)
        elif mnemonic == "neg":
            registers[d] = s.subtract(z3.BitVecVal(0, 8), registers[d], none)
        elif mnemonic in ("inc", "dec"):
            carry = s.C
            change = s.add if mnemonic == "inc" else s.subtract
            registers[d], s.C = change(registers[d], z3.BitVecVal(1, 8), none), carry
        elif mnemonic == "com":
            registers[d], s.C, s.V = s.result(~registers[d]), z3.BoolVal(True), z3.BoolVal(False)
        elif mnemonic in ("and", "or", "eor", "andi", "ori"):
            x, y = registers[d], registers[r] if number is None else number
            value = {"and": x & y, "or": x | y, "eor": x ^ y}[mnemonic.removesuffix("i") if number is not None else mnemonic]
            registers[d], s.V = s.result(z3.simplify(value)), z3.BoolVal(False)
        elif mnemonic in ("lsr", "asr", "ror"):
            top = {"lsr": z3.BitVecVal(0, 1), "asr": z3.Extract(7, 7, registers[d]),
                   "ror": z3.If(s.C, z3.BitVecVal(1, 1), z3.BitVecVal(0, 1)) if s.C is not None else None}[mnemonic]
            registers[d] = s.shift_right(registers[d], top)
            s.V = None
        elif mnemonic == "ldi":
            registers[d] = number
        elif mnemonic == "mov":
            registers[d] = registers[r]
        elif mnemonic == "movw":
            registers[d], registers[d + 1] = registers[r], registers[r + 1]
        elif mnemonic == "bst":
            s.T = z3.Extract(int(r), int(r), registers[d]) == 1
        elif mnemonic == "bld":
            mask = 1 << int(r)
            registers[d] = z3.If(s.T, registers[d] | mask, registers[d] & (255 - mask))
        elif mnemonic == "push":
            s.stack.append(registers[d])
        elif mnemonic == "pop":
            if not s.stack or isinstance(s.stack[-1], int):
                raise Unprovable("the stack does not balance")
            registers[d] = s.stack.pop()
        elif mnemonic in ("call", "rcall"):
            s.stack.append(following)
            return [(target, s)]
        elif mnemonic == "ret":
            if s.stack and not isinstance(s.stack[-1], int):
                raise Unprovable("the stack does not balance")
            return [(s.stack.pop() if s.stack else None, s)]
        elif mnemonic in ("rjmp", "jmp"):
            return [(target, s)]
        elif mnemonic in BRANCHES or mnemonic in ("sbrs", "sbrc"):
            if mnemonic in BRANCHES:
                taken = BRANCHES[mnemonic](s)
            else:
                taken = z3.Extract(int(r), int(r), registers[d]) == (1 if mnemonic == "sbrs" else 0)
                target = self.code[following][3]
            found = []
            for condition, place in ((taken, target), (z3.Not(taken), following)):
                condition = z3.simplify(condition)
                if not z3.is_false(condition):
                    after = s.copy()
                    after.holds.append(condition)
                    found.append((place, after))
            return found
        elif mnemonic != "nop":
            raise Unprovable(f"{mnemonic} is not modelled")
        return [(following, s)]

    def prove(self, name, exact, width):
        """Returns the addresses that were visited."""
        states, visited = self.paths(name)
        size = width // 8
        first = 26 - max(size, 2)

        def number(registers, low):
            parts = [registers[low + i] for i in reversed(range(size))]
            return z3.Concat(*parts) if size > 1 else parts[0]

        a, b = (z3.SignExt(2, number(State().begin, low)) for low in (first, 2 * first - 26))
        wanted = z3.Extract(width - 1, 0, exact(a, b, width))
        for state in states:
            solver = z3.SolverFor("QF_BV")
            solver.add(*state.holds)
            kept = [state.registers[n] == state.begin[n] for n in CALL_SAVED]
            solver.add(z3.Not(z3.And(number(state.registers, first) == wanted, state.registers[1] == 0, *kept)))
            if solver.check() != z3.unsat:
                raise Unprovable("a result is not what it ought to be")
        return visited

    def survivors(self, name, exact, width, visited):
        for address in sorted(visited):
            mnemonic, operands, target, following = self.code[address]
            if mnemonic == "ret":
                continue
            self.code[address] = ("nop", [], None, following)
            try:
                self.prove(name, exact, width)
                yield f"{address:#x} {mnemonic} {', '.join(operands)}"
            except (Unprovable, z3.Z3Exception, TypeError, AttributeError):
                pass
            self.code[address] = (mnemonic, operands, target, following)


def main():
    folder, failed = Path(sys.argv[1]), False
    for number_format, width in WIDTHS.items():
        for suffix in ("", "_auxiliary"):
            program = Program(folder / f"{number_format}{suffix}.elf")
            for (operation, implementation), exact in EXACT.items():
                name = f"{operation}_{number_format}_{implementation}"
                if name not in program.functions:
                    continue
                try:
                    visited = program.prove(name, exact, width)
                except Unprovable as reason:
                    print(f"{name}: not proven: {reason}", file=sys.stderr)
                    failed = True
                    continue
                print(f"{name}: proven for all operands", flush=True)
                if implementation != "default":  # The compiler's code holds some that change nothing.
                    continue
                for instruction in program.survivors(name, exact, width, visited):
                    print(f"{name}: proven without {instruction}, too", file=sys.stderr)
                    failed = True
    return failed


if __name__ == "__main__":
    sys.exit(main())
