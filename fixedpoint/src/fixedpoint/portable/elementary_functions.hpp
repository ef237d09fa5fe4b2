// SPDX-License-Identifier: MIT
// The elementary functions without a kernel of their own in most formats, as X(name, class of its
// evaluation); pow alone takes two operands. The arithmetics, the events of Checked and
// Recorded expand the list; kernel/elementary.hpp says which formats use kernels.
#pragma once

#define FIXEDPOINT_ELEMENTARY_UNARY(X) \
    X(tan, Tan)                        \
    X(asin, Asin)                      \
    X(acos, Acos)                      \
    X(exp2, Exp2)                      \
    X(expm1, Expm1)                    \
    X(log2, Log2)                      \
    X(log10, Log10)                    \
    X(log1p, Log1p)                    \
    X(sinh, Sinh)                      \
    X(cosh, Cosh)                      \
    X(tanh, Tanh)                      \
    X(cbrt, Cbrt)
#define FIXEDPOINT_ELEMENTARY_FUNCTIONS(X) \
    FIXEDPOINT_ELEMENTARY_UNARY(X)         \
    X(pow, Pow)

// X(operation, ...): the operations that Checked reports.
// clang-format off
#define FIXEDPOINT_REPORTED_OPERATIONS(X)                                                    \
    X(add, ) X(subtract, ) X(negate, ) X(multiply, ) X(divide, ) X(remainder, )              \
    X(shift_left, ) X(convert, ) X(sqrt, ) X(reciprocal_sqrt, ) X(log, ) X(multiply_add, )   \
    X(dot, ) X(length, ) X(scale_down, ) X(cos, ) X(atan2, ) X(exp, ) X(normalise, )         \
    X(ceil, ) X(round, ) X(from_float, ) X(from_decimal, )                                   \
    FIXEDPOINT_ELEMENTARY_FUNCTIONS(X)                                                       \
    X(lerp, ) X(power, )
// clang-format on
#define FIXEDPOINT_ENUMERATOR(name, ...) name,
