#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests the tests: puts deliberate faults into the sources, one at a time, and demands that a test of
the room notices each.

The faults come from mutation operators (a comparison swapped, a carry dropped, a number one too
large, a statement left out ...) at places that a seed chooses by the text of the line, so that code
may move without another choice being made. The sources and the build tree stay as they are: a fault
goes into a copy of the sources, and the commands by which ninja builds what depends on the changed
file are repeated with their outputs elsewhere. A fault that changes no object, or that the compiler
refuses, is replaced by another and counted.

Exit status 0 only when 95% of the faults were noticed in each room and in all; a room of fewer than
20 faults may have one unnoticed."""

import argparse
import concurrent.futures
import fnmatch
import hashlib
import json
import os
import queue
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent


class Check(NamedTuple):
    """A test that should notice faults."""
    target: str  # the test program; a Python file is run directly
    cases: str = "*"  # filter of GoogleTest
    devices: str = ""  # programs for the chip that the test program runs and that contain the fault
    narrow: bool = False  # whether the Python file takes the faulty file as its argument


class Room(NamedTuple):
    """Files, how many faults they get, and the tests one of which must notice each fault."""
    name: str
    files: str  # patterns, separated by spaces; one with ! excludes
    count: int
    checks: tuple


FIXED = "fixedpoint/src/fixedpoint"
TABLES_TEST = Check("fixedpoint/tests/tables_test.py", narrow=True)


def room(name, files, count, *checks):
    return Room(name, files, count, tuple(Check(check) if isinstance(check, str) else check
                                          for check in checks))


def kernels(files, count, program, *checks):
    return room("kernels", files, count, Check("kernels_test", f"*/{program}", program), *checks)


ROOMS = [
    kernels(f"{FIXED}/avr/*_q16_16.S {FIXED}/avr/*_q16_16.inc !*/add_scaled_q16_16.S"
            " !*/dot_difference_q16_16.S !*/multiply_short_q16_16.S"
            " !*/short_factor_q16_16.inc !*/polynomial_q16_16.S !*/invert2_q16_16.S !*/biquad_q16_16.S"
            f" {FIXED}/avr/cubic_core_32.inc {FIXED}/avr/ratio_32.inc {FIXED}/avr/exp_32.inc"
            f" {FIXED}/avr/*_q16_16_small.S {FIXED}/avr/sin_polynomial.inc {FIXED}/avr/multiply_q16_16_saturating.S"
            f" {FIXED}/avr/length_long.S {FIXED}/avr/length_root.S {FIXED}/avr/sum_of_squares.inc"
            f" {FIXED}/avr/reciprocal_root.inc {FIXED}/avr/long_division.inc {FIXED}/avr/scale_40.*"
            f" {FIXED}/avr/exp_wide.S {FIXED}/avr/multiply_words.S {FIXED}/avr/multiply_upper_halves.S", 2, "q16_16",
            Check("kernels_test", "*/q16_16_auxiliary", "q16_16_auxiliary"),
            Check("kernels_test", "*/q16_16_angles", "q16_16_angles"),
            Check("kernels_test", "*/q16_16_powers", "q16_16_powers"),
            Check("kernels_test", "*/correctly_rounded_angles", "correctly_rounded_angles"),
            Check("kernels_test", "*/correctly_rounded_powers", "correctly_rounded_powers")),
    room("kernels", f"{FIXED}/avr/add_scaled_q16_16.S {FIXED}/avr/dot_difference_q16_16.S {FIXED}/avr/multiply_short_q16_16.S"
         f" {FIXED}/avr/short_factor_q16_16.inc {FIXED}/avr/add_whole_product.S", 1,
         Check("vector_kernels_test", "VectorSteps.*", "vector_steps")),
    room("kernels", f"{FIXED}/avr/transform_32.S {FIXED}/avr/cross_32.S {FIXED}/avr/polynomial_*.S"
         f" {FIXED}/avr/amplify4_32.S {FIXED}/avr/columns_32.inc {FIXED}/avr/product_sum_32.inc"
         f" {FIXED}/avr/matrix_product_2_q8_24.S {FIXED}/avr/upper_sum_q8_24.inc", 1,
         Check("vector_kernels_test", "VectorTransform.*", "vector_transform"),
         Check("vector_kernels_test", "VectorCross.*", "vector_cross"),
         Check("vector_kernels_test", "VectorPolynomials.*", "vector_polynomials"),
         Check("vector_kernels_test", "VectorMatrixProduct2.*", "vector_matrix_product_2")),
    room("kernels", f"{FIXED}/avr/complex_*.S {FIXED}/avr/cofactors_32.S {FIXED}/avr/one_pole_32.S"
         f" {FIXED}/avr/biquad_*.S {FIXED}/avr/pid_32.S {FIXED}/avr/invert2_*.S {FIXED}/avr/inverse2_32.S"
         f" {FIXED}/avr/transposed_quotients_32.S {FIXED}/avr/quotients_32.inc", 1,
         Check("vector_kernels_test", "VectorComplexProduct.*", "vector_complex_product"),
         Check("vector_kernels_test", "VectorCofactors.*", "vector_cofactors"),
         Check("vector_kernels_test", "VectorInverses.*", "vector_inverses"),
         Check("vector_kernels_test", "VectorFilters.*", "vector_filters")),
    kernels(f"{FIXED}/avr/*_q8_8.S {FIXED}/avr/*_q8_8.inc", 1, "q8_8",
            Check("kernels_test", "*/q8_8_auxiliary", "q8_8_auxiliary")),
    kernels(f"{FIXED}/avr/*_q4_4.S", 1, "q4_4"),
    kernels(f"{FIXED}/avr/*_q32_32.S {FIXED}/avr/cubic_64.* !*/absolute_q32_32.S !*/lerp_q32_32.S"
            " !*/exp2_q32_32.S !*/hyperbolic_q32_32.S !*/pow_q32_32.S !*/cbrt_q32_32.S",
            1, "q32_32",
            Check("kernels_test", "*/q32_32_auxiliary", "q32_32_auxiliary")),
    kernels(f"{FIXED}/avr/absolute_q32_32.S {FIXED}/avr/lerp_q32_32.S", 1, "q32_32_auxiliary"),
    kernels(f"{FIXED}/avr/exp2_q32_32.S {FIXED}/avr/hyperbolic_q32_32.S {FIXED}/avr/pow_q32_32.S"
            f" {FIXED}/avr/exp_64.inc {FIXED}/avr/*_fine.S", 1, "q32_32_powers",
            Check("kernels_test", "Power/*", "q32_32_powers")),
    kernels(f"{FIXED}/avr/tan_of_rest.S {FIXED}/avr/byte_fraction.S", 1, "q32_32_angles"),
    kernels(f"{FIXED}/avr/cbrt_q32_32.S", 1, "q32_32_powers",
            Check("kernels_test", "CubeRoot/*", "q32_32_powers")),
    room("kernels", f"{FIXED}/avr/*_24.S !*_q8_24.S {FIXED}/avr/columns_24.inc", 1,
         Check("splits_test", "SplitsOf24Bits.*", "splits_24_multiply splits_24_multiply_add splits_24_multiply_saturating"
                                                  " splits_24_dot2 splits_24_dot3")),
    room("kernels", f"{FIXED}/avr/*_64.S {FIXED}/avr/septic_64.inc {FIXED}/avr/fraction_product.inc"
         f" {FIXED}/avr/leading_one.inc !*/cubic_64.S !*/short_power_64.S", 1,
         Check("splits_test", "LongSplits.Multiply", "splits_64_multiply"),
         Check("splits_test", "LongSplits.Divide", "splits_64_divide"),
         Check("splits_test", "LongSplits.Dot3", "splits_64_dot3"),
         Check("splits_test", "LongSplits.Exp", "splits_64_exp"),
         Check("splits_test", "LongSplits.SinAndCos", "splits_64_sin splits_64_cos splits_64_sincos"),
         Check("splits_test", "LongSplits.Angles", "splits_64_atan splits_64_atan2"),
         Check("splits_test", "LongSplits.Log", "splits_64_log")),
    room("kernels", f"{FIXED}/avr/sin_32.S {FIXED}/avr/atan2_32.S {FIXED}/avr/exp_32.S {FIXED}/avr/log_32.*"
         f" {FIXED}/avr/reciprocal_sqrt_32.S {FIXED}/avr/cubic_32.* {FIXED}/avr/normalise3_32.S", 1,
         Check("splits_test", "Splits.Normalise3", "splits_32_normalise3"),
         Check("splits_test", "Splits.Log", "splits_32_log"),
         Check("splits_test", "Splits.ReciprocalSqrt", "splits_32_reciprocal_sqrt"),
         Check("splits_test", "Splits.Exp", "splits_32_exp"),
         Check("splits_test", "Splits.Sin:Splits.Cos:Splits.Sincos", "splits_32_sin splits_32_cos splits_32_sincos"),
         Check("splits_test", "Splits.Atan:Splits.Atan2", "splits_32_atan splits_32_atan2")),
    room("kernels", f"{FIXED}/avr/multiply_16.S {FIXED}/avr/sin_16.S {FIXED}/avr/log_16.S", 1,
         Check("splits_test", "ShortSplits.Multiply", "splits_16_multiply"),
         Check("coarse_splits_test", devices="coarse_splits")),
    room("kernels", f"{FIXED}/avr/multiply_32.S {FIXED}/avr/dot_32.S {FIXED}/avr/round_32.inc"
         f" {FIXED}/avr/divide_32.S {FIXED}/avr/digits_32.inc {FIXED}/avr/sqrt_32.S {FIXED}/avr/long_root.inc", 1,
         Check("splits_test", "Splits.Divide*", "splits_32_divide"),
         Check("splits_test", "Splits.Sqrt*", "splits_32_sqrt"),
         Check("splits_test", "Splits.Multiply:Splits.MultiplyAdd", "splits_32_multiply splits_32_multiply_add"),
         Check("splits_test", "Splits.Dot2:Splits.Dot3", "splits_32_dot2 splits_32_dot3")),
    room("kernels", f"{FIXED}/avr/multiply_saturating_32.S", 1,
         Check("splits_test", "*.MultiplySaturating", "splits_32_multiply_saturating")),
    kernels(f"{FIXED}/avr/short_power*.S", 1, "q32_32_auxiliary",
            Check("library_on_device_test", "*/small_operations_test_q16_16", "small_operations_test_q16_16")),
    room("kernels", f"{FIXED}/kernel/*_saturating.hpp", 1,
         Check("saturating_sums_test", devices="saturating_sums"),
         Check("library_on_device_test", "*/operators_test_q16_16", "operators_test_q16_16")),
    room("tables", "fixedpoint/tables/*.py", 1, TABLES_TEST),
    room("tables", f"{FIXED}/avr/*_table.S {FIXED}/portable/*_table.hpp"
         f" {FIXED}/published/arc_tangent_table.hpp", 1, TABLES_TEST),
    room("portable", f"{FIXED}/portable/divide.hpp {FIXED}/portable/divide_w*.hpp", 1,
         "products_test", "small_operations_test"),
    room("portable", f"{FIXED}/portable/remainder.hpp {FIXED}/portable/lerp.hpp {FIXED}/kernel/smoothstep.hpp", 1,
         "small_operations_test", "products_test"),
    room("portable", f"{FIXED}/kernel/*_q32_32.hpp", 1, "q32_32_test", "checked_test"),
    room("portable", f"{FIXED}/portable/round.hpp {FIXED}/portable/nearest_root.hpp", 1, "roots_test"),
    room("portable", f"{FIXED}/portable/decimal_*.hpp !*/decimal_literal.hpp", 1, "decimal_test"),
    room("arithmetic", f"{FIXED}/arithmetic/*.hpp !*/published.hpp !*/small.hpp !*/checked.hpp"
         " !*/rounded.hpp !*/correctly_rounded.hpp", 1, "fixed_test", "small_operations_test"),
    room("arithmetic", f"{FIXED}/arithmetic/rounded.hpp", 1, "small_operations_test"),
    room("arithmetic", f"{FIXED}/arithmetic/correctly_rounded.hpp {FIXED}/portable/correct_rounding.hpp"
         f" {FIXED}/portable/certain.hpp {FIXED}/kernel/short_turns.hpp {FIXED}/kernel/precise_sine.hpp"
         f" {FIXED}/kernel/power_side.hpp {FIXED}/kernel/nearest.hpp {FIXED}/portable/side_of_tie.hpp",
         1, "correctly_rounded_test", "correctly_rounded_splits_test"),
    room("arithmetic", f"{FIXED}/arithmetic/checked.hpp", 1, "checked_test"),
    room("arithmetic", f"{FIXED}/arithmetic/published.hpp {FIXED}/published/*.hpp !*_table.hpp", 1,
         "published_test"),
    room("oracle", "reference/judge.cpp reference/exact.cpp reference/error_statistics.cpp", 2,
         Check("reference_tests", "-Bulk.*"), Check("reference_tests", "Bulk.*")),
    room("simulator", "bench/chip/simulator/*.cpp bench/chip/simulator/workarounds/*.cpp"
         " !*/other_chip.cpp", 2, "simulator_tests"),
    room("simulator", "bench/chip/simulator/other_chip.cpp", 1, "other_chips_test"),
    room("translator", "bench/chip/instructions/instruction.cpp bench/chip/instructions/translate.cpp"
         " bench/chip/instructions/fingerprint.cpp", 1, "instructions_tests"),
    room("engine", "engine/src/engine/solvers/*.hpp engine/src/engine/constraints.hpp"
         " engine/src/engine/links.hpp engine/src/engine/shared_change.hpp", 2,
         "engine_model_step_test", "engine_pool_test", "engine_direct_rods_test",
         "engine_warm_started_test"),
    room("engine", "engine/src/engine/continuous.hpp", 1, "engine_continuous_test"),
    room("engine", "engine/src/engine/broad_phase/*.hpp engine/src/engine/overlap.hpp", 1, "engine_overlap_test",
         "engine_contact_test", "engine_pool_test"),
    room("engine", "engine/src/engine/distance.hpp", 1, "engine_distance_test",
         "engine_distance_proof_test"),
    room("engine", "engine/src/engine/integrators/*.hpp engine/src/engine/forces.hpp", 1,
         "engine_model_step_test", "engine_coupled_springs_test"),
    room("firmware", "firmware/src/firmware/frame_clock.hpp", 1, "firmware_frame_clock_test"),
    room("firmware", "firmware/src/firmware/grid.hpp", 1, "firmware_grid_test"),
    room("firmware", "firmware/src/firmware/lever.hpp", 1, "firmware_lever_test"),
    room("firmware", "firmware/src/firmware/renderer.hpp", 1,
         "firmware_renderer_test"),
    room("verdicts", "bench/experiments/table_3_2/table_3_2.cpp", 1,
         Check("table_3_2_test", "Judge*:Table31*:Hypothesis.ThePref*:Hypothesis.AnAlt*")),
    room("verdicts", "bench/experiments/calibration/verdicts.cpp"
         " bench/experiments/calibration/fit.cpp", 1, "calibration_test"),
    room("verdicts", "bench/experiments/scenes/judge.cpp", 1,
         Check("scene_bench_tests", "Verdict*:LargestDistance*:Extent*:EnergyDrift*")),
    room("verdicts", "bench/experiments/cost/growth/fit.cpp", 1, "growth_tests"),
    room("stability", "bench/experiments/stability/search.cpp", 1, "search_test"),
    room("haptic", "bench/experiments/haptic/plant/*.cpp", 1, "haptic_plant_test"),
    room("haptic", "bench/experiments/haptic/judge.cpp", 1, "haptic_judge_test"),
    room("report", "bench/report/*.py !*/report.py !*/explorer.py", 2, "bench/report/tests/report_test.py"),
]

# The tests of each room must notice this share of faults; a room of fewer than 20 faults may have one unnoticed, and
# all rooms together must reach this share.
SHARE = 0.95

# Lines where a fault changes nothing that a test should see: files, a pattern of the line, the reason.
HARMLESS = [
    ("bench/report/*.py", r"(fontsize|linewidths?|figsize|markersize|alpha|zorder|pad|rotation|shrink)=",
     "the look of a figure"),
    ("bench/report/*.py", r"legend|rect=|lim\(|lim=|labelpad|offset points|\"\w+\.size\"|strip = |columns = \d|wide = |\"(left|right)\"|label\(",
     "the look of a figure: margins, legends and titles"),
    ("bench/report/*.py", r"^ *(parser|\"--|help=)|dpi|metadata", "the look of a figure or of a help text"),
]


# Faults that do not change the meaning of the program, each with its proof; none of them is tried.
EQUIVALENT = ROOT / "scripts" / "equivalent_faults.txt"


class Failure(Exception):
    """A setup error that invalidates the run, in one line."""


def say(text):
    print(text, file=sys.stderr, flush=True)


# --- Faults -----------------------------------------------------------------------------------------

class Fault(NamedTuple):
    room: Room
    path: str
    line: int  # from 0
    begin: int  # the part of the line that is replaced
    end: int
    replacement: str
    key: str  # identifies the fault: the same for the same text, wherever it is

    def text(self, original):
        return original[:self.begin] + self.replacement + original[self.end:]


def swap(pairs):
    """Maps each word of a pair to the other."""
    words = {}
    for pair in pairs.split(", "):
        a, b = pair.split()
        words[a], words[b] = b, a
    pattern = "|".join(map(re.escape, sorted(words, key=len, reverse=True)))
    return rf"(?<![\w<>=&|!+*/-])(?:{pattern})(?![\w<>=&|+*/])", lambda found: words[found]


def one_more(found):
    return hex(int(found, 16) + 1) if found.startswith("0x") else str(int(found) + 1)


def one_way(text):
    words = dict(pair.split(":") for pair in text.split())
    return rf"\b(?:{'|'.join(words)})\b", lambda found: words[found]


NUMBER = r"(?<![\w.$'\"])(?:0x[0-9a-f]+|\d+)(?![\w.'\"])"
# Operators in code have a space on both sides, which the brackets of templates do not.
SYMBOLS = (r"(?<= )(?:<|>|<=|>=|==|!=|\+|-|\*|&&|\|\||\+=|-=)(?= )", {
    "<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "+": "-", "-": "+", "*": "/",
    "&&": "||", "||": "&&", "+=": "-=", "-=": "+="}.__getitem__)
NAMES = r"(?<!\w)(?:min|max|floor|ceil|true|false|sin|cos|front|back|and|or)(?!\w)", {
    "min": "max", "max": "min", "floor": "ceil", "ceil": "floor", "true": "false", "false": "true",
    "sin": "cos", "cos": "sin", "front": "back", "back": "front", "and": "or",
    "or": "and"}.__getitem__
OPERATORS = {
    "code": [
        SYMBOLS, NAMES, (NUMBER, one_more),
        (r"(?<=[( ])!(?=\w)", lambda found: ""),
        (r"(?<=[=(] )-(?=\w)|(?<=return )-(?=\w)", lambda found: ""),
        (r"^ +[\w.>\[\]-]+ [-+|&^]?= [^{}]*;$", lambda found: ""),  # a statement left out
    ],
    "assembly": [
        swap("brcs brcc, breq brne, brmi brpl, brlt brge, sbrc sbrs, brlo brsh, inc dec, brtc brts"),
        one_way("adc:add sbc:sub rol:lsl ror:lsr sbci:subi cpc:cp mulsu:mul add:sub sub:add"),
        (r"(?:(?<=\.byte )|(?<=\.word )|(?<=\.long ))\d+", one_more),  # an entry of a table
        (r"^    (?:adc|add|sub|sbc|mov|movw|lsl|lsr|com|neg|inc|dec|clr|eor|or|subi|sbci|mul_add\w*|mul_or"
         r"|\w+_bytes|\w+_each|\w+_from_top)\b.*$",
         lambda found: ""),
    ],
}


def kind_of(path):
    return "assembly" if path.endswith((".S", ".inc")) else "code"


def code_of(line, path):
    """The line with its comment and its texts blanked, with the same length."""
    line = re.sub(r'"(?:\\.|[^"\\])*"', lambda text: "\x00" * len(text.group()), line)
    mark = {".py": "#", ".S": "//", ".inc": "//"}.get(Path(path).suffix, "//")
    comment = line.find(mark)
    if mark == "//" and line.lstrip().startswith("*"):
        comment = 0
    return line if comment < 0 else line[:comment].rstrip()


# An assertion that holds still holds when it is weakened: only a second fault would reveal the first.
SKIPPED = re.compile(r"^\s*(#|import |from |using |template|static_assert|assert |throw |namespace"
                     r"|class |struct |@|case |\.(?!byte|word)|say\(|print\(|raise )")


def lines_of(path):
    """Number and code of the lines that may contain a fault."""
    within_text = False
    for number, line in enumerate((ROOT / path).read_text(encoding="utf-8").splitlines()):
        if path.endswith(".py") and line.count('"""') % 2:
            within_text = not within_text
            continue
        code = code_of(line, path)
        if code.strip() and not within_text and '"""' not in line and not SKIPPED.match(code):
            yield number, line, code


