# SPDX-License-Identifier: MIT
"""Machine code and proofs about it: one stretch at a time, then again with instructions left out,
which takes longer than the proof. Of those that a program names, a run therefore leaves out a sample;
if the environment has EVERY_INSTRUCTION, all of them."""

import copy
import os
import re
import subprocess
import sys
import tempfile
from functools import cache
from itertools import chain, product
from pathlib import Path

CALL_SAVED = [*range(2, 18), 28, 29]
STEPS = 200  # more steps than any stretch takes
SAMPLE = 1 if os.environ.get("EVERY_INSTRUCTION") else 4  # one instruction in this many
FEWER = 97   # if an instruction is left out, only one in this many numbers is run


class Unprovable(Exception):
    pass


def demand(holds, otherwise="a result is not what it ought to be"):
    if not holds:
        raise Unprovable(otherwise)


def disassemble(elf):
    """{address: (mnemonic, operands, target, following address)} of each function."""
    text = subprocess.run(["avr-objdump", "-d", "--no-show-raw-insn", elf], check=True,
                          capture_output=True, text=True).stdout
    functions, code = {}, {}
    for line in text.splitlines():
        if label := re.match(r"([0-9a-f]+) <(\w+)>:", line):
            functions[label[2]] = int(label[1], 16)
        elif instruction := re.match(r"\s*([0-9a-f]+):\t(\w+)\t?([^;]*)(?:; 0x([0-9a-f]+))?", line):
            address, mnemonic, operands, target = instruction.groups()
            code[int(address, 16)] = (mnemonic, re.split(r",\s*", operands.strip()),
                                      target and int(target, 16))
    addresses = [*sorted(code), None]
    following = dict(zip(addresses, addresses[1:]))
    return functions, {address: (*code[address], following[address]) for address in code}


@cache
def operand(word):
    return int(word[1:]) if re.fullmatch(r"r\d+", word) else word


class Machine:
    """One path through a stretch of code. Derived classes define the contents of registers and the
    instructions that compute with them (`compute`)."""

    def __init__(self, program, registers):
        self.program, self.registers = program, registers
        self.saved = {n: registers[n] for n in CALL_SAVED}
        self.stack, self.transfer = [], None
        self.forked = False
        self.passed = frozenset()  # addresses where the path has forked
        self.visited = []

    def copy(self):
        other = copy.copy(self)
        other.registers, other.stack, other.visited = self.registers.copy(), self.stack[:], self.visited[:]
        return other

    def step(self, address):
        """The addresses that may follow, each with the machine there."""
        mnemonic, text, target, following = self.program.code[address]
        operands = [operand(word) for word in text]
        d, r = (operands + operands + [None, None])[:2]
        registers = self.registers
        if mnemonic == "mov":
            registers[d] = registers[r]
        elif mnemonic == "movw":
            registers[d], registers[d + 1] = registers[r], registers[r + 1]
        elif mnemonic == "push":
            self.stack.append(registers[d])
        elif mnemonic == "pop":
            demand(self.stack and not isinstance(self.stack[-1], int), "the stack does not balance")
            registers[d] = self.stack.pop()
        elif mnemonic in ("rcall", "call"):
            self.stack.append(following)
            following = target
        elif mnemonic == "ret":
            demand(not self.stack or isinstance(self.stack[-1], int), "the stack does not balance")
            following = self.stack.pop() if self.stack else None
        elif mnemonic in ("rjmp", "jmp"):
            following = target
        elif mnemonic != "nop":
            return self.compute(mnemonic, d, r, target, following)
        return [(following, self)]


def linked(folder, sources):
    """Kernels and tables, as one program."""
    elf, source = f"{folder}/kernel.elf", Path(__file__).parent.parent / "src"
    subprocess.run(["avr-gcc", "-mmcu=atmega328p", "-nostartfiles", "-nostdlib", "-I", source, "-o", elf,
                    "-Wa,--keep-locals", "-Wl,--no-gc-sections,--discard-none",
                    *(source / f"fixedpoint/avr/{name}.S" for name in sources)], check=True)
    return elf


