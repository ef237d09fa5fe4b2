// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/functions.py
// The elementary functions without a kernel of their own in most formats, as X(name, class of its
// evaluation); pow alone takes two operands. The arithmetics, the events of Checked and Recorded
// expand the list; kernel/elementary.hpp says which formats use kernels.
#pragma once

// clang-format off
#define FIXEDPOINT_ELEMENTARY_UNARY(X) \
    X(tan, Tan) \
    X(asin, Asin) \
    X(acos, Acos) \
    X(exp2, Exp2) \
    X(expm1, Expm1) \
    X(log2, Log2) \
    X(log10, Log10) \
    X(log1p, Log1p) \
    X(sinh, Sinh) \
    X(cosh, Cosh) \
    X(tanh, Tanh) \
    X(cbrt, Cbrt)
#define FIXEDPOINT_ELEMENTARY_FUNCTIONS(X) \
    FIXEDPOINT_ELEMENTARY_UNARY(X) \
    X(pow, Pow)
