#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The functions of the library. Writes src/fixedpoint_c.h: every operation, in every format with a
name in C, as a plain C function. On the AVR a function with a kernel in kernel/table.hpp is that
kernel. Writes two lists, too: src/fixedpoint/c_functions.h, by which fixedpoint_c.cpp defines them,
and tests call them; and src/fixedpoint/portable/elementary_functions.hpp, which the arithmetics
expand."""

import re
import subprocess
import textwrap

import page

# Integer and fraction bits.
FORMATS = [(4, 4), (8, 8), (16, 16), (8, 24), (32, 32)]

# Name, result, parameters, and what it returns for every input. Q is the number's type, {q} its
# name, {width} its bits, {integer} and {fraction} those before and after the point.
#
# Those without a kernel of their own in most formats; an evaluation in portable/ computes each.
ELEMENTARY = [
    ("tan", "Q", "Q angle",
     "The tangent of any angle in radians, faithful, saturated near a pole."),
    ("asin", "Q", "Q a",
     "The arc sine in radians, faithful, saturated. An argument outside [-1, 1] counts as the "
     "nearer end."),
    ("acos", "Q", "Q a",
     "The arc cosine in radians, faithful, saturated. An argument outside [-1, 1] counts as the "
     "nearer end."),
    ("exp2", "Q", "Q a", "2^a, faithful, saturated to {Q}_MAX."),
    ("expm1", "Q", "Q a", "e^a - 1, faithful, saturated to {Q}_MAX."),
    ("log2", "Q", "Q a", "The logarithm to base 2, faithful, exact for powers of 2; {Q}_MIN if a <= 0."),
    ("log10", "Q", "Q a", "The logarithm to base 10, faithful; {Q}_MIN if a <= 0."),
    ("log1p", "Q", "Q a", "ln(1 + a), faithful; {Q}_MIN if a <= -1."),
    ("sinh", "Q", "Q a", "The hyperbolic sine, faithful, saturated."),
    ("cosh", "Q", "Q a", "The hyperbolic cosine, faithful, saturated to {Q}_MAX."),
    ("tanh", "Q", "Q a", "The hyperbolic tangent, faithful, never outside [-1, 1]."),
    ("cbrt", "Q", "Q a", "The cube root, faithful, negative if a is."),
    ("pow", "Q", "Q x, Q y",
     "x^y, faithful, saturated; 1 if y is 0. Otherwise, if x is 0: 0, or {Q}_MAX if y < 0. If "
     "x < 0: the power of |x|, negated if y is odd, and 0 if y is not an integer."),
]
# All, in the order of the header.
OPERATIONS = [
    ("add", "Q", "Q a, Q b", "a + b modulo 2^{integer}: a sum out of range wraps."),
    ("subtract", "Q", "Q a, Q b",
     "a - b modulo 2^{integer}: a difference out of range wraps."),
    ("negate", "Q", "Q a", "-a; {Q}_MIN stays {Q}_MIN."),
    ("abs", "Q", "Q a", "|a|; {Q}_MIN stays {Q}_MIN."),
    ("multiply", "Q", "Q a, Q b",
     "a b rounded to nearest, half up, modulo 2^{integer}: a product out of range wraps."),
    ("multiply_add", "Q", "Q a, Q b, Q c",
     "a b + c rounded once, to nearest, half up, modulo 2^{integer}."),
    ("divide", "Q", "Q a, Q b",
     "a / b rounded to nearest, half up, saturated to {Q}_MIN and {Q}_MAX. If b is 0: {Q}_MAX "
     "if a > 0, {Q}_MIN if a < 0, 0 if a is 0."),
    ("remainder", "Q", "Q a, Q b",
     "a - b trunc(a / b), exact: 0 or of the sign of a; a if b is 0."),
    ("shift_left", "Q", "Q a, uint8_t count",
     "a 2^count modulo 2^{integer}; 0 from count = {width} on."),
    ("shift_right", "Q", "Q a, uint8_t count",
     "a / 2^count rounded downward; from count = {width} on 0, or -1 ulp if a < 0."),
    ("sqrt", "Q", "Q a", "The square root rounded to nearest; 0 if a < 0."),
    ("reciprocal_sqrt", "Q", "Q a",
     "1 / sqrt(a), faithful, saturated to {Q}_MAX; {Q}_MAX if a is 0, and 0 if a < 0."),
    ("sin", "Q", "Q angle",
     "The sine of any angle in radians, faithful, never outside [-1, 1]."),
    ("cos", "Q", "Q angle",
     "The cosine of any angle in radians, faithful, never outside [-1, 1]."),
    ("sincos", "void", "Q angle, Q sine_and_cosine[2]",
     "Writes what sin and cos return, in that order, in less time than two calls."),
    ("atan", "Q", "Q a", "The arc tangent in radians, faithful."),
    ("atan2", "Q", "Q y, Q x",
     "The angle of the vector (x, y) in radians, in (-pi, pi], faithful; 0 if both are 0."),
    ("exp", "Q", "Q a",
     "e^a, faithful, saturated to {Q}_MAX; it may be 0 if e^a is below 0.75 ulp."),
    ("log", "Q", "Q a", "The natural logarithm, faithful; {Q}_MIN if a <= 0."),
    *ELEMENTARY,
    ("sin_turns", "Q", "Q angle",
     "The sine of any angle in turns, faithful, exact at quarter turns, never outside [-1, 1]."),
    ("cos_turns", "Q", "Q angle",
     "The cosine of any angle in turns, faithful, exact at quarter turns, never outside [-1, 1]."),
    ("sincos_turns", "void", "Q angle, Q sine_and_cosine[2]",
     "Writes what sin_turns and cos_turns return, in that order."),
    ("atan2_turns", "Q", "Q y, Q x",
     "The angle of the vector (x, y) in turns, from -1/2 to 1/2, faithful; 0 if both are 0."),
    ("sin_degrees", "Q", "Q angle",
     "The sine of any angle in degrees, faithful, exact at multiples of 90, never outside "
     "[-1, 1]."),
    ("cos_degrees", "Q", "Q angle",
     "The cosine of any angle in degrees, faithful, exact at multiples of 90, never outside "
     "[-1, 1]."),
    ("sincos_degrees", "void", "Q angle, Q sine_and_cosine[2]",
     "Writes what sin_degrees and cos_degrees return, in that order."),
    ("atan2_degrees", "Q", "Q y, Q x",
     "The angle of the vector (x, y) in degrees, from -180 to 180, faithful, saturated; 0 if "
     "both are 0."),
    ("divrem", "void", "Q a, Q b, Q quotient_and_remainder[2]",
     "Writes trunc(a / b), an integer, saturated, and the exact remainder a - b trunc(a / b), which is "
     "0 or has the sign of a. If b is 0, the quotient is {Q}_MAX if a > 0, {Q}_MIN if a < 0, 0 if a "
     "is 0, and the remainder is a."),
    ("divmod", "void", "Q a, Q b, Q quotient_and_remainder[2]",
     "Writes floor(a / b), an integer, saturated, and the exact remainder a - b floor(a / b), which is "
     "0 or has the sign of b. If b is 0, the results are those of divrem."),
    ("lerp", "Q", "Q a, Q b, Q t",
     "a + t (b - a) rounded once, to nearest, half up, modulo 2^{integer}; for t in [0, 1] between a "
     "and b."),
    ("smoothstep", "Q", "Q t",
     "3 t^2 - 2 t^3 rounded to nearest, half up; 0 if t < 0, and 1 if t > 1."),
    ("midpoint", "Q", "Q a, Q b", "(a + b) / 2 rounded to nearest, half up. No intermediate sum overflows."),
    ("abs_diff", "Q", "Q a, Q b", "|a - b| modulo 2^{integer}."),
    ("sign", "int8_t", "Q a", "-1, 0 or 1 if a is negative, zero or positive."),
    ("isqrt", "int{width}_t", "int{width}_t n",
     "floor(sqrt(n)) of an integer, not of a raw number, exact; 0 if n < 0."),
    ("copysign", "Q", "Q a, Q b", "|a| with the sign of b, where 0 counts as positive; {Q}_MIN if a is {Q}_MIN."),
    ("power", "Q", "Q x, int32_t n",
     "x^n, faithful, saturated; 1 if n is 0, and {Q}_MAX if x is 0 and n < 0."),
    ("dot2", "Q", "const Q a[2], const Q b[2]",
     "a[0] b[0] + a[1] b[1] rounded once, to nearest, half up, modulo 2^{integer}."),
    ("dot3", "Q", "const Q a[3], const Q b[3]",
     "a[0] b[0] + a[1] b[1] + a[2] b[2] rounded once, to nearest, half up, modulo 2^{integer}."),
    ("length2", "Q", "const Q v[2]",
     "The length of v rounded to nearest, saturated to {Q}_MAX. No square overflows."),
    ("length3", "Q", "const Q v[3]",
     "The length of v rounded to nearest, saturated to {Q}_MAX. No square overflows."),
    ("normalise3", "void", "const Q v[3], Q unit[3]",
     "Writes v divided by its length to `unit`, each component within 1 ulp; zeros if v is zero. "
     "`unit` may be `v`."),
    ("from_int32", "Q", "int32_t n",
     "The number n modulo 2^{integer}: n itself if the format can represent it."),
    ("to_int32", "int32_t", "Q a", "The integer nearest to a, half up{beyond_int32}."),
    ("from_float", "Q", "float x",
     "x rounded to nearest, half up, saturated to {Q}_MIN and {Q}_MAX; 0 if x is NaN."),
    ("to_float", "float", "Q a", "The float nearest to a, half to even."),
    ("parse", "fixedpoint_text_status", "const char* text, Q* number",
     "Reads zero-terminated text: an optional sign, digits with an optional point, an optional "
     "exponent, and nothing else. Writes the number, rounded to nearest, half up; {Q}_MIN or {Q}_MAX "
     "if it is out of range, and 0 if the text is not a number. The status returned says which."),
    ("print", "size_t", "Q a, char* text, size_t capacity",
     "Writes the shortest decimal text that parse reads as a, and a terminating zero; returns its "
     "length without the zero. A `capacity` of {Q}_TEXT_CAPACITY is always enough. If the text does "
     "not fit, it returns 0 and writes an empty text, or nothing if `capacity` is 0."),
    ("print_decimals", "size_t", "Q a, uint8_t decimals, char* text, size_t capacity",
     "As print, with that many decimals, rounded to nearest, half up; more than {fraction} count as "
     "{fraction}, which are exact."),
]
HOST_OPERATIONS = [
    ("from_double", "Q", "double x", "As {q}_from_float."),
    ("to_double", "double", "Q a", "The double nearest to a, half to even."),
]

# What a function takes and returns, as fixedpoint_c.cpp names it. It defines all others, which are
# conversions and text, by hand.
SHAPES = {
    "Q(Q)": "unary", "Q(Q, Q)": "binary", "Q(Q, Q, Q)": "ternary", "Q(Q, uint8_t)": "shift",
    "Q(Q, int32_t)": "power", "void(Q, Q[2])": "pair", "void(Q, Q, Q[2])": "binary_pair",
    "Q(const Q[2], const Q[2])": "dot", "Q(const Q[3], const Q[3])": "dot", "Q(const Q[2])": "length",
    "Q(const Q[3])": "length", "void(const Q[3], Q[3])": "direction", "int8_t(Q)": "sign",
    "int{width}_t(int{width}_t)": "integer",
    # Without the structure that the others of this kind return.
    "sincos": "direct_pair",
    # Operators in C++.
    "add": "operator", "subtract": "operator", "multiply": "operator", "divide": "operator",
    "remainder": "operator", "negate": "negation",
}

HEAD = """\
/* SPDX-License-Identifier: MIT
 * DO NOT EDIT: written by python3 fixedpoint/tables/functions.py */