class Program:
    """The machine code of an ELF or of kernels, and stretches of it: (label, begin, ends, saved, cases,
    transfers), the last two where there are several cases, each the arguments of `begin`, and of T. `saved` are
    the registers on the stack; where one stands for several that held the same, all of them. Proofs that run
    numbers take every `stride`-th."""
    stride = 1
    suspect = None  # the case to begin with: without the instruction before, it failed

    def __init__(self, stretches, machine, elf=None, sources=(), cuts=()):
        """`cuts`: (name, label, mnemonic, operand) of places after a label that do not have a label
        themselves."""
        with tempfile.TemporaryDirectory() as folder:
            elf = elf or linked(folder, sources)
            symbols = subprocess.run(["avr-nm", "--defined-only", elf], check=True, capture_output=True, text=True).stdout
            subprocess.run(["avr-objcopy", "-O", "binary", "-j", ".text", elf, f"{folder}/flash"], check=True)
            self.flash = Path(f"{folder}/flash").read_bytes()
            self.code = disassemble(elf)[1]
        self.labels = {name: int(address, 16) for address, _, name in map(str.split, symbols.splitlines())}
        for name, label, mnemonic, operand in cuts:
            address = self.labels[label]
            while self.code[address][0] != mnemonic or operand not in self.code[address][1]:
                address = self.code[address][3]
            self.labels[name] = address
        self.machine, self.stretches = machine, stretches
        self.cuts = {self.labels[label]: label for label, *_ in stretches}
        # (register, others that held the same)
        self.saved = {label: [place if isinstance(place, tuple) else (place,) for place in saved]
                      for label, _, _, saved, *_ in stretches} | {None: ()}

    def prove(self, label, begin, ends, _, cases=((),), transfers=(False, True)):
        """Proves the stretch after a label; returns the addresses on feasible paths."""
        visited = set()
        for case, transfer in sorted(product(cases, transfers), key=lambda each: each != self.suspect):
            self.tried = case, transfer
            start = self.machine(self)
            start.transfer = transfer
            for first, *others in self.saved[label]:
                start.stack.append(start.saved[first])
                start.saved |= {other: start.saved[first] for other in others}
            check = begin(start, *case)
            waiting = self.follow(self.labels[label], start)
            while waiting:
                address, machine = waiting.pop()
                if address is not None and address not in self.cuts:
                    if address not in self.code:
                        raise Unprovable("the code is left")
                    waiting += self.follow(address, machine)
                elif not machine.forked or machine.possible([]):
                    visited.update(machine.visited)
                    end = self.cuts.get(address)
                    demand(end in ends)
                    check(machine, end)
                    pushed = self.saved[end]
                    for first, *others in pushed:
                        for other in others:
                            if machine.saved[other] is not machine.saved[first]:
                                machine.show((0, machine.saved[other] - machine.saved[first], 0))
                    demand(machine.stack == [machine.saved[first] for first, *_ in pushed])
                    demand(all(machine.registers[n] == machine.saved[n] for n in CALL_SAVED if n not in chain(*pushed)))
                    demand(end is not None or machine.is_zero(1))
        demand(visited, "no path can be")
        return visited

    @staticmethod
    def follow(address, machine):
        """One step. A path that reaches a fork again continues only if that is feasible."""
        again = address in machine.passed
        machine.visited.append(address)
        demand(len(machine.visited) < STEPS, "a loop does not end")
        following = machine.step(address)
        if len(following) > 1:
            for _, after in following:
                after.passed = machine.passed | {address}
        return [(target, after) for target, after in following if not again or after.feasible()]

    def survivors(self, stretch, visited, every, needless):
        """Instructions without which the proof still succeeds."""
        found, self.stride = [], FEWER
        for address in sorted(visited)[::every]:
            mnemonic, operands, target, following = self.code[address]
            if mnemonic in needless:
                continue
            self.code[address] = ("nop", [], None, following)
            try:
                self.prove(*stretch)
                found.append(f"{address:#x} {mnemonic} {', '.join(operands)}")
            except Unprovable:
                self.suspect = self.tried
            self.code[address] = (mnemonic, operands, target, following)
        self.stride, self.suspect = 1, None
        return found

    def run(self, every, needless, labels=None):
        """Proves every stretch, or those after the given labels, then leaves out a sample of every
        `every`th instruction; returns whether anything failed."""
        failed = False
        for stretch in self.stretches if labels is None else [each for each in self.stretches if each[0] in labels]:
            try:
                visited = self.prove(*stretch)
            except Unprovable as reason:
                print(f"{stretch[0]}: not proven: {reason}", file=sys.stderr)
                failed = True
                continue
            print(f"{stretch[0]}: proven", flush=True)
            for instruction in self.survivors(stretch, visited, every * SAMPLE, needless):
                print(f"{stretch[0]}: proven without {instruction}, too", file=sys.stderr, flush=True)
                failed = True
        return failed