def digest(*parts):
    return hashlib.sha256("\0".join(map(str, parts)).encode()).hexdigest()


def files_of(room, known):
    found, excluded = [], [p[1:] for p in room.files.split() if p.startswith("!")]
    for pattern in room.files.split():
        if not pattern.startswith("!"):
            found += [path for path in known if fnmatch.fnmatch(path, pattern)
                      and path.count("/") == pattern.count("/")
                      and not any(fnmatch.fnmatch(path, e) for e in excluded)]
    if not found:
        raise Failure(f"the room '{room.name}' has no file {room.files}")
    return dict.fromkeys(found)


def equivalent_faults():
    """Path, line and faulty line of each; the blocks of the file also contain the proofs."""
    blocks = re.split(r"\n\n+", EQUIVALENT.read_text(encoding="utf-8").strip())
    faults = set()
    for block in blocks:
        lines = block.splitlines()
        if lines[0].startswith("#"):
            continue
        if len(lines) < 4 or lines[1][:2] != "- " or lines[2][:2] != "+ ":
            raise Failure(f"{EQUIVALENT.name}: not a path, '- line', '+ line' and a proof:\n{block}")
        source = (ROOT / lines[0]).read_text(encoding="utf-8").splitlines()
        if lines[1][2:] not in (line.strip() for line in source):
            raise Failure(f"{EQUIVALENT.name}: {lines[0]} has no line '{lines[1][2:]}'")
        faults.add((lines[0], lines[1][2:], lines[2][2:]))
    return faults


