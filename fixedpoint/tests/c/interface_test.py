#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""fixedpoint_c.h as its users see it:

- no warning in any standard of C and C++, on host and chip, alone and beside fixedpoint.h;
- program.c calls every function that the header declares;
- on a chip that multiplies the calls are calls of kernels, wherever kernel/table.hpp has one;
- the programs of docs/other_languages.md run.

Usage: interface_test.py SCRATCH_FOLDER
"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

here = Path(__file__).resolve().parent
library = here.parent.parent
source = library / "src"
header = (source / "fixedpoint_c.h").read_text()
FORMATS = re.findall(r"^typedef int\d+_t (q\d+_\d+);", header, re.MULTILINE)
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"]
failures = []


def run(command, **options):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True,
                          check=False, **options)


def must(command, **options):
    done = run(command, **options)
    if done.returncode != 0:
        failures.append(f"{' '.join(map(str, command))}\n{(done.stdout + done.stderr)[:1000]}")
    return done.stdout


def check_standards(scratch):
    """Every macro is used once, since errors in a macro appear only where it is expanded."""
    lines = ["#include <fixedpoint_c.h>"]
    for q in FORMATS:
        upper = q.upper()
        lines.append(f"{q} {q}_numbers[] = {{{upper}_MAX, {upper}_MIN, {upper}_ONE, "
                     f"{upper}_RATIO(1, 3), {upper}_RATIO(-1, 3), {upper}_TEXT_CAPACITY}};")
    program = scratch / "header.c"
    program.write_text("\n".join(lines) + "\n")
    for compiler, options, standards in (
            ("gcc", ["-Wstrict-prototypes"], ("c99", "c11", "c17", "c2x")),
            ("clang-19", ["-Wstrict-prototypes"], ("c99", "c23")),
            ("avr-gcc", ["-Wstrict-prototypes", "-mmcu=atmega328p"], ("c99", "gnu11")),
            ("g++", ["-xc++"], ("c++11", "c++23")), ("clang++-19", ["-xc++"], ("c++11", "c++23")),
            ("avr-g++", ["-xc++", "-mmcu=atmega328p"], ("gnu++11", "gnu++14"))):
        for standard in standards:
            must([compiler, f"-std={standard}", *options, *WARNINGS, f"-I{source}", "-fsyntax-only",
                  program])
    for order in (("fixedpoint.h", "fixedpoint_c.h"), ("fixedpoint_c.h", "fixedpoint.h")):
        both = scratch / "both.cpp"
        both.write_text("".join(f"#include <{name}>\n" for name in order) +
                        "using namespace fixedpoint;\n"
                        "q16_16 f(Q16_16 a) { return q16_16_multiply((a * a).raw(), 3); }\n")
        must(["g++", "-std=c++11", *WARNINGS, f"-I{source}", "-c", both, "-o", "/dev/null"])
        must(["avr-g++", "-mmcu=atmega328p", "-std=gnu++14", "-Os", f"-I{source}", "-c", both, "-o",
              scratch / "both.o"])
        if "fixedpoint_multiply_q16_16" not in must(["avr-nm", "-u", scratch / "both.o"]):
            failures.append(f"beside {order[0]} the kernel is not called")


def called(compiler, scratch, *options):
    """The functions that program.c calls, over all formats."""
    symbols = set()
    for q in FORMATS:
        target = scratch / "program.o"
        must([*compiler, "-std=c99", "-Os", *WARNINGS, *options, f"-I{source}", f"-DFORMAT={q}",
              "-c", here / "program.c", "-o", target])
        symbols |= set(re.findall(r"U (\w+)", must(["nm", "-u", target])))
    return symbols


def kernels():
    """The kernels of the functions and formats in the header. Others are of variants, and parts of
    functions."""
    rows = must(["g++", "-E", "-P", "-xc++", "-"],
                input=f'#include "{source}/fixedpoint/kernel/table.hpp"\n'
                      "#define ROW(shape, operation, Raw, F, symbol, same) operation Raw F symbol;\n"
                      "FIXEDPOINT_KERNELS(ROW)\n")
    widths = {(int(width), int(fraction))
              for width, fraction in re.findall(r"^typedef int(\d+)_t q\d+_(\d+);", header,
                                                re.MULTILINE)}
    functions = set(re.findall(rf"\b{FORMATS[0]}_(\w+)\(", header))
    return {symbol for operation, width, fraction, symbol in re.findall(
        r"(\w+) int(\d+)_t (\d+) (\w+);", rows)
        if (int(width), int(fraction)) in widths and operation in functions}


def check_calls(scratch):
    declared = set(re.findall(r"\b(q\d+_\d+_\w+)\(", header))
    if len(declared) < 150:
        failures.append(f"the header declares only {len(declared)} functions")
    ours = {symbol for symbol in called(["gcc"], scratch) if symbol in declared}
    # operations_test.cpp calls those of double, which the chip does not have.
    missed = {name for name in declared - ours if not name.endswith("_double")}
    if missed:
        failures.append(f"program.c does not call {sorted(missed)}")
    chip = called(["avr-gcc", "-mmcu=atmega328p"], scratch)
    if kernels() - chip:
        failures.append(f"kernels not called on the chip: {sorted(kernels() - chip)}")
    for options in (["-mmcu=atmega328p", "-DFIXEDPOINT_NO_ASSEMBLY"], ["-mmcu=attiny85"]):
        there = {name for name in called(["avr-gcc", *options], scratch) if
                 name.startswith("fixedpoint_")}
        if there:
            failures.append(f"{options}: kernels are called: {sorted(there)}")


def check_page(scratch):
    page = (library / "docs/other_languages.md").read_text()
    blocks = {}
    for language, block in re.findall(r"^```(\w+)\n(.*?)^```$", page, re.MULTILINE | re.DOTALL):
        blocks.setdefault(language, []).append(block)
    (scratch / "fixedpoint").symlink_to(library)
    (scratch / "program.c").write_text(blocks["c"][0])
    for command in "".join(blocks["sh"]).splitlines():
        must(["sh", "-c", command], cwd=scratch)
    must(["gcc", "-std=c99", *WARNINGS, f"-I{source}", "program.c", "-L.", "-lfixedpoint_c",
          "-Wl,-rpath,.", "-o", "program"], cwd=scratch)
    must(["./program"], cwd=scratch)
    (scratch / "program.py").write_text(blocks["python"][0])
    callers = [("Python", [sys.executable, "program.py"])]
    if shutil.which("rustc"):
        (scratch / "program.rs").write_text(blocks["rust"][0])
        must(["rustc", "-L", ".", "-C", "link-args=-Wl,-rpath,.", "program.rs", "-o", "rust"],
             cwd=scratch)
        callers.append(("Rust", ["./rust"]))
    else:
        print("Rust: not run, there is no rustc")
    for language, command in callers:
        text = must(command, cwd=scratch)
        # 24904 163840 / 2^32 = 0.9500122, half up to 2^-16.
        if not text or round(float(text) * 65536) != 62260:
            failures.append(f"{language} prints '{text.strip()}'")


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    scratch = Path(sys.argv[1])
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    check_standards(scratch)
    check_calls(scratch)
    check_page(scratch)
    print("\n".join(failures) or f"{len(FORMATS)} formats, {len(kernels())} kernels")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