/// \\file
/// The library for C, and for every language that can call C: each operation is a function on
/// plain integers. A number of Q16.16 is an int32_t, value = raw / 2^16; q16_16 names that type.
///
/// An "ulp" is the distance between adjacent numbers; a "faithful" result errs by less than 0.75
/// ulp. Compare numbers with the operators of C. On an AVR with a multiplier, a function that has
/// an assembly kernel is that kernel. All other functions are in fixedpoint_c.cpp: link the library
/// that CMake builds from it, or compile it with the program. Define FIXEDPOINT_NO_ASSEMBLY for
/// both to turn the kernels off.
#ifndef FIXEDPOINT_C_H
#define FIXEDPOINT_C_H

/* clang-format off */
#include <stddef.h>
#include <stdint.h>

#ifndef FIXEDPOINT_C_KERNEL
#if defined(__AVR__) && defined(__AVR_HAVE_MUL__) && !defined(FIXEDPOINT_NO_ASSEMBLY)
#define FIXEDPOINT_C_KERNEL(symbol) __asm__(#symbol)
#else
#define FIXEDPOINT_C_KERNEL(symbol)
#endif
#endif

/// \\cond internal
/* n 2^F / d rounded to nearest, half up, as an integer constant expression. */
#define FIXEDPOINT_C_FLOOR(p, q) ((p) / (q) - ((p) % (q) < 0))
#define FIXEDPOINT_C_RATIO(n, d, F) \\
    FIXEDPOINT_C_FLOOR((int64_t)(n) * (INT64_C(2) << (F)) + (d), INT64_C(2) * (d))