def candidates(room, known, seed):
    """Faults of a room in the seed's order, taking the files in turn, at most one fault per line."""
    by_file, equivalent = [], equivalent_faults()
    for path in files_of(room, known):
        faults, seen = [], {}
        for number, line, code in lines_of(path):
            if any(fnmatch.fnmatch(path, files) and re.search(text, line)
                   for files, text, _ in HARMLESS):
                continue
            seen[line] = seen.get(line, -1) + 1
            sites = [Fault(room, path, number, match.start(), match.end(),
                           change(match.group()), digest(seed, path, line.strip(), seen[line],
                                                         index, match.start() - len(line)
                                                         + len(line.lstrip())))
                     for index, (pattern, change) in enumerate(OPERATORS[kind_of(path)])
                     for match in re.finditer(pattern, code)]
            sites = [fault for fault in sites
                     if (path, line.strip(), fault.text(line).strip()) not in equivalent]
            if sites:
                faults.append(min(sites, key=lambda fault: fault.key))
        by_file.append(sorted(faults, key=lambda fault: fault.key))
    ranked = [(rank, fault.key, fault) for faults in by_file for rank, fault in enumerate(faults)]
    return [fault for _, _, fault in sorted(ranked, key=lambda entry: entry[:2])]


# --- The build, repeated elsewhere ------------------------------------------------------------------

