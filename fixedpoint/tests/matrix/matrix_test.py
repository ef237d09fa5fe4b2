#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compilers x standards x chips: what the libraries promise for each, in one table.

- headers: no warning from any public header of any library, in any standard, here or in `public`;
- kernels: where a chip has kernels, each row of kernel/table.hpp is a call of its symbol and no
  portable code; where it has none, no symbol is called; the table names every kernel of avr/;
- assembly: avr/*.S assemble, to nothing where the chip does not multiply;
- links: a kernel that jumps to compiled code does not link without it, all others do;
- runs: the tests of tests/device on the simulated chip;
- refused: what must not compile does not, for the reason that the library states.

Usage: matrix_test.py SCRATCH_FOLDER RUN_ON_CHIP [GROUP ...]    without GROUP all of them
Cells that only repeat what their neighbours tell run if the environment has EVERY_CELL.
"""
import os
import re
import subprocess
import sys
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

run_on_chip = sys.argv[2]
here = Path(__file__).parent
project = here.parent.parent.parent
source = project / "fixedpoint/src"
device = here.parent / "device"
Path(sys.argv[1]).mkdir(parents=True, exist_ok=True)
scratch = tempfile.TemporaryDirectory(dir=sys.argv[1])  # removed when the program ends

WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"]
EVERY_CELL = "EVERY_CELL" in os.environ
# What C++17 deprecates or reserves, C++20 does too.
STANDARDS = [11, 14, *([17] if EVERY_CELL else []), 20, 23]
# Chips with kernels; chips without; and chips on which nobody has run anything.
MULTIPLYING = ["atmega328p", "atmega32u4", "atmega1284p", "atmega2560"]
PLAIN = ["attiny85", "attiny1634"]
NEVER_RUN = ["atxmega128a1", "avrxmega3", "avrxmega4"]  # the last two: the cores of AVR-0/1 and -Dx
# The formats of everything.cpp. What only a standard or a compiler warns of shows in a few of them.
FEW = "-DFEW_FORMATS"
FEW_KERNEL_FORMATS = "q4_4|q8_8|q8_16|q16_16|u8_8|u16_16"
KERNEL_FORMATS = FEW_KERNEL_FORMATS + "|q12_12|q32_32|q8_24|q1_15|u4_4|u0_16|u0_32"
HOST_AS_AVR = ["-D__AVR__", "-D__AVR_HAVE_MUL__", f"-I{here / 'host_avr'}"]
# avr-libc's <stdint.h> defines its limits for C++ only on request.
CLANG_AVR = ["clang++-19", "--target=avr", "-nostdlibinc", "-isystem", "/usr/lib/avr/include",
             "-D__STDC_LIMIT_MACROS"]
COMPILERS = {"g++": ["g++"], "clang++": ["clang++-19"], "avr-g++": ["avr-g++"],
             "clang++ avr": CLANG_AVR}


class Failure(Exception):
    pass


def own_folder(name):
    """Cells run in parallel, so none may write where another one reads."""
    return Path(tempfile.mkdtemp(prefix=f"{name}_", dir=scratch.name))


def run(command, **options):
    environment = {**os.environ, "LC_ALL": "C"}
    return subprocess.run([str(part) for part in command], capture_output=True, text=True,
                          env=environment, check=False, **options)


def must(command, **options):
    result = run(command, **options)
    if result.returncode != 0:
        raise Failure(f"{' '.join(map(str, command))}\n{result.stdout}{result.stderr}")
    return result.stdout


def compiler(name, standard, chip=None):
    return [*COMPILERS[name], f"-std=gnu++{standard}", f"-I{source}",
            *([f"-mmcu={chip}", "-fno-exceptions", "-DF_CPU=16000000UL"] if chip else [])]


EVERYTHING = {"fixedpoint": here / "everything.cpp",
              "engine": project / "engine/tests/everything.cpp",
              "firmware": project / "firmware/tests/everything.cpp"}


def no_warning(name, *arguments):
    # avr-gcc 5.4 checks templates only where it compiles them.
    must([*arguments, *WARNINGS, *(["-O0", "-S", "-o", "/dev/null"] if name == "avr-g++" else ["-fsyntax-only"])])


def headers(library, name, standard, chip, *options):
    no_warning(name, *compiler(name, standard, chip), *options, f"-I{project / 'engine/src'}",
               f"-I{project / 'firmware/src'}", EVERYTHING[library])
    return "no warning"


def table_symbols(*options):
    """The symbols that kernel/table.hpp names."""
    text = must(["g++", "-E", "-P", *options, f"-I{source}", "-xc++", here / "kernels.cpp"])
    return set(re.findall(r"\bcall_(fixedpoint_\w+)", text))


def symbols_of(name):
    """Without those of 24 bits, which only a compiler with __int24 calls."""
    return SYMBOLS if name == "avr-g++" else SYMBOLS_WITHOUT_INT24


def undefined(objects):
    return set(re.findall(r"U (fixedpoint_\w+)", must(["nm", "-u", *objects])))


MADE, MAKING = {}, {}


def once(key, make):
    """The result of make() for this key, shared by cells that run in parallel."""
    with MAKING.setdefault(key, threading.Lock()):
        if key not in MADE:
            MADE[key] = make()
    return MADE[key]


def compiled(path, name, standard, chip, *options):
    """The object of a source, compiled without a warning. Chips for which the preprocessed text is
    the same share the object: they differ in instructions, not in what is called."""
    command = [*compiler(name, standard, chip), *WARNINGS, *options, path]

    def make():
        target = own_folder(path.stem) / f"{path.stem}.o"
        must([*command, "-c", "-o", target])
        return target
    return once((name, standard, options, must([*command, "-E", "-P"])), make)


def kernels(name, standard, chip, *options):
    """All kernels of kernels.cpp are called, or none if the preprocessed text does not name any."""
    if chip in PLAIN or "-DFIXEDPOINT_NO_ASSEMBLY" in options:
        command = [*compiler(name, standard, chip), *options, here / "kernels.cpp"]
        text = must([*command, "-E", "-P"])
        named = set(re.findall(r"\bfixedpoint_\w+", text))
        if named:
            raise Failure(f"names kernels that there are not: {sorted(named)}")
        once((name, standard, text), lambda: no_warning(name, *command))
        return "portable"
    target = compiled(here / "kernels.cpp", name, standard, chip, "-Os", *options)
    if "-flto" in options:
        must([*COMPILERS[name], "-flto", "-r", "-nostdlib", "-flinker-output=nolto-rel", target, "-o",
              f"{target}.linked"])
        target = f"{target}.linked"
    called = undefined([target])
    if called != symbols_of(name):
        raise Failure(f"kernels not called: {sorted(symbols_of(name) - called)}")
    portable = [line for line in must(["nm", "-C", "--defined-only", target]).splitlines()
                if "portable::" in line]
    if portable:
        raise Failure(f"portable code beside the kernels: {portable}")
    return f"{len(called)} kernels"


def everything(name, standard, chip, *options):
    """Every kernel of the formats used is called through the public functions too, without a
    warning from their headers, except the steps of a solver, which the engine calls, and what decides ties, which
    a kernel calls."""
    # clang runs out of registers where it does not optimise.
    level = "-O0" if name == "avr-g++" else "-Os"
    called = undefined([compiled(EVERYTHING["fixedpoint"], name, standard, chip, level, *options)])
    formats = FEW_KERNEL_FORMATS if FEW in options else KERNEL_FORMATS
    expected = set() if chip in PLAIN else {
        symbol for symbol in symbols_of(name) if re.search(rf"_({formats})(_|$)", symbol)
        and not re.search(r"_(angle_reaches|multiply_short|(square|project|dot_difference|add_scaled|exchange)[23]|transform|matrix_product(_2)?"
                          r"|(twice_)?cross|cofactors|(quaternion|complex)_\w+)_", symbol)}
    if not expected <= called or (not expected and called):
        raise Failure(f"kernels not called: {sorted(expected - called)}; "
                      f"called though there are none: {sorted(called if not expected else [])}")
    return f"{len(expected)} used" if expected else "portable"


def assembly(chip, assembler="avr-gcc"):
    """Assembles avr/*.S, and returns the objects."""
    folder = own_folder(f"assembly_{chip}")
    command = {"avr-gcc": ["avr-gcc"], "clang": ["clang-19", "--target=avr"]}[assembler]
    must([*command, f"-mmcu={chip}", f"-I{source}", "-c", *(source / "fixedpoint/avr").glob("*.S")], cwd=folder)
    return sorted(folder.glob("*.o"))


def assembles(chip, assembler="avr-gcc"):
    known = ASSEMBLED.get(chip) if assembler == "avr-gcc" else None
    defined = set(re.findall(r" T (fixedpoint_\w+)", must(["avr-nm", *(known or assembly(chip, assembler))])))
    if chip in PLAIN:
        if defined:
            raise Failure(f"a kernel for a chip without: {sorted(defined)}")
        return "nothing"
    # Symbols shared among kernels, and those that a block calls, are not operations.
    shared = {f"fixedpoint_{name}" for name in (
        *(f"{block}_q{32 - fraction}_{fraction}" for block in (
            "amplify4", "invert2", "pid", "polynomial", "transposed_quotients") for fraction in range(33)),
        "add_whole_product", "arc_sine_q16_16", "cubic_32", "cubic_40", "cubic_64", "divide_32", "exp_32",
        "biquad_q16_16", "biquad_q8_24", "inverse2_32", "largest_32", "length_long", "length_root", "normalise3_32",
        "one_pole_q16_16", "one_pole_q8_24",
        "power_of_rest_q32_32", "ratio_32", "reciprocal_root_small",
        "reciprocal_sqrt_32", "root_128", "root_long", "rough_ratio_32", "round_64", "scale_40", "septic_64",
        "shift_root_small", "smallest_32", "transposed_quotients_32", "unrounded_exp_q32_32", "unrounded_log_q32_32", "zero_32")}
    if defined - shared != SYMBOLS:
        raise Failure(f"in avr/ and not in the table, or not in avr/: "
                      f"{sorted((defined - shared) ^ SYMBOLS)}")
    return "assembles"


MISSING = "undefined reference to `long fixedpoint::kernel::"


def linked(chip, language, program, *options):
    """The output of the linker for a program with the kernels that it calls, none of them left
    out."""
    folder = own_folder("linked")
    archive = folder / "kernels.a"
    must(["avr-ar", "rcs", archive, *ASSEMBLED[chip]])
    return run([*compiler("avr-g++", 14, chip), "-Os", *options, f"-x{language}", "-", "-xnone", archive,
                "-o", folder / "linked.elf"], input=program)


def links_in_c(chip):
    """Programs in C have no compiled code to which a kernel could jump. All kernels fill more than one chip;
    neighbours by name share objects."""
    jumping = must(["g++", "-E", "-P", f"-I{source}", "-xc++", "-"],
                   input="#include <fixedpoint/kernel/table.hpp>\n#define NAME(shape, operation, Raw, F, symbol, same) symbol\n"
                         "FIXEDPOINT_ROUNDED_KERNELS(NAME)\n").split()
    kernels = sorted(SYMBOLS - set(jumping))
    quarter = -(-len(kernels) // 4)
    for names in [*(kernels[start:start + quarter] for start in range(0, len(kernels), quarter)),
                  *([name] for name in jumping)]:
        result = linked(chip, "c", "".join(f"void {name}(void);\n" for name in names) +
                        f"int main(void) {{ {'(), '.join(names)}(); }}\n", "-std=c11")
        if names[0] in jumping and MISSING not in result.stderr:
            raise Failure(f"{names[0]} links without what it jumps to")
        if names[0] not in jumping and result.returncode != 0:
            raise Failure(result.stderr)
    return f"{len(jumping)} do not"


def links_without_weak_symbols(chip):
    """If compiled code is local to an object, no kernel finds it."""
    for call in ("sin(x)", "cos(x)", "exp(x)", "log(x)"):
        result = linked(chip, "c++", "#include <fixedpoint/arithmetic/correctly_rounded.hpp>\n#include <fixedpoint/math.hpp>\n"
                        "volatile int32_t raw;\nint main() {\n"
                        "    const auto x = fixedpoint::Fixed<16, 16, fixedpoint::CorrectlyRounded>::from_raw(raw);\n"
                        f"    raw = {call}.raw();\n}}\n", "-fno-weak")
        if MISSING not in result.stderr:
            raise Failure(f"{call} links without what its kernel jumps to")
    return "nothing does"


def beside(standard, chip, integer_bits, fraction_bits, flags):
    """The objects that all tests of a format link: the expected results, and the main program."""
    folder = own_folder(f"beside_{chip}")
    expected = folder / "expected.cpp"
    must([sys.executable, device / "expected.py", integer_bits, fraction_bits, expected])
    for path in (expected, device / "main.cpp"):
        must([*compiler("avr-g++", standard, chip), *flags, "-c", path, "-o", folder / f"{path.stem}.o"])
    return sorted(folder.glob("*.o"))


def runs(name, standard, chip, test, integer_bits, fraction_bits, *options):
    """Links a test of tests/device and runs it. Everything outside the library comes from
    avr-gcc."""
    folder = own_folder(f"{test}_{chip}")
    flags = ["-Os", "-DF_CPU=16000000UL", f"-DINTEGER_BITS={integer_bits}",
             f"-DFRACTION_BITS={fraction_bits}", f"-I{device}", "-ffunction-sections",
             "-fdata-sections", "-fno-threadsafe-statics", *options]
    test_object = folder / "test.o"
    must([*compiler(name, standard, chip), *flags, "-c", device / f"{test}_test.cpp", "-o", test_object])
    key = standard if name == "avr-g++" else 14, chip, integer_bits, fraction_bits, tuple(flags)
    objects = [*once(key, lambda: beside(*key)), test_object]
    archive = folder / "kernels.a"
    must(["avr-ar", "rcs", archive, *ASSEMBLED[chip]])
    elf = folder / "test.elf"
    must(["avr-g++", f"-mmcu={chip}", "-Wl,--gc-sections", *objects, archive, "-o", elf])
    symbols = {line.split()[2]: line.split()[0] for line in must(["avr-nm", elf]).splitlines()
               if len(line.split()) == 3}
    result = run([run_on_chip, chip, elf, *(symbols[symbol] for symbol in (
        "finished", "checks", "failures", "first_failing_line"))])
    if result.returncode != 0:
        raise Failure(f"{test}_test.cpp: {result.stdout}{result.stderr}")
    return re.search(r"\d+ checks", result.stdout)[0]


def refuses(name, chip, statement, reason, *options):
    program = own_folder("refused") / "refused.cpp"
    program.write_text("#include <fixedpoint.h>\nusing namespace fixedpoint;\n"
                       f"using namespace fixedpoint::literals;\nvoid f() {{ {statement} }}\n")
    result = run([*compiler(name, 14, chip), *options, "-fsyntax-only", program])
    if result.returncode == 0:
        raise Failure(f"compiles: {statement}")
    if reason not in re.sub(r"\s+", " ", result.stderr):
        raise Failure(f"{statement}: no '{reason}' in\n{result.stderr}")
    return "refused"


REFUSED = [
    ("Fixed<12, 13> x; (void)x;", "has 8, 16, 24, 32 or 64 bits"),
    ("Fixed<64, 64> x; (void)x;", "has 8, 16, 24, 32 or 64 bits"),
    ("Fixed<0, 16> x; (void)x;", "IntegerBits counts the sign"),
    ("Fixed<17, -1> x; (void)x;", "FractionBits must not be negative"),
    ("UFixed<12, 12> x; (void)x;", "has 8, 16, 32 or 64 bits"),
    ("UFixed<-1, 17> x; (void)x;", "IntegerBits must not be negative"),
    ("UFixed<0, 64> x; (void)x;", "An unsigned number of 64 bits has 1 to 63 fraction bits"),
    ("sin(1_u8_8);", "This function is for numbers with a sign"),
    ("sin_turns(1_u8_8);", "This function is for numbers with a sign"),
    ("power(1_u8_8, 2);", "This function is for numbers with a sign"),
    ("256_u8_8;", "outside the range of its fixed-point format"),
    ("8_q4_4;", "outside the range of its fixed-point format"),
    ("0x10_q16_16;", "A fixed-point literal is a decimal number"),
    ("0b1_q16_16;", "A fixed-point literal is a decimal number"),
    ("convert<Q16_16>(0.5f);", "use from_float and to_float"),
    ("scale_down<-1>(1_q16_16);", "scale_down divides by 2^K"),
]
ASSEMBLY_REASON = "FIXEDPOINT_ASSEMBLY asks for the assembly kernels"


def cells():
    """(group, row, column, function, arguments)"""
    for name in ("g++", "clang++"):
        for standard in STANDARDS:
            options = ["-DHOST_HEADERS", *(["-DFORMAT_HEADER"] if standard >= 14 else []),
                       *([FEW] if standard not in (STANDARDS[0], STANDARDS[-1]) else [])]
            for library in EVERYTHING:
                yield "headers", f"{library} {name}", f"gnu++{standard}", headers, (
                    library, name, standard, None, *options)
    # The cells of `public` check the library's own headers in these standards.
    for standard in STANDARDS[:2]:
        for library in ("engine", "firmware"):
            yield "headers", f"{library} avr-g++", f"gnu++{standard}", headers, (
                library, "avr-g++", standard, "atmega328p")
    for standard in STANDARDS:
        # The firmware's interrupts are avr-gcc's.
        for library in ("fixedpoint", "engine") if standard != 14 else ("engine",):
            yield "headers", f"{library} clang++ avr", f"gnu++{standard}", headers, (
                library, "clang++ avr", standard, "atmega328p", *([FEW] if standard in (17, 20) else []))
    for options in ("-Os", "-O2", "-flto"):
        yield "kernels", "g++ as AVR", options, kernels, ("g++", 14, None, options, *HOST_AS_AVR)
    yield "kernels", "clang++ as AVR", "-O2", kernels, ("clang++", 14, None, "-O2", *HOST_AS_AVR)
    for name, standards in (("avr-g++", (11, 14)), ("clang++ avr", (14,))):
        for standard in standards:
            row = f"{name} gnu++{standard}"
            for chip in MULTIPLYING + PLAIN:
                if name == "clang++ avr" and chip == "attiny1634":
                    continue  # clang does not know the instructions of chips outside its list
                yield "kernels", row, chip, kernels, (name, standard, chip)
            yield "kernels", row, "no assembly", kernels, (
                name, standard, "atmega328p", "-DFIXEDPOINT_NO_ASSEMBLY")
    yield "public", "avr-g++ gnu++14", "atmega328p", everything, ("avr-g++", 14, "atmega328p")
    for name, standard, chip in (("avr-g++", 14, "attiny85"), ("avr-g++", 11, "atmega328p"),
                                 ("clang++ avr", 14, "atmega328p")):
        yield "public", f"{name} gnu++{standard}", f"{chip}, few formats", everything, (name, standard, chip, FEW)
    for chip in MULTIPLYING + PLAIN + NEVER_RUN:
        yield "assembly", "avr-gcc", chip, assembles, (chip,)
    for chip in ("atmega328p", "avrxmega4") if EVERY_CELL else ("atmega328p",):
        yield "assembly", "clang", chip, assembles, (chip, "clang")
    yield "links", "avr-gcc atmega2560", "C", links_in_c, ("atmega2560",)
    yield "links", "avr-g++ atmega2560", "-fno-weak", links_without_weak_symbols, ("atmega2560",)
    for name, standard, chip, options in (
            ("avr-g++", 14, "atmega32u4", ()), ("avr-g++", 14, "atmega1284p", ()),
            ("avr-g++", 14, "atmega2560", ()), ("clang++ avr", 14, "atmega328p", ()),
            ("avr-g++", 14, "atmega328p", ("-DFIXEDPOINT_NO_ASSEMBLY",))):
        row = f"{name} {chip}" + (" no assembly" if options else "")
        for test, *bits in (("operators", 16, 16), ("functions", 16, 16), ("operators", 8, 8),
                            ("constant_functions", 16, 16)):
            column = f"{test} Q{bits[0]}.{bits[1]}"
            yield "runs", row, column, runs, (name, standard, chip, test, *bits, *options)
    for test, *bits in (("operators", 16, 16), ("functions", 16, 16), ("operators", 8, 8)):
        yield "runs", "avr-g++ gnu++11 atmega328p", f"{test} Q{bits[0]}.{bits[1]}", runs, (
            "avr-g++", 11, "atmega328p", test, *bits)
    yield "runs", "avr-g++ attiny85", "shifts Q4.4", runs, ("avr-g++", 14, "attiny85", "shifts", 4, 4)
    for statement, reason in REFUSED:
        for name, chip in (("g++", None), ("clang++", None), ("avr-g++", "atmega328p")):
            yield "refused", statement, name, refuses, (name, chip, statement, reason)
    for name, chip, *options in (("g++", None), ("avr-g++", "attiny85"),
                                 ("avr-g++", "atmega328p", "-DFIXEDPOINT_NO_ASSEMBLY")):
        yield "refused", "-DFIXEDPOINT_ASSEMBLY", f"{name} {chip or ''}".strip(), refuses, (
            name, chip, "", ASSEMBLY_REASON, "-DFIXEDPOINT_ASSEMBLY", *options)


def evaluate(cell):
    *_, function, arguments = cell
    try:
        return function(*arguments), None
    except Failure as failure:
        return "FAILED", str(failure)


SYMBOLS = table_symbols("-D__INT24_MAX__")
SYMBOLS_WITHOUT_INT24 = table_symbols()
workers = ThreadPoolExecutor(os.cpu_count())
running = MULTIPLYING + ["attiny85"]
ASSEMBLED = dict(zip(running, workers.map(assembly, running)))
all_cells = [cell for cell in cells() if len(sys.argv) == 3 or cell[0] in sys.argv[3:]]
group = row = None
failures = []
for (cell_group, cell_row, column, *_), (verdict, failure) in zip(
        all_cells, workers.map(evaluate, all_cells)):
    if cell_group != group:
        group, row = cell_group, None
        print(f"\n{group}", end="")
    if cell_row != row:
        row = cell_row
        print(f"\n  {row:38}", end="")
    print(f"  {column}: {verdict};", end="", flush=True)
    if failure:
        failures.append(f"{group}, {row}, {column}: {failure}")
print(f"\n\n{len(all_cells)} cells, {len(failures)} failed")
for failure in failures:
    print(f"\n{failure}")
sys.exit(bool(failures))
