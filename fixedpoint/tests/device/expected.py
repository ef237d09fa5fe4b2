#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the rows of numbers.hpp for one format: boundary operands and the results that the library
must return, from exact fractions. Usage: expected.py INTEGER_BITS FRACTION_BITS OUTPUT.cpp"""

import random
import re
import struct
import sys
from fractions import Fraction
from math import floor, isqrt

I, F = int(sys.argv[1]), int(sys.argv[2])
W = I + F
ONE = 1 << F
TARGETS = [(8, 4), (16, 8), (32, 16), (64, 32), (16, 0)]  # width and fraction bits


def low(width=W):
    return -(1 << width - 1)


def high(width=W):
    return (1 << width - 1) - 1


def wrapped(n, width=W):
    return (n - low(width)) % (1 << width) + low(width)


def saturated(n, width=W):
    return min(max(n, low(width)), high(width))


def nearest(x):
    return floor(x + Fraction(1, 2))


def toward_zero(x):
    return floor(x) if x >= 0 else -floor(-x)


def operands():
    """Boundaries, then numbers of every magnitude."""
    border = isqrt(high() * ONE)  # the largest number whose square fits
    boundary = [0, 1, -1, 2, -2, 3, low(), high(), low() + 1, high() - 1, ONE, -ONE, ONE // 2,
                -(ONE // 2), ONE + 1, ONE - 1, border, border + 1, -border - 1, low() // 2]
    generator = random.Random(328)
    for bits in range(2, W):
        if W <= 32 or bits % 4 == 1:  # as many as fit the chip's flash
            number = 1 << bits - 1 | generator.getrandbits(bits - 1)
            boundary.append(number if generator.getrandbits(1) else -number)
    return [n for n in dict.fromkeys(boundary) if low() <= n <= high()]


def operand_pairs():
    numbers = operands()
    core = [n for n in (0, 1, -1, low(), high(), ONE, -ONE, ONE // 2) if n in numbers]
    for a in core:
        for b in core:
            yield a, b
    half = ONE // 2
    yield from [(half, 3), (half, -3), (-half, -5)]          # products that are ties
    if 2 * ONE <= high():                                    # quotients that are ties
        yield from [(1, 2 * ONE), (-1, 2 * ONE), (5, -2 * ONE), (-5, -2 * ONE)]
    for i, a in enumerate(numbers):
        yield a, numbers[(i + 1) % len(numbers)]
        if W <= 32:
            yield a, numbers[(7 * i + 3) % len(numbers)]


def pair(a, b):
    product = nearest(Fraction(a * b, ONE))
    if b:
        quotient = nearest(Fraction(a * ONE, b))
        remainder = a - b * toward_zero(Fraction(a, b))
    else:
        quotient, remainder = (a > 0) * high() + (a < 0) * low(), a
    ring = [a + b, a - b, product]
    overflows = sum(1 << bit for bit, n in enumerate([*ring, quotient]) if n != saturated(n))
    return [raw(a), raw(b), *map(raw, map(wrapped, ring)), raw(saturated(quotient)), raw(remainder),
            *map(raw, map(saturated, ring)), str(overflows)]


def with_integer(a, n):
    ring = [a + n * ONE, a - n * ONE, n * ONE - a, a * n]
    quotient = nearest(Fraction(a, n)) if n else (a > 0) * high() + (a < 0) * low()
    return [raw(a), f"int32_t(0x{n & 0xffffffff:x}u)", *map(raw, map(wrapped, ring)),
            *map(raw, map(saturated, ring)), raw(saturated(quotient)), str((a > n * ONE) - (a < n * ONE))]


def integer_pairs():
    for n in (0, 1, -1, 2, 3, -7, 100, 127, -128, 255, 32767, -32768, 40000, -70000, 2**31 - 1, -2**31):
        for a in (0, 1, -1, low(), low() + 1, high(), high() // 3, -(ONE + ONE // 2), n * ONE, n * ONE + 1):
            if a == saturated(a):
                yield a, n


def small_operations(a, b, t):
    """Operations that are exact or rounded once, on two numbers and a position t between them."""
    truncated, floored = ([saturated(n), a - n * b] for n in (toward_zero(Fraction(a, b)), a // b)) if b else (
        [(a > 0) * high() + (a < 0) * low(), a] for _ in range(2))
    u = min(max(Fraction(t, ONE), 0), 1)
    numbers = [wrapped(a + nearest(Fraction(t * (b - a), ONE))), saturated(a + nearest(Fraction(t * (b - a), ONE))),
               nearest(Fraction(a + b, 2)), wrapped(abs(a - b)), wrapped(abs(a) if b >= 0 else -abs(a)),
               saturated(nearest((3 - 2 * u) * u * u * ONE)), *truncated, *floored]
    return [*map(raw, (a, b, t)), *map(raw, numbers), str((a > 0) - (a < 0))]


def positions():
    for i, (a, b) in enumerate(dict.fromkeys(operand_pairs())):
        numbers = (ONE // 2, ONE, ONE // 3, 2 * ONE // 3 + 1, ONE - 1, 0, -ONE // 3, high(), low())
        t = numbers[i % len(numbers)]
        yield a, b, saturated(t)


def shift(a, count):
    return [raw(a), str(count), raw(wrapped(a << count)), raw(saturated(a << count)), raw(a >> count)]


def root(a):
    if a < 0:
        return 0
    down = isqrt(a * ONE)
    return down + (a * ONE > down * down + down)


def single(a):
    row = [raw(n) for n in (
        a, wrapped(-a), saturated(-a), wrapped(abs(a)), root(a), floor(Fraction(a, ONE)) * ONE,
        saturated(-floor(Fraction(-a, ONE)) * ONE), saturated(nearest(Fraction(a, ONE)) * ONE),
        toward_zero(Fraction(a, ONE)) * ONE)]
    fits = 0
    for bit, (width, fraction_bits) in enumerate(TARGETS):
        n = nearest(Fraction(a * (1 << fraction_bits), ONE))
        fits |= (n == saturated(n, width)) << bit
        row += [raw(wrapped(n, width), width), raw(saturated(n, width), width)]
    return [*row, str(fits), f"0x{float_bits(Fraction(a, ONE)):08x}"]


def float_bits(x):
    """The normal float nearest to x, ties to even."""
    if x == 0:
        return 0
    sign, x = (x < 0) << 31, abs(x)
    exponent = x.numerator.bit_length() - x.denominator.bit_length()
    exponent -= x < Fraction(2)**exponent
    mantissa = round(x * Fraction(2)**(23 - exponent))  # Python rounds ties to even
    return sign | ((exponent + 126 << 23) + mantissa)


def from_float(bits):
    x = struct.unpack("<f", struct.pack("<I", bits))[0]
    if x != x:
        return [f"0x{bits:08x}", raw(0), "false"]
    infinite = x in (float("inf"), float("-inf"))
    n = (1 << 200) * (1 if x > 0 else -1) if infinite else nearest(Fraction(x) * ONE)
    return [f"0x{bits:08x}", raw(saturated(n)), boolean(n == saturated(n))]


def floats():
    yield from [0, 1 << 31, 1, 0x007fffff, 0x80000001, 0x7f800000, 0xff800000, 0x7fc00000,
                0x7f800001, 0x7f7fffff, 0xff7fffff]
    ulp = Fraction(1, ONE)
    for x in (ulp, ulp / 2, 3 * ulp / 2, 5 * ulp / 2, Fraction(high(), ONE), Fraction(1),
              Fraction(1, 3), Fraction(high() // 3, ONE)):
        for bits in range(float_bits(x) - 1, float_bits(x) + 2):
            yield from (bits, bits | 1 << 31)


def from_decimal(n, decimals):
    result = nearest(Fraction(n * ONE, 10**decimals))
    return [f"int32_t(0x{n & 0xffffffff:x}u)", str(decimals), raw(saturated(result)),
            boolean(result == saturated(result))]


def decimals():
    for n in (0, 1, -1, 38, -38, 5, -5, 127, 99999, -123456789, 2**31 - 1, -2**31):
        for places in (0, 1, 2, 5, 9, 12, 255):
            yield n, places


def exact_text(x):
    """x as a decimal; its denominator is a power of two."""
    places = x.denominator.bit_length() - 1
    digits = str(abs(x.numerator) * 5**places).rjust(places + 1, "0")
    sign = "-" if x < 0 else ""
    return sign + (f"{digits[:-places]}.{digits[-places:]}" if places else digits)


def texts():
    yield from [("", 0), ("-", 1), ("+", 1), (".", 1), ("x", 0), (" 1", 0), ("1 ", 1), ("0x1", 1),
                ("1e", 2), ("1e+", 3), ("1.2.3", 3), ("--1", 1), ("1e2e", 3), ("e5", 0)]
    well_formed = ["0", "-0", "+0.5", ".25", "-.25", "0.", "1e-1", "25E-2", "0.000001e5", "3e0",
                   "7.9375", "99999999999999999999", "-1e99", "1e-99999999999", "1e99999999999",
                   "0.1", "-0.1", "0000000.3"]
    ulp = Fraction(1, ONE)
    for x in (ulp / 2, -ulp / 2, high() * ulp + ulp / 2, high() * ulp, low() * ulp,
              low() * ulp - ulp / 2):
        well_formed += [exact_text(x), exact_text(x) + ("1" if "." in exact_text(x) else "")]
    for text in well_formed:
        yield text, len(text)


def parse(text, position):
    if not re.fullmatch(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", text):
        status = "malformed" if text else "empty"
        return [f'"{text}"', raw(0), f"fixedpoint::TextStatus::{status}", str(position)]
    mantissa, exponent = re.fullmatch(r"([^eE]*)[eE]?(.*)", text).groups()
    # Results outside every format need not be exact.
    exponent = min(max(int(exponent or "0"), -100), 100)
    n = nearest(Fraction(mantissa) * Fraction(10)**exponent * ONE)
    status = "ok" if n == saturated(n) else "out_of_range"
    return [f'"{text}"', raw(saturated(n)), f"fixedpoint::TextStatus::{status}", str(position)]


def with_places(x, places):
    """x rounded to nearest, half up, with that many decimals."""
    n = nearest(x * 10**places)
    digits = str(abs(n)).rjust(places + 1, "0")
    return ("-" if n < 0 else "") + (f"{digits[:-places]}.{digits[-places:]}" if places else digits)


def shortest(a):
    """The smallest number of decimals at which some decimal reads as a; rounding picks the closest
    one."""
    x = Fraction(a, ONE)
    return next(text for text in (with_places(x, places) for places in range(W + 1))
                if nearest(Fraction(text) * ONE) == a)


def prints():
    for a in operands():
        yield [raw(a), "-1", f'"{shortest(a)}"']
        for places in (0, 1, 3):
            yield [raw(a), str(places), f'"{with_places(Fraction(a, ONE), places)}"']


def raw(n, width=W):
    name = "fixedpoint::Int24" if width == 24 else f"int{width}_t"
    return f"{name}(0x{n & (1 << width) - 1:x}u{'ll' if width == 64 else ''})"


def boolean(condition):
    return "true" if condition else "false"


def table(name, struct_name, rows):
    rows = list(rows)
    body = "".join(f"    {{{', '.join(row)}}},\n" for row in rows)
    return (f"static const {struct_name} {name}_rows[] PROGMEM = {{\n{body}}};\n"
            f"const Rows<{struct_name}> {name} = {{{name}_rows, {len(rows)}}};\n")


def main():
    numbers = operands()
    shifted = [(a, count) for a in (high() // 5, low() // 3, -1) for count in range(W + 1)]
    content = "// SPDX-License-Identifier: MIT\n#include \"numbers.hpp\"\n" + "".join([
        table("pairs", "Pair", (pair(a, b) for a, b in dict.fromkeys(operand_pairs()))),
        table("with_integers", "WithInteger",
              (with_integer(a, n) for a, n in dict.fromkeys(integer_pairs()))),
        table("small_operations", "SmallOperations", (small_operations(*row) for row in positions())),
        table("shifts", "Shift", (shift(a, count) for a, count in shifted)),
        table("singles", "Single", map(single, numbers)),
        table("from_floats", "FromFloat", map(from_float, floats())),
        table("from_decimals", "FromDecimal", (from_decimal(*row) for row in decimals())),
        table("parses", "Parse", (parse(*row) for row in texts())),
        table("prints", "Print", prints())])
    with open(sys.argv[3], "w", encoding="ascii") as output:
        output.write(content)


if __name__ == "__main__":
    main()