class Edge(NamedTuple):
    output: str  # relative to the build tree, like the inputs inside it
    inputs: frozenset
    command: str


class Graph:
    """The knowledge of ninja: by which command each output is made, and from what."""

    def __init__(self, build):
        self.build = build
        deps = self.dependencies()
        inputs = self.inputs()
        self.edges = {}
        for entry in json.loads(self.ask("compdb", "-x")):
            output, command = entry["output"], entry["command"]
            # Lists of tests and files of dependencies are not needed.
            command = re.split(r" && (?:cd \S+ && )?/\S+/cmake (?:-D|-E cmake_transform_depfile)",
                               command)[0]
            if command:
                self.edges[output] = Edge(output, frozenset(inputs.get(output, ())) |
                                          deps.get(output, frozenset()), command)
        self.inputs_of = {output: edge.inputs for output, edge in self.edges.items()}
        for output, of_it in inputs.items():  # phony ones too
            self.inputs_of.setdefault(output, frozenset(of_it))

    def ask(self, *tool):
        done = subprocess.run(["ninja", "-C", self.build, "-t", *tool], capture_output=True, text=True)
        if done.returncode != 0:
            raise Failure(f"ninja -t {tool[0]}: {done.stderr.strip()}")
        return "\n".join(line for line in done.stdout.splitlines()
                         if not line.startswith("ninja: Entering"))

    def name(self, path):
        """A path in the build tree relative to it, any other path absolute."""
        path = os.path.normpath(os.path.join(self.build, path))
        inside = str(self.build) + "/"
        return path[len(inside):] if path.startswith(inside) else path

    def dependencies(self):
        found, output = {}, None
        for line in self.ask("deps").splitlines():
            if line.startswith("    "):
                found[output].add(self.name(line.strip()))
            elif ": #deps" in line:
                output = self.name(line.split(": #deps")[0])
                found[output] = set()
        return {output: frozenset(inputs) for output, inputs in found.items()}

    def inputs(self):
        """For every output, the inputs named in its build statement and its dependency file, without order-only
        inputs."""
        found, outputs = {}, []
        text = (self.build / "build.ninja").read_text(encoding="utf-8").replace("$\n", "")
        for line in text.splitlines():
            if line.startswith("build "):
                made, _, of = line[6:].partition(": ")
                outputs = [self.name(output) for output in
                           made.replace("${cmake_ninja_workdir}", "").split() if output != "|"]
                _, *rest = of.split(" || ")[0].split() or [""]
                names = [self.name(path) for path in rest if path != "|"]
                found |= {output: names for output in outputs}
            elif line.startswith("  depfile = ") and (self.build / line[12:]).is_file():
                listed = (self.build / line[12:]).read_text(encoding="utf-8").replace("\\\n", " ")
                names = [self.name(path) for path in listed.partition(": ")[2].split()]
                found |= {output: found[output] + names for output in outputs}
        return found

    def closure(self, goals):
        """Everything that the goals are made from."""
        seen, waiting = set(), list(goals)
        while waiting:
            output = waiting.pop()
            if output not in seen:
                seen.add(output)
                waiting += self.inputs_of.get(output, ())
        return seen

    def affected(self, path, goals):
        """The edges between a source and the goals, inputs first."""
        within = self.closure(goals)
        source = str(ROOT / path)
        order, state = [], {source: True}

        def reaches(output):
            if output not in state:
                state[output] = False
                # No short cut: each input must be visited, for the order.
                state[output] = any([reaches(i) for i in sorted(self.inputs_of.get(output, ()))
                                     if i in within or i == source])
                if state[output] and output in self.edges:
                    order.append(self.edges[output])
            return state[output]
        for goal in goals:
            reaches(goal)
        return order

    def goal(self, name, suffix=""):
        """The file that the target of that name makes."""
        ends = name + suffix
        found = [output for output in self.edges if output == ends or output.endswith("/" + ends)]
        if len(found) != 1:
            raise Failure(f"the build tree {self.build} makes {len(found)} files {ends}, not one")
        return found[0]


