#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Statements that must not compile say what to write instead, in the first line of the compiler's
output that names the statement; and all headers compile after the macros of C and of Arduino.
Usage: compile_test.py COMPILER [OPTION ...]"""
import pathlib
import re
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).parent.parent / "src"
LITERAL = "write_a_literal_or_from_integer_or_from_float"
CONVERT = "convert_one_operand_to_the_format_of_the_other"

# Statements on Q16_16 x, Q8_8 z and s, a Saturating Q16.16, and what the compiler says.
REFUSED = [
    # Operations that are exact with an integer compile and are not listed.
    *((f"(void)(2 {sign} x)", LITERAL) for sign in "/%"),
    ("(void)(x % 3)", LITERAL),
    ("x %= 1", LITERAL),
    *((f"(void)(0.5 {sign} x)", LITERAL) for sign in "+-*/%<>"),
    *((f"(void)(x {sign} true)", LITERAL) for sign in ("+", "-", "*", "/", "%", "==", "!=", "<", ">", "<=", ">=")),
    *((f"x {sign}= 'a'", LITERAL) for sign in "+-*/%"),
    ("(void)(x * 0.5)", LITERAL),
    ("(void)(0.5f * x)", LITERAL),
    ("(void)(x + 'a')", LITERAL),
    ("x *= 0.5", LITERAL),
    ("Q16_16 y(1)", LITERAL),
    ("Q16_16 y(0.5)", LITERAL),
    ("(void)static_cast<Q16_16>(1)", LITERAL),
    ("Q16_16 y = 1", "conversion from 'int' to non-scalar type"),
    ("x = 1", "no match for 'operator='"),
    ("int i = x", "cannot convert"),
    ("int i = 0.5_q16_16", "cannot convert"),
    ("if (0.5_q16_16) return", "could not convert"),
    ("(void)(x + z)", CONVERT),
    ("(void)(z < x)", CONVERT),
    ("(void)(x == s)", CONVERT),
    ("x -= z", CONVERT),
    ("(void)(x + 1_u8_8)", CONVERT),
    ("(void)(z < 1_u8_8)", CONVERT),
    ("(void)(0.5 * 1_u8_8)", LITERAL),
    ("U8_8 u = 1", "conversion from 'int' to non-scalar type"),
    ("stream << x", "include_fixedpoint_host_stream_hpp"),
    ("stream >> x", "include_fixedpoint_host_stream_hpp"),
]
# Failed assertions are reported in the header, with the statement as the place that required them.
ASSERTED = [
    ("(void)Q16_16::from_integer(0.5)", "from_integer takes an integer"),
    ("(void)from_float<Q16_16>(1)", "from_float takes a float or double"),
    ("(void)convert<Q16_16>(0.5)", "use from_float and to_float"),
    ("(void)(x << 0.5)", "A shift takes an integer count"),
    ("(void)Fixed<8, 7>()", "8, 16, 24, 32 or 64 bits"),
    ("(void)123456_q16_16", "outside the range"),
    ("(void)constants::pi<Fixed<1, 15>>()", "lies outside the range"),
    ("(void)widening_multiply(1_q32_32, x)", "No format holds"),
    ("(void)widening_add(1_q32_32, 1_q32_32)", "No format holds"),
    ("constexpr Q16_16 y = fixed<16, 16>(32768.0)", "the_format_does_not_hold_this_constant"),
    ("constexpr Q16_16 y = fixed<16, 16>(-40000)", "the_format_does_not_hold_this_constant"),
    ("(void)fixed<16, 16>('a')", "takes an integer, float or double"),
    ("(void)UFixed<8, 8, Published>()", "Unsigned numbers have the arithmetics"),
    ("(void)exp(1_u8_8)", "This function is for numbers with a sign"),
    ("(void)256_u8_8", "outside the range"),
    ("constexpr U8_8 y = ufixed<8, 8>(-1)", "the_format_does_not_hold_this_constant"),
    ("(void)sizeof(BlockNumber<U8_8>)", "A block takes a number with a sign"),
    ("(void)cosh(Fixed<48, 16, CorrectlyRounded>())", "needs a format of at most 32 bits"),
    ("(void)pow(Fixed<8, 24, CorrectlyRounded>(), Fixed<8, 24, CorrectlyRounded>())", "numbers of Q16.16"),
    ("(void)sizeof(BlockNumber<Fixed<8, 8, HalfToEven>>)", "rounds to nearest, half up"),
    ("(void)sizeof(BlockNumber<Fixed<8, 8, Published>>)", "rounds to nearest, half up"),
]
PRELUDE = """
#include <fixedpoint.h>
#include <fixedpoint/arithmetic/correctly_rounded.hpp>
#include <fixedpoint/arithmetic/published.hpp>
#include <fixedpoint/arithmetic/rounded.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/blocks/number.hpp>
using namespace fixedpoint;
using namespace fixedpoint::literals;
struct Stream { Stream* rdbuf(); } stream;
void statement(Q16_16 x, Q8_8 z, Fixed<16, 16, Saturating> s) {
    (void)x, (void)z, (void)s;
#line 1 "statements"
"""

# Macros of <complex.h>, <termios.h>, <ctype.h>, Windows and the Arduino core.
MACROS = """
#define I (__extension__ 1.0iF)
#define F(text) (text)
#define B0 0
#define B1 1
#define ECHO 8
#define EOF (-1)
#define PI 3.14159
#define HALF_PI 1.5707
#define TWO_PI 6.2831
#define DEG_TO_RAD 0.0174
#define RAD_TO_DEG 57.29
#define EULER 2.718
#define HIGH 1
#define LOW 0
#define DEFAULT 1
#define CHANGE 1
#define abs(x) ((x) > 0 ? (x) : -(x))
#define round(x) ((x) >= 0 ? (long)((x) + 0.5) : (long)((x) - 0.5))
#define min(a, b) ((a) < (b) ? (a) : (b))
#define max(a, b) ((a) > (b) ? (a) : (b))
#define constrain(x, low, high) ((x) < (low) ? (low) : (x) > (high) ? (high) : (x))
#define radians(deg) ((deg) * DEG_TO_RAD)
#define degrees(rad) ((rad) * RAD_TO_DEG)
#define sq(x) ((x) * (x))
#define bit(b) (1UL << (b))
#define word(...) makeWord(__VA_ARGS__)
#define lowByte(w) ((w) & 0xff)
#define highByte(w) ((w) >> 8)
#define bitRead(value, bit) (((value) >> (bit)) & 1)
#define interrupts() sei()
#define _A 1
#define _B 1
#define _C 1
#define _L 1
#define _N 1
#define _P 1
#define _S 1
#define _U 1
#define _X 1
"""


def compile_text(command, text):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "text.cpp"
        path.write_text(text)
        result = subprocess.run([*command, "-I", SOURCE, "-fsyntax-only", path], text=True,
                                capture_output=True, env={"LC_ALL": "C", "PATH": "/usr/bin:/bin"})
        return result.returncode, result.stderr


def refusals(command):
    statements = REFUSED + ASSERTED
    text = PRELUDE + "\n".join(f"{{ {statement}; }}" for statement, _ in statements) + "\n}\n"
    lines = compile_text(command, text)[1].splitlines()
    for number, (statement, message) in enumerate(statements, 1):
        place = re.compile(rf"statements:{number}:")
        at = next((i for i, line in enumerate(lines) if place.match(line.strip())), None)
        if at is None:
            yield f"{statement}: compiles"
        elif message not in "\n".join(lines[at:at + (1 if number <= len(REFUSED) else 4)]):
            yield f"{statement}: not '{message}' but\n    {lines[at]}"


def headers(command, on_chip):
    paths = sorted(path.relative_to(SOURCE) for path in SOURCE.rglob("*.hpp")
                   if not (on_chip and path.parent.name == "host"))
    standard = "" if on_chip else "".join(
        f"#include <{name}>\n" for name in ("complex.h", "termios.h", "functional", "istream",
                                            "limits", "ostream", "string", "fmt/format.h"))
    chip = "#include <avr/io.h>\n#include <avr/pgmspace.h>\n" if on_chip else ""
    undefined = "".join(f"#undef {name}\n" for name in re.findall(r"#define (\w+)", MACROS))
    includes = "".join(f"#include <{path}>\n" for path in paths)
    status, output = compile_text(command, standard + chip + undefined + MACROS + includes)
    if status != 0:
        yield "behind the macros of C and Arduino:\n" + "\n".join(output.splitlines()[:12])
    for path in paths:
        # Each header includes what it needs; those of a folder behave alike.
        if path.parent.name in ("fixedpoint", "arithmetic", "host"):
            status, output = compile_text(command, f"#include <{path}>\n")
            if status != 0:
                yield f"{path} alone:\n" + "\n".join(output.splitlines()[:12])


def tables_in_ram(command):
    """Without optimisation and sections of their own, tables still stay in flash."""
    program = """#include <fixedpoint.h>
        volatile int32_t raw;
        template <class Number> void use(Number x) {
            raw = (sin(x) + exp(x) + log(x) + atan2(x, x) + atan(x) + sqrt(x) + x / x).raw();
            raw = reciprocal_sqrt(x).raw();
        }
        int main() {
            use(fixedpoint::Q16_16::from_raw(raw)), use(fixedpoint::Fixed<8, 24>::from_raw(raw));
            use(fixedpoint::Q8_8::from_raw(static_cast<int16_t>(raw)));
        }"""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "program.cpp"
        path.write_text(program)
        subprocess.run([*command, "-O0", "-I", SOURCE, "-c", path, "-o", path.with_suffix(".o")],
                       check=True)
        sizes = subprocess.run(["avr-size", "-A", path.with_suffix(".o")], text=True, check=True,
                               capture_output=True).stdout
    size = sum(int(bytes_) for bytes_ in re.findall(r"^\.(?:rodata|data)\S* +(\d+)", sizes, re.M))
    if size > 128:  # constants of the integer types
        yield f"{size} bytes of tables in RAM"


def main():
    command = sys.argv[1:]
    on_chip = "avr" in command[0]
    faults = [*refusals(command), *headers(command, on_chip)]
    if on_chip:
        faults += tables_in_ram(command)
    print("\n".join(faults) or f"{len(REFUSED + ASSERTED)} statements are refused in words.")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
