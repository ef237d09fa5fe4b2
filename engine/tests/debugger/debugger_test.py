#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A debugger shows numbers, vectors and pools as values: gdb by the printers of debug/, and Visual
Studio by the natvis files, whose expressions gdb evaluates here in the objects they are about.

Usage: debugger_test.py SCRATCH_FOLDER
"""
import re
import subprocess
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

here = Path(__file__).resolve().parent
root = here.parents[2]
PRINTERS = [root / "fixedpoint/debug/fixedpoint_gdb.py", root / "engine/debug/engine_gdb.py"]
NATVIS = [root / "fixedpoint/debug/fixedpoint.natvis", root / "engine/debug/engine.natvis"]
SPACE = "{http://schemas.microsoft.com/vstudio/debugger/natvis/2010}"

SHOWN = {
    "x": "0.3800 (raw 24904)",
    "negative": "-0.3800 (raw -24904)",
    "least": "-32768.0000 (raw -2147483648)",
    "zero": "0.0000 (raw 0)",
    "narrow": "-0.1 (raw -1)",  # -0.0625, of which -0.1 is the nearest
    "rounded": "1.50 (raw 383)",  # 1.49609375
    "wide": "3.141592654 (raw 13493037705)",
    "sine": "1.0000 (raw 32767)",  # 0.99997
    "whole": "-7 (raw -7)",
    "point": "{x = 0.3800 (raw 24904), y = -0.3800 (raw -24904)}",
    "row": "{0.3800 (raw 24904), 0.3800 (raw 24904)}",
    "position": "{0.3800 (raw 24904), -0.3800 (raw -24904)}",
    "pool": "2 of 4 = {1.50 (raw 383), 1.50 (raw 384)}",
    "empty": "0 of 0",
}
# Of a natvis type: the arguments of its template, a member to stop in, which numbers.cpp calls at
# its end, and what its expressions are there (None: no number).
Q16_16 = "fixedpoint::Fixed<16, 16, fixedpoint::Nearest>"
Q8_8 = "fixedpoint::Fixed<8, 8, fixedpoint::Nearest>"
EMPTY_POOL = f"engine::Pool<{Q8_8}, 0u>"
EVALUATED = {
    "fixedpoint::Fixed<*,*,*>": (["16", "16"], f"{Q16_16}::raw",
                                 [24904 / 65536, 24904]),
    "engine::Vector<*,*>": (["fixedpoint::Q16_16", "2"],
                            f"engine::Vector<{Q16_16}, 2>::operator[]",
                            [None, 2, None]),
    "engine::Elements<*,0>": (None, None, []),
    "engine::Elements<*,*>": (["fixedpoint::Q8_8", "4"],
                              f"engine::Elements<{Q8_8}, 4>::size",
                              [2, 4, 2, None]),
}

failures = []


def gdb(program, *commands):
    arguments = ["gdb", "-nx", "-batch", "-iex", "set auto-load off"]
    for command in commands:
        arguments += ["-ex", command]
    done = subprocess.run([*arguments, program], capture_output=True, text=True, check=False)
    return done.stdout, done.stderr


def check_printers(program):
    output, errors = gdb(program, *(f"source {path}" for path in PRINTERS),
                         f"break inspect<{Q16_16} >", "run", "up",
                         "set print frame-arguments none", *(f"print {name}" for name in SHOWN))
    shown = re.findall(r"^\$\d+ = (.*)$", output, re.MULTILINE)
    if len(shown) != len(SHOWN):
        failures.append(f"gdb prints {len(shown)} of {len(SHOWN)} numbers:\n{output}{errors}")
    for (name, expected), value in zip(SHOWN.items(), shown):
        if value != expected:
            failures.append(f"{name}: gdb shows '{value}', not '{expected}'")


def expressions(kind):
    """All that a natvis type evaluates, in the order of the file."""
    for element in kind.iter():
        if element.tag == SPACE + "DisplayString":
            yield from re.findall(r"\{([^{}]+)\}", element.text)
        elif element.tag in (SPACE + "Size", SPACE + "ValuePointer"):
            yield element.text


def check_natvis(program):
    for path in NATVIS:
        for kind in xml.parse(path).getroot().iter(SPACE + "Type"):
            if kind.get("Name") not in EVALUATED:
                failures.append(f"{path.name}: nothing is known of {kind.get('Name')}")
                continue
            arguments, member, expected = EVALUATED[kind.get("Name")]
            asked = list(expressions(kind))
            if len(asked) != len(expected):
                failures.append(f"{path.name}: {kind.get('Name')} has the expressions {asked}")
            if not asked:
                continue
            for i, argument in enumerate(arguments, 1):
                asked = [text.replace(f"$T{i}", argument) for text in asked]
            output, errors = gdb(program, f"break inspect<{EMPTY_POOL} >", "run",
                                 f"break {member}", "continue",
                                 *(f"print {text}" for text in asked))
            values = re.findall(r"^\$\d+ = (.*)$", output, re.MULTILINE)
            if len(values) != len(asked):
                failures.append(f"{path.name}: {asked} cannot be evaluated in {member}:\n{output}{errors}")
            for text, value, number in zip(asked, values, expected):
                if number is not None and float(value.split()[0]) != number:
                    failures.append(f"{path.name}: '{text}' is {value}, not {number}")


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    scratch = Path(sys.argv[1])
    scratch.mkdir(parents=True, exist_ok=True)
    program = scratch / "numbers"
    subprocess.run(["g++", "-std=c++17", "-g", "-O0", f"-I{root}/fixedpoint/src",
                    f"-I{root}/engine/src", here / "numbers.cpp", "-o", program], check=True)
    check_printers(program)
    check_natvis(program)
    print("\n".join(failures) or f"{len(SHOWN)} values as they should be")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