class Worker:
    """A copy of the sources and what is built from it."""

    def __init__(self, folder, build, known):
        self.source, self.made, self.build = folder / "source", folder / "made", build
        for path in known:
            (self.source / path).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / path, self.source / path)

    def elsewhere(self, command, outputs):
        """The command on the copy, with these outputs outside the build tree."""
        build = str(self.build)
        # The footprints of the subjects take longest, and no test needs them.
        command = re.sub(r" --footprints \S+", "", command)
        command = command.replace(build, "\x01").replace(f"{ROOT}/", f"{self.source}/")
        for output in outputs:
            command = re.sub(rf"(?<![\w./]){re.escape(output)}(?=\s|$|\.(?:d|gch|map)\b)|\x01/{re.escape(output)}"
                             r"(?=\s|$|\.(?:d|gch|map)\b|\")", str(self.made / output), command)
        return command.replace("\x01", build)


class Refused(Exception):
    """The fault does not compile."""


class NoticedByCompiler(Exception):
    """A check at compile time fails because of the fault."""


RUNNING, STOPPING = set(), threading.Event()


def run(command, folder, seconds, environment=None):
    """Exit status and output; None as status if the time limit is exceeded."""
    if STOPPING.is_set():
        raise KeyboardInterrupt

    def limit():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_AS, (6 << 30, 6 << 30))
    process = subprocess.Popen(command, cwd=folder, shell=isinstance(command, str), text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, errors="replace",
                               start_new_session=True, preexec_fn=limit,
                               env=os.environ | (environment or {}))
    RUNNING.add(process)
    try:
        return process.communicate(timeout=seconds)[0], process.returncode
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        return process.communicate()[0], None
    finally:
        RUNNING.discard(process)