/// \\endcond

#ifdef __cplusplus
extern "C" {
#endif

/// What a parse function reports: one of the four values below.
typedef uint8_t fixedpoint_text_status;
/// The text is a number in the range.
#define FIXEDPOINT_TEXT_OK 0
/// The text is empty.
#define FIXEDPOINT_TEXT_EMPTY 1
/// The text is not a decimal number.
#define FIXEDPOINT_TEXT_MALFORMED 2
/// The text is a decimal number outside the range of the format.
#define FIXEDPOINT_TEXT_OUT_OF_RANGE 3
"""
TAIL = """
#ifdef __cplusplus
}
#endif

/* clang-format on */
#endif
"""


def kernels():
    """The symbol of each kernel, by operation, width and fraction bits."""
    table = page.SOURCE / "kernel" / "table.hpp"
    rows = subprocess.run(
        ["g++", "-E", "-P", "-xc++", "-"], check=True, capture_output=True, text=True,
        input=f'#include "{table}"\n#define ROW(shape, operation, Raw, F, symbol, implementation) '
              "operation Raw F symbol;\nFIXEDPOINT_KERNELS(ROW)\n").stdout
    return {(operation, raw, int(fraction)): symbol for operation, raw, fraction, symbol in (
        row.split() for row in rows.replace("\n", " ").split(";") if row.strip())}


def comment(sentence):
    return textwrap.wrap(sentence, 100, initial_indent="/// ", subsequent_indent="/// ")


def text_capacity(integer, fraction):
    """A sign, the digits of the integer part, a point, the decimals and the terminating zero."""
    return 1 + len(str(2**(integer - 1))) + 1 + fraction + 1


def section(integer, fraction, symbols):
    """The declarations of one format."""
    q, width = f"q{integer}_{fraction}", integer + fraction
    upper, raw = q.upper(), f"int{width}_t"
    beyond = ("; -2^31 from 2^31 - 1/2 on" if integer == 32 else "")
    words = {"q": q, "Q": upper, "width": width, "integer": integer, "fraction": fraction,
             "beyond_int32": beyond}

    def declare(name, result, parameters, sentence):
        symbol = symbols.get((name, raw, fraction))
        label = f"\n    FIXEDPOINT_C_KERNEL({symbol})" if symbol else ""
        declaration = f"{result} {{q}}_{name}({parameters})".replace("Q ", f"{q} ").replace(
            "Q* ", f"{q}* ").format(**words)
        return [*comment(sentence.format(**words)), f"{declaration}{label};"]

    lines = [
        *comment(f"A number of Q{integer}.{fraction}: raw / 2^{fraction}, from -2^{integer - 1} "
                 f"to 2^{integer - 1} - 2^-{fraction}."),
        f"typedef {raw} {q};",
        "/// The largest number.", f"#define {upper}_MAX INT{width}_MAX",
        "/// The smallest number.", f"#define {upper}_MIN INT{width}_MIN",
        "/// The number 1.", f"#define {upper}_ONE (({q})(INT64_C(1) << {fraction}))",
        *comment("The constant n / d of two integers, rounded to nearest, half up: "
                 f"{upper}_RATIO(38, 100) is 0.38. d must be in 1..2^30, n in -2^29..2^29, and "
                 "the quotient in range."),
        f"#define {upper}_RATIO(n, d) (({q})FIXEDPOINT_C_RATIO(n, d, {fraction}))",
        "/// The capacity that is enough for the text of every number, including its terminating zero.",
        f"#define {upper}_TEXT_CAPACITY {text_capacity(integer, fraction)}",
    ]
    for operation in OPERATIONS:
        lines += declare(*operation)
    lines += ["#ifndef __AVR__  /* whose double is a float */"]
    for operation in HOST_OPERATIONS:
        lines += declare(*operation)
    lines += ["#endif"]
    return lines


def conversion(source, target):
    """The declaration of the conversion from one format to another."""
    (from_integer, from_fraction), (to_integer, to_fraction) = source, target
    rounds, wraps = to_fraction < from_fraction, to_integer < from_integer
    how = [*(["rounded to nearest, half up"] if rounds else []),
           *([f"modulo 2^{to_integer}"] if wraps or (rounds and to_integer == from_integer) else [])]
    return [f"/// a {', '.join(how) or 'itself: exact'}.",
            f"q{to_integer}_{to_fraction} q{to_integer}_{to_fraction}_from_q{from_integer}_"
            f"{from_fraction}(q{from_integer}_{from_fraction} a);"]


LIST_HEAD = """\
/* SPDX-License-Identifier: MIT
 * DO NOT EDIT: written by python3 fixedpoint/tables/functions.py
 * What fixedpoint_c.h declares, for fixedpoint_c.cpp and the tests. */
