# SPDX-License-Identifier: MIT
"""Proofs about machine code that adds, compares and shifts: every register is a vector of bits, by z3."""

import z3

from machine_code import Machine, Unprovable, demand

# For this code, quicker than what z3 chooses itself.
DECIDE = z3.Then("simplify", "solve-eqs", "bit-blast", "sat")
ANSWERED = z3.AstMap()  # questions; kernels and paths have many in common
NONE = z3.BitVecVal(0, 10)
POINTERS = {"X": 26, "X+": 26, "Y+": 28, "Z+": 30}
CHAINED = ("adc", "sbc", "sbci", "cpc", "ror")
BRANCHES = {"brcs": ("C", True), "brcc": ("C", False), "breq": ("Z", True), "brne": ("Z", False),
            "brmi": ("N", True), "brpl": ("N", False), "brvs": ("V", True), "brvc": ("V", False),
            "brlt": ("S", True), "brge": ("S", False), "brts": ("T", True), "brtc": ("T", False)}


def joined(m, registers):
    """The number in the registers, the lowest first."""
    return z3.Concat(*(m.registers[register] for register in reversed(registers)))


def same(m, registers):
    """A check that the registers are as they are now, for bits or forms."""
    before = {register: m.registers[register] for register in registers}

    def check(m):
        demand(all(m.registers[register] is form or isinstance(form, z3.ExprRef) and form.eq(m.registers[register])
                   for register, form in before.items()))
    return check


