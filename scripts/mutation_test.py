#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the tests: builds deliberate faults into a copy of the sources, one at a time, and demands
that a certain test of the suite fails. Exit status 0 only when every fault was caught."""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent


class Fault(NamedTuple):
    what: str
    path: str
    original: str  # stands in the file exactly once
    replacement: str
    test: str  # regular expression of ctest
    target: str = None  # what is to be built for it; nothing where the test reads the sources

    @classmethod
    def on_device(cls, what, path, original, replacement, program):
        """One that the library's own tests find on the simulated chip."""
        return cls(what, f"fixedpoint/src/fixedpoint/{path}", original, replacement,
                   f"LibraryOnDevice.*/{program}", program)


FAULTS = [
    Fault.on_device("rounding bit of the Q16.16 product", "avr/multiply_q16_16.inc",
                    "    lsl s1              // rounds", "    clc",
                    "operators_test_q16_16"),
    Fault.on_device("carry into the top byte of the Q16.16 product", "avr/multiply_q16_16.inc",
                    "    adc t4, s4\n    adc t5, b3", "    adc t4, s4\n    add t5, b3",
                    "operators_test_q16_16"),
    Fault.on_device("entry of the Q4.4 square roots, one too large", "avr/sqrt_q4_4_table.S",
                    ".byte  16,  16,", ".byte  17,  16,",
                    "functions_test_q4_4"),
    Fault.on_device("sign of the sine in the third quadrant", "avr/sin_q16_16.S",
                    "    sbrs quadrant, 1", "    sbrc quadrant, 1",
                    "constant_functions_test_q16_16"),
    Fault("comparison that rounds a tie of quotients",
          "fixedpoint/src/fixedpoint/portable/divide.hpp",
          "static_cast<Unsigned<Raw>>(quotient + (tie_upward ? rest >= other",
          "static_cast<Unsigned<Raw>>(quotient + (tie_upward ? rest > other",
          "^fixedpoint/fixed_test$", "fixed_test"),
    Fault("clamp of positive quotients", "fixedpoint/src/fixedpoint/integer.hpp",
          "return magnitude > limit ? RawLimits<Raw>::max : static_cast<Raw>(magnitude);",
          "return static_cast<Raw>(magnitude);",
          "^fixedpoint/fixed_test$", "fixed_test"),
    Fault.on_device("overflow of a difference that is not seen", "portable/add_saturating.hpp",
                    "(a ^ b) & (a ^ difference)", "(a ^ b) & (b ^ difference)",
                    "operators_test_q1_15"),
    Fault.on_device("clamped sum of which only the sign is right",
                    "kernel/add_saturating.hpp", "sbc %D0, %D0", "eor %D0, %D0",
                    "operators_test_q16_16"),
    Fault.on_device("digits behind a tie in decimal text", "portable/decimal_fraction.hpp",
                    "(inexact || !negative)", "!negative",
                    "text_test_q8_8"),
    Fault("generator of the sine table, another rounding", "fixedpoint/tables/sine.py",
          "HALF_ULP = 1 << 6", "HALF_ULP = 1 << 5",
          "^fixedpoint/tables$"),
    Fault("round() just below the largest integral number",
          "fixedpoint/src/fixedpoint/portable/round.hpp",
          "return n > (RawLimits<Raw>::max >> F)", "return n >= (RawLimits<Raw>::max >> F)",
          "^fixedpoint/round_test$", "round_test"),
    Fault("simulated interrupt entry without its cycles", "bench/chip/simulator/workarounds/interrupts.cpp",
          "entry_cycles = 4", "entry_cycles = 0",
          "^InterruptTest.EntryTakesFourCycles$", "simulator_tests"),
    Fault("judge that rounds ties downward", "reference/judge.cpp",
          "return floor(Number(x + scale(Number(1), -1)));",
          "return Number(-floor(Number(scale(Number(1), -1) - x)));",
          "^(Judge|Bulk)", "reference_tests"),
]


class Failure(Exception):
    """What keeps the check from meaning anything, in one line."""


def say(text):
    print(text, file=sys.stderr, flush=True)


class Copy:
    """The sources and a build of them, in a folder of their own."""

    def __init__(self, folder):
        self.source, self.build = folder / "source", folder / "build"
        shutil.copytree(ROOT, self.source,
                        ignore=shutil.ignore_patterns(".git", "build", "node_modules"))
        self.run("cmake", "-S", self.source, "-B", self.build, "-G", "Ninja",
                 "--log-level=WARNING", "-DCMAKE_BUILD_TYPE=Release")

    def run(self, *command):
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode != 0:
            say(done.stdout)
            raise Failure(f"`{' '.join(map(str, command))}` failed")

    def make(self, targets):
        if targets:
            self.run("cmake", "--build", self.build, "--target", *targets)

    def passes(self, test):
        """Whether the tests of that name pass; there must be one."""
        return subprocess.run(
            ["ctest", "--test-dir", self.build, "-R", test, "--no-tests=error", "--timeout", "60",
             "--parallel", str(os.cpu_count())],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0

    def demand_soundness(self, faults):
        """Fails unless every test passes as long as there is no fault."""
        self.make(["library_on_device_test",
                   *dict.fromkeys(fault.target for fault in faults if fault.target)])
        for test in dict.fromkeys(fault.test for fault in faults):
            if not self.passes(test):
                raise Failure(f"the test {test} fails without a fault, or is not there")

    def survives(self, fault):
        """Whether the test still passes with the fault."""
        path = self.source / fault.path
        sound = path.read_text()
        path.write_text(sound.replace(fault.original, fault.replacement))
        try:
            self.make([fault.target] if fault.target else [])
            return self.passes(fault.test)
        finally:
            path.write_text(sound)


def check(faults):
    for fault in faults:
        path = ROOT / fault.path
        count = path.read_text().count(fault.original) if path.is_file() else 0
        if count != 1:
            raise Failure(f"{fault.path}: {fault.original!r} stands there {count} times, not once")
    survivors = 0
    with tempfile.TemporaryDirectory(prefix="mutation_test_") as folder:
        say("Building a copy of the sources ...")
        copy = Copy(Path(folder))
        copy.demand_soundness(faults)
        print(f"{'fault':51}{'test':49}{'result':10}seconds")
        for fault in faults:
            start = time.monotonic()
            survived = copy.survives(fault)
            survivors += survived
            print(f"{fault.what:51}{fault.test:49}{'SURVIVED' if survived else 'caught':10}"
                  f"{time.monotonic() - start:7.1f}", flush=True)
        # So it was the fault that made a test fail.
        copy.demand_soundness(faults)
    print(f"{len(faults) - survivors} of {len(faults)} faults caught.")
    return 1 if survivors else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--fault", default="", metavar="TEXT",
                        help="only the faults whose description contains the text")
    arguments = parser.parse_args()
    faults = [fault for fault in FAULTS if arguments.fault in fault.what]
    if not faults:
        parser.error(f"no fault is described by '{arguments.fault}'")
    try:
        return check(faults)
    except Failure as failure:
        say(f"mutation_test.py: {failure}")
        return 1


if __name__ == "__main__":
    sys.exit(main())