#ifndef FIXEDPOINT_C_FUNCTIONS_H
#define FIXEDPOINT_C_FUNCTIONS_H

/* clang-format off */
"""
LIST_TAIL = """\

/* clang-format on */
#endif
"""


def macro(comment, name, parameters, rows):
    """A macro that passes each row to its first parameter, X, with any further arguments."""
    further = ", __VA_ARGS__" if "..." in parameters else ""
    calls = [f"    X({', '.join(map(str, row))}{further})" for row in rows]
    return [f"/* {comment} */", f"#define {name}({parameters}) \\", " \\\n".join(calls)]


def functions():
    """The lines of c_functions.h."""
    names = [(f"q{integer}_{fraction}", f"Q{integer}_{fraction}", integer, fraction)
             for integer, fraction in FORMATS]
    lines = macro("X(format, its constants' prefix, integer bits, fraction bits)",
                  "FIXEDPOINT_C_FORMATS", "X", names)
    for q, *_ in names:
        lines += macro(f"X(each other format than {q}, ...)", f"FIXEDPOINT_C_BESIDE_{q}", "X, ...",
                       [(other,) for other, *_ in names if other != q])
    rows = []
    for name, result, parameters, _ in OPERATIONS:
        types = [re.sub(r"\w+(\[\d\])?$", r"\1", each).replace(" [", "[").strip()
                 for each in parameters.split(", ")]
        signature = f"{result}({', '.join(types)})"
        shape = SHAPES.get(name, SHAPES.get(signature))
        if shape:
            rows.append((name, shape))
    return lines + macro("X(function, what it takes and returns, ...)", "FIXEDPOINT_C_FUNCTIONS",
                         "X, ...", rows)


ELEMENTARY_HEAD = """\
// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/functions.py
// The elementary functions without a kernel of their own in most formats, as X(name, class of its
// evaluation); pow alone takes two operands. The arithmetics, the events of Checked and Recorded
// expand the list; kernel/elementary.hpp says which formats use kernels.
#pragma once