class Bits(Machine):
    """Registers of bits; what is known about them is a list of conditions."""
    returns_in_memory = False
    looked_up = 128  # bytes of a table

    def __init__(self, program):
        super().__init__(program, {n: z3.BitVec(f"r{n}", 8) for n in range(32)})
        self.registers[1] = z3.BitVecVal(0, 8)
        self.holds, self.stored = [], []  # conditions; (address, byte)
        self.memory = []  # bytes from address 0 on
        self.flags = {}

    def copy(self):
        other = super().copy()
        other.holds, other.stored, other.flags = self.holds[:], self.stored[:], self.flags.copy()
        return other

    def is_zero(self, register):
        return self.impossible(self.registers[register] != 0)

    def impossible(self, condition):
        question = z3.And(*self.holds, condition)
        if question not in ANSWERED:
            solver = DECIDE.solver()
            solver.add(question)
            ANSWERED[question] = z3.BoolVal(solver.check() == z3.unsat)
        return z3.is_true(ANSWERED[question])

    def possible(self, given):
        return not self.impossible(z3.And(*given))

    def feasible(self):
        return self.possible([])

    def number(self, low, size):
        parts = [self.registers[low + i] for i in reversed(range(size))]
        return z3.Concat(*parts) if size > 1 else parts[0]

    def flag(self, name):
        demand(self.flags.get(name) is not None, "a flag is read before it is set")
        return self.flags[name]

    def result(self, value, **flags):
        self.flags |= {"N": value < 0, "Z": value == 0} | flags
        return value

    def sum(self, x, y, carry):
        wide = z3.ZeroExt(2, x) + z3.ZeroExt(2, y) + carry
        value = z3.Extract(7, 0, wide)
        return self.result(value, C=z3.UGT(wide, 255), V=z3.And((x < 0) == (y < 0), (x < 0) != (value < 0)))

    def difference(self, x, y, borrow):
        wide = z3.ZeroExt(2, x) - z3.ZeroExt(2, y) - borrow
        value = z3.Extract(7, 0, wide)
        return self.result(value, C=wide < 0, V=z3.And((x < 0) != (y < 0), (x < 0) != (value < 0)))

    def pointer(self, name):
        """The pointer of a load or store."""
        low = POINTERS[name]
        place = z3.simplify(self.number(low, 2))
        if name[1:] == "+":
            self.registers[low], self.registers[low + 1] = z3.Extract(7, 0, place + 1), z3.Extract(15, 8, place + 1)
        return place

    def look_up(self):
        """A lookup in a table of runs of equal bytes, such as the powers of two that shift a byte
        left."""
        page = z3.simplify(self.registers[31])
        demand(z3.is_bv_value(page))
        value, table = z3.FreshConst(z3.BitVecSort(8)), self.program.flash[page.as_long() << 8:]
        for i in range(1, self.looked_up):
            if i == self.looked_up - 1 or table[i] != table[i + 1]:
                first = next(j for j in range(1, i + 1) if table[j:i + 1] == bytes([table[i]]) * (i + 1 - j))
                inside = z3.And(z3.UGE(self.registers[30], first), z3.ULE(self.registers[30], i))
                value = z3.If(inside, z3.BitVecVal(table[i], 8), value)
        return value

    def branch(self, condition, target, following):
        self.forked, found = True, []
        for holds, place in ((condition, target), (z3.Not(condition), following)):
            holds = z3.simplify(holds)
            if not z3.is_false(holds):
                after = self.copy()
                after.holds.append(holds)
                found.append((place, after))
        return found

    def compute(self, mnemonic, d, r, target, following):
        registers = self.registers
        if mnemonic in BRANCHES:
            name, is_set = BRANCHES[mnemonic]
            flag = z3.Xor(self.flag("N"), self.flag("V")) if name == "S" else self.flag(name)
            return self.branch(flag == is_set, target, following)
        if mnemonic in ("sbrs", "sbrc"):
            is_set = z3.Extract(int(r), int(r), registers[d]) == 1
            return self.branch(is_set == (mnemonic == "sbrs"), self.program.code[following][3], following)
        if mnemonic == "cpse":
            return self.branch(registers[d] == registers[r], self.program.code[following][3], following)
        if mnemonic == "mul":
            value = z3.simplify(z3.ZeroExt(8, registers[d]) * z3.ZeroExt(8, registers[r]))
            registers[0], registers[1] = z3.Extract(7, 0, value), z3.Extract(15, 8, value)
            self.flags |= {"C": value < 0, "Z": value == 0}
            return [(following, self)]
        if mnemonic == "st":
            demand(self.returns_in_memory and d in POINTERS)
            self.stored.append((self.pointer(d), registers[r]))
            return [(following, self)]
        if mnemonic == "ld":
            place = self.pointer(r)
            demand(z3.is_bv_value(place) and place.as_long() < len(self.memory), "what is read is not of the vector")
            registers[d] = self.memory[place.as_long()]
            return [(following, self)]
        if mnemonic == "lpm":
            demand(r == "Z", "lpm moves the pointer")
            registers[d] = self.look_up()
            return [(following, self)]
        if mnemonic in ("adiw", "sbiw"):
            change, carry, zero = self.sum if mnemonic == "adiw" else self.difference, NONE, True
            for register, y in ((d, z3.BitVecVal(int(r, 0), 8)), (d + 1, z3.BitVecVal(0, 8))):
                registers[register] = change(registers[register], y, carry)
                carry = z3.If(self.flags["C"], z3.BitVecVal(1, 10), NONE)
                zero = self.flags["Z"] = z3.And(zero, self.flags["Z"])
            return [(following, self)]
        if mnemonic == "swap":
            registers[d] = z3.RotateLeft(registers[d], 4)
            return [(following, self)]
        if mnemonic in ("clc", "sec", "clt", "set"):
            self.flags["C" if mnemonic.endswith("c") else "T"] = z3.BoolVal(mnemonic.startswith("se"))
            return [(following, self)]
        x, y = registers[d], registers[r] if isinstance(r, int) else z3.BitVecVal(int(r or "0", 0), 8)
        carry = z3.If(self.flag("C"), z3.BitVecVal(1, 10), NONE) if mnemonic in CHAINED else NONE
        if mnemonic in ("add", "adc"):
            registers[d] = self.sum(x, y, carry)
        elif mnemonic in ("sub", "sbc", "subi", "sbci", "cp", "cpc", "cpi"):
            zero = self.flag("Z") if mnemonic in CHAINED else True
            value = self.difference(x, y, carry)
            self.flags["Z"] = z3.And(zero, self.flags["Z"])
            registers[d] = x if mnemonic.startswith("cp") else value
        elif mnemonic == "neg":
            registers[d] = self.difference(z3.BitVecVal(0, 8), x, NONE)
        elif mnemonic in ("inc", "dec"):
            kept = self.flags.get("C")
            registers[d] = (self.sum if mnemonic == "inc" else self.difference)(x, z3.BitVecVal(1, 8), NONE)
            self.flags["C"] = kept
        elif mnemonic == "com":
            registers[d] = self.result(~x, C=z3.BoolVal(True), V=z3.BoolVal(False))
        elif mnemonic in ("and", "andi", "or", "ori", "eor"):
            value = {"and": x & y, "or": x | y, "eor": x ^ y}[mnemonic.removesuffix("i")]
            registers[d] = self.result(z3.simplify(value), V=z3.BoolVal(False))
        elif mnemonic in ("lsr", "asr", "ror"):
            top = z3.Extract(7, 7, x) if mnemonic == "asr" else z3.Extract(0, 0, carry)
            value, out = z3.Concat(top, z3.Extract(7, 1, x)), z3.Extract(0, 0, x) == 1
            registers[d] = self.result(value, C=out, V=z3.Xor(value < 0, out))
        elif mnemonic == "ldi":
            registers[d] = y
        elif mnemonic == "bst":
            self.flags["T"] = z3.Extract(int(r), int(r), x) == 1
        elif mnemonic == "bld":
            mask = 1 << int(r)
            registers[d] = z3.If(self.flag("T"), x | mask, x & (255 - mask))
        else:
            raise Unprovable(f"{mnemonic} is not modelled")
        return [(following, self)]