def is_script(check):
    return check.target.endswith(".py")


class Tests:
    """Runs the tests of rooms, with and without a fault."""

    def __init__(self, graph):
        self.graph = graph
        self.seconds = {}  # the time limit of each test
        self.lock, self.sound = threading.Lock(), {}

    def run(self, check, fault, source, program, devices, seconds):
        if is_script(check):
            return run([sys.executable, "-B", str(source / check.target),
                        *([source / fault.path] if check.narrow else [])], source, seconds)
        # Stops at the first failure: further failures do not matter.
        return run([str(program), "--gtest_brief=1", "--gtest_break_on_failure",
                    f"--gtest_filter={check.cases}"],
                   self.graph.build / Path(self.graph.goal(check.target)).parent, seconds,
                   {"DEVICE_PROGRAMS": str(devices)} if devices else None)

    def limit(self, check, fault):
        """The time limit of the test with a fault, in seconds. Before its first fault, the test must pass without
        one."""
        key = check.target, check.cases, check.narrow and fault.path
        with self.lock:
            sound = self.sound.setdefault(key, threading.Lock())
        with sound:  # one worker runs it, the others wait
            if key not in self.seconds:
                program = None if is_script(check) else self.graph.build / self.graph.goal(check.target)
                begin = time.monotonic()
                output, status = self.run(check, fault, ROOT, program, None, 300)
                if status != 0 or re.search(r"\b0 tests", output):
                    raise Failure(f"the test {check.target} {check.cases} fails without a fault:\n{output}")
                self.seconds[key] = 5 + 5 * (time.monotonic() - begin)
        return self.seconds[key]

    def goals(self, check):
        if is_script(check):
            return []
        return [self.graph.goal(device, ".elf") for device in check.devices.split()] or \
            [self.graph.goal(check.target)]

    def notices(self, fault, worker):
        """Whether a test fails with the fault; None if the fault changes no object."""
        if not any(is_script(check) or self.graph.affected(fault.path, self.goals(check)) for check in fault.room.checks):
            raise Failure(f"no test of the room '{fault.room.name}' depends on {fault.path}")
        copy = worker.source / fault.path
        sound = copy.read_text(encoding="utf-8")
        lines = sound.splitlines(keepends=True)
        end = "\n" if lines[fault.line].endswith("\n") else ""
        lines[fault.line] = fault.text(lines[fault.line].rstrip("\n")) + end
        copy.write_text("".join(lines), encoding="utf-8")
        try:
            verdicts = []
            stem = Path(fault.path).stem  # the test of that name, if there is one, is the most likely
            for check in sorted(fault.room.checks, key=lambda check: stem not in check.target):
                verdicts.append(self.notices_by(check, fault, worker))
                if verdicts[-1]:
                    return True
            return False if False in verdicts else None
        except NoticedByCompiler:
            return True
        finally:
            copy.write_text(sound, encoding="utf-8")

    def notices_by(self, check, fault, worker):
        """Whether that test fails; None if the fault changes none of its objects."""
        if is_script(check):
            return self.run(check, fault, worker.source, None, None, self.limit(check, fault))[1] != 0
        try:
            if not self.build(check, fault, worker):
                return None
            program = self.graph.goal(check.target)
            if not check.devices:
                return self.run(check, fault, None, worker.made / program, None,
                                self.limit(check, fault))[1] != 0
            for device in self.goals(check):
                if not (worker.made / device).exists():  # one that does not contain the fault
                    shutil.copy(self.graph.build / device, worker.made / device)
            return self.run(check, fault, None, self.graph.build / program,
                            (worker.made / device).parent, self.limit(check, fault))[1] != 0
        finally:
            shutil.rmtree(worker.made, ignore_errors=True)

    def build(self, check, fault, worker):
        """Builds what the test runs. Returns whether an object changed."""
        edges = self.graph.affected(fault.path, self.goals(check))
        outputs = [edge.output for edge in edges]
        changed = False
        for edge in edges:
            compiles = str(ROOT / fault.path) in edge.inputs
            if not compiles and not changed:
                return False
            # A program for the chip is compiled and linked in one step, with an object in between.
            written = {edge.output, *map(self.graph.name, re.findall(r" -o (\S+)", edge.command))}
            for path in written:
                (worker.made / path).parent.mkdir(parents=True, exist_ok=True)
            output, status = run(worker.elsewhere(edge.command, written.union(outputs)),
                                 self.graph.build, 120)
            if status != 0:
                if "static assertion failed" in output or "is not a constant expression" in output:
                    raise NoticedByCompiler
                raise Refused(output)
            if compiles:
                changed |= sections(worker.made / edge.output) != sections(
                    self.graph.build / edge.output)
        return changed