// clang-format off
"""


def elementary_functions():
    """The text of portable/elementary_functions.hpp."""
    def rows(operands):
        return "".join(f" \\\n    X({name}, {name.capitalize()})"
                       for name, _, parameters, _ in ELEMENTARY if parameters.count(",") + 1 == operands)
    return (f"{ELEMENTARY_HEAD}#define FIXEDPOINT_ELEMENTARY_UNARY(X){rows(1)}\n"
            f"#define FIXEDPOINT_ELEMENTARY_FUNCTIONS(X) \\\n    FIXEDPOINT_ELEMENTARY_UNARY(X){rows(2)}\n")


if __name__ == "__main__":
    known = kernels()
    lines = []
    for bits in FORMATS:
        lines += ["", f"/* Q{bits[0]}.{bits[1]} */", ""] + section(*bits, known)
    lines += ["", "/* From one format to another */", ""]
    for to in FORMATS:
        for origin in FORMATS:
            if origin != to:
                lines += conversion(origin, to)
    (page.SOURCE.parent / "fixedpoint_c.h").write_text(HEAD + "\n".join(lines) + "\n" + TAIL)
    (page.SOURCE / "c_functions.h").write_text(LIST_HEAD + "\n".join(functions()) + "\n" + LIST_TAIL)
    (page.SOURCE / "portable" / "elementary_functions.hpp").write_text(elementary_functions())
