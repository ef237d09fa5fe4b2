# SPDX-License-Identifier: MIT
"""Proofs about machine code by running it for every case: registers contain numbers, or arrays of
them."""

import numpy

from machine_code import Machine, Unprovable, demand

CHAINED = ("adc", "sbc", "sbci", "cpc", "ror")
BRANCHES = {"brcs": ("carry", 1), "brcc": ("carry", 0), "breq": ("tested", 0), "brne": ("tested", 1),
            "brmi": ("sign", 1), "brpl": ("sign", 0)}


class Arrays(Machine):
    """If a branch separates the cases, each path continues with its own; `given` are arrays that
    are split with them."""

    def __init__(self, program):
        super().__init__(program, {n: f"r{n}" for n in range(32)})
        self.flash = numpy.frombuffer(program.flash, dtype=numpy.uint8)
        self.carry = self.tested = self.sign = None
        self.given = {}

    def untouched(self, register):
        return isinstance(self.registers[register], str) and self.registers[register] == f"r{register}"

    def number(self, registers):
        demand(not any(isinstance(self.registers[register], str) for register in registers))
        return sum(self.registers[register] * (1 << 8 * i) for i, register in enumerate(registers))

    def place(self, numbers, registers):
        """The bytes of the numbers, the lowest first."""
        for i, register in enumerate(registers):
            self.registers[register] = (numbers >> 8 * i & 255).astype(numpy.int32)

    def try_all(self, numbers, place, idle):
        """Every number in the registers `place`; a check that it is still there, and that `idle`
        are unchanged."""
        self.given["tried"] = numbers
        self.place(numbers, place)

        def same(m):
            demand((m.number(place) == m.given["tried"]).all() and m.transfer is None)
            demand(all(m.untouched(register) for register in idle))
        return same

    def is_zero(self, register):
        return isinstance(self.registers[register], int) and self.registers[register] == 0

    def possible(self, _):
        return True

    def feasible(self):
        return True

    def of(self, cases):
        def part(value):
            return value[cases] if isinstance(value, numpy.ndarray) else value
        other = self.copy()
        other.registers = {n: part(value) for n, value in self.registers.items()}
        other.given = {name: part(value) for name, value in self.given.items()}
        other.carry, other.tested, other.sign = part(self.carry), part(self.tested), part(self.sign)
        return other

    def fork(self, target, following, taken):
        if not isinstance(taken, numpy.ndarray) or taken.all() or not taken.any():
            return [(target if numpy.all(taken) else following, self)]
        return [(target, self.of(taken)), (following, self.of(~taken))]

    def keep(self, register, value):
        self.tested = self.sign = value & 255
        if register is not None:
            self.registers[register] = self.tested

    def compute(self, mnemonic, d, r, target, following):
        registers, before = self.registers, self.tested
        if mnemonic in BRANCHES:
            name, wanted = BRANCHES[mnemonic]
            flag = getattr(self, name)
            demand(flag is not None, "a flag is read before it is set")
            flag = flag >> 7 if name == "sign" else flag
            return self.fork(target, following, (flag != 0) if wanted else (flag == 0))
        if mnemonic in ("sec", "clc", "set", "clt"):
            name = "carry" if mnemonic[2] == "c" else "transfer"
            setattr(self, name, int(mnemonic[0] == "s"))
            return [(following, self)]
        if mnemonic in ("brts", "brtc"):
            demand(self.transfer is not None)
            return [(target if self.transfer == (mnemonic == "brts") else following, self)]
        if mnemonic == "lpm":
            demand(not isinstance(registers[31], str) and not isinstance(registers[30], str))
            place = registers[31] * 256 + registers[30]
            demand(numpy.max(place) < len(self.flash))
            registers[d] = self.flash[place].astype(numpy.int32)
            return [(following, self)]
        carry = self.carry if mnemonic in CHAINED else 0
        demand(carry is not None)
        y = registers[r] if isinstance(r, int) else int(r or "0", 0)
        x = registers[d]
        demand(mnemonic == "ldi" or mnemonic == "eor" and d == r or not isinstance(y, str) and not isinstance(x, str))
        if mnemonic in ("sbrs", "sbrc"):
            return self.fork(self.program.code[following][3], following, (x >> y & 1) == (mnemonic == "sbrs"))
        if mnemonic == "ldi":
            registers[d] = y
        elif mnemonic == "eor" and d == r:
            registers[d] = self.tested = self.sign = 0
        elif mnemonic in ("inc", "dec"):
            self.keep(d, x + (1 if mnemonic == "inc" else -1))
        elif mnemonic in ("or", "and", "andi", "eor"):
            self.keep(d, x | y if mnemonic == "or" else x ^ y if mnemonic == "eor" else x & y)
        elif mnemonic == "com":
            self.keep(d, 255 - x)
            self.carry = 1
        elif mnemonic == "neg":
            self.keep(d, -x)
            self.carry = (x != 0) * 1
        elif mnemonic in ("lsr", "ror"):
            self.carry, value = x & 1, x >> 1 | carry * 128
            self.keep(d, value)
        elif mnemonic == "swap":
            registers[d] = x >> 4 | x << 4 & 255
        elif mnemonic == "sbiw":
            value = x + registers[d + 1] * 256 - y
            registers[d], registers[d + 1], self.carry, self.tested, self.sign = value & 255, value >> 8 & 255, None, None, None
        elif mnemonic in ("mul", "mulsu", "fmul"):
            value = (x - (x >> 7) * 256 if mnemonic == "mulsu" else x) * y << (mnemonic == "fmul")
            registers[0], registers[1], self.carry = value & 255, value >> 8 & 255, None
        elif mnemonic in ("add", "adc", "sub", "sbc", "subi", "sbci", "cp", "cpc", "cpi"):
            value = x + (y + carry) * (1 if mnemonic.startswith("ad") else -1)
            self.carry = value >> 8 & 1
            self.keep(None if mnemonic.startswith("cp") else d, value)
        else:
            raise Unprovable(f"{mnemonic} is not modelled")
        if mnemonic in ("sbc", "sbci", "cpc"):
            self.tested = None if before is None else before | self.tested
        return [(following, self)]