def sections(path):
    """The part of an object that reaches the program: the disassembly with its data, without its name."""
    tool = "avr-objdump" if b"\x53\x00" == path.read_bytes()[18:20] else "objdump"
    done = subprocess.run([tool, "-sr", "-j", ".*", path], capture_output=True)
    if done.returncode != 0 or not done.stdout:
        done = subprocess.run([tool, "-sr", path], capture_output=True)
    kept, keep = [], True
    for line in done.stdout.split(b"\n")[3:]:
        if line.startswith((b"Contents of section ", b"RELOCATION RECORDS FOR ")):
            keep = not re.search(rb"\.(debug|comment|note)", line)
        if keep:
            kept.append(line)
    return b"\n".join(kept)


# --- The run ----------------------------------------------------------------------------------------

def known_files():
    """All sources, except the results, which are made from them and need no copy."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-co", "--exclude-standard"],
                            capture_output=True, text=True)
    if listed.returncode == 0:
        paths = listed.stdout.splitlines()
    else:
        paths = [str(path.relative_to(ROOT)) for path in ROOT.rglob("*") if path.is_file()]
    return sorted(path for path in paths if (ROOT / path).is_file()
                  and not path.startswith(("build/", "results/", ".git/")))


class Slot:
    """The next faults of one room, until its number of faults has been tried."""

    def __init__(self, room, faults):
        self.room, self.faults, self.lock = room, faults, threading.Lock()

    def next(self):
        with self.lock:
            return self.faults.pop(0) if self.faults else None


def describe(fault):
    line = (ROOT / fault.path).read_text(encoding="utf-8").splitlines()[fault.line]
    return (f"{fault.path}:{fault.line + 1}\n    - {line.strip()}\n    + {fault.text(line).strip()}")


class Campaign:
    """All faults, tried by several workers, and their outcomes."""

    def __init__(self, tests, workers, slots):
        self.tests, self.slots, self.begin = tests, slots, time.monotonic()
        self.workers = queue.SimpleQueue()
        for worker in workers:
            self.workers.put(worker)
        self.lock = threading.Lock()
        self.noticed, self.survivors, self.tried, self.equal, self.refused, self.done = 0, [], [], 0, 0, 0
        self.by_room = {}

    def try_one(self, slot):
        worker = self.workers.get()
        begin = time.monotonic()
        try:
            while (fault := slot.next()) is not None:
                try:
                    noticed = self.tests.notices(fault, worker)
                except Refused:
                    with self.lock:
                        self.refused += 1
                    continue
                if noticed is None:
                    with self.lock:
                        self.equal += 1
                    continue
                self.tell(fault, noticed, time.monotonic() - begin)
                return
            raise Failure(f"the room '{slot.room.name}' has too few lines for its faults: "
                          f"{slot.room.files}")
        finally:
            self.workers.put(worker)

    def tell(self, fault, noticed, seconds):
        with self.lock:
            self.done += 1
            counts = self.by_room.setdefault(fault.room.name, [0, 0])
            counts[0] += noticed
            counts[1] += 1
            self.tried.append(fault)
            if not noticed:
                self.survivors.append(fault)
            left = (time.monotonic() - self.begin) / self.done * (len(self.slots) - self.done)
            print(f"{fault.key[:8]} {fault.room.name:11}{'noticed' if noticed else 'UNNOTICED':10}"
                  f"{seconds:5.1f} s  {fault.path}:{fault.line + 1}", flush=True)
            say(f"  [{self.done}/{len(self.slots)}] {left // 60:.0f}:{left % 60:02.0f} left")

    def run(self, jobs):
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            futures = [pool.submit(self.try_one, slot) for slot in self.slots]
            try:
                for future in concurrent.futures.as_completed(futures):
                    future.result()
            except BaseException:
                STOPPING.set()
                for future in futures:
                    future.cancel()
                for process in list(RUNNING):
                    os.killpg(process.pid, signal.SIGKILL)
                raise


def check(arguments):
    known = known_files()
    chosen = [room for room in ROOMS if arguments.room in (None, room.name)]
    queues = [candidates(room, known, arguments.seed) for room in chosen]
    if arguments.only:
        queues = [[f for f in faults if f.key.startswith(arguments.only)] for faults in queues]
        if not any(queues):
            raise Failure(f"no fault of seed {arguments.seed} is named {arguments.only}")
    slots = []
    for room, faults in zip(chosen, queues):
        shared = Slot(room, faults)
        count = room.count * 6 if arguments.full else room.count
        slots += [shared] * (len(faults) if arguments.only else count)
    checks = list(dict.fromkeys(check for slot in slots for check in slot.room.checks))

    build = (ROOT / arguments.build).resolve()
    say(f"Seed {arguments.seed}: {len(slots)} faults. Building what they need in {arguments.build} ...")
    tests = Tests(None)
    if not all(map(is_script, checks)):
        tests.graph = Graph(build)
        goals = [goal for check in checks if not is_script(check)
                 for goal in [tests.graph.goal(check.target), *tests.goals(check)]]
        done = subprocess.run(["ninja", "-C", build, "--quiet", *dict.fromkeys(goals)],
                              stdout=sys.stderr)
        if done.returncode != 0:
            raise Failure(f"{arguments.build} does not build")
        tests.graph = Graph(build)  # with the dependencies found by the build

    begin = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="mutation_test_") as folder:
        jobs = arguments.jobs
        workers = [Worker(Path(folder) / str(i), build, known) for i in range(jobs)]
        campaign = Campaign(tests, workers, slots)
        campaign.run(jobs)

    for fault in campaign.survivors:
        names = " and ".join(check.target for check in fault.room.checks)
        print(f"\nUNNOTICED by {names}: {describe(fault)}\n"
              f"    again: scripts/mutation_test.py --seed {arguments.seed} --only {fault.key[:8]}")
    print()
    poor = []
    for name, (noticed, tried) in campaign.by_room.items():
        if tried - noticed > max(1, (1 - SHARE) * tried):
            poor.append(name)
        print(f"{name:12}{noticed:3} of {tried:3}{noticed / tried:8.1%}"
              f"{'  too few' if name in poor else ''}")
    count = len(slots) - len(campaign.survivors)
    print(f"{'all':12}{count:3} of {len(slots):3}{count / len(slots):8.1%}"
          f"{'  too few' if count < SHARE * len(slots) else ''}")
    print(f"\nSeed {arguments.seed}, {time.monotonic() - begin:.0f} s; {campaign.equal} other faults "
          f"changed no object and {campaign.refused} did not compile.")
    return 1 if poor or count < SHARE * len(slots) else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=1, help="chooses the faults (default: 1)")
    parser.add_argument("--room", choices=sorted({room.name for room in ROOMS}),
                        help="only the faults of one folder")
    parser.add_argument("--only", metavar="NAME", help="only the fault whose name begins with NAME")
    parser.add_argument("--full", action="store_true", help="six times as many faults")
    parser.add_argument("--build", default="build/release", metavar="DIR",
                        help="the build tree (default: build/release)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), metavar="N",
                        help="faults tried at a time (default: one per core)")
    arguments = parser.parse_args()
    if arguments.jobs < 1:
        parser.error("--jobs must be 1 or more")
    try:
        return check(arguments)
    except Failure as failure:
        say(f"mutation_test.py: {failure}")
        return 1
    except KeyboardInterrupt:
        say("mutation_test.py: interrupted; the sources are as they were")
        return 130


if __name__ == "__main__":
    sys.exit(main())
