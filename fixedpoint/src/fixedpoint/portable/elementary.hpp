// SPDX-License-Identifier: MIT
// The elementary functions without a kernel of their own in most formats, as X(name, class of its
// evaluation). The arithmetics expand the list; kernel/elementary.hpp says which formats use
// kernels. All are templates: a program pays only for those it calls.
#pragma once

#include <fixedpoint/portable/arc_sines.hpp>
#include <fixedpoint/portable/exponentials.hpp>
#include <fixedpoint/portable/logarithms.hpp>
#include <fixedpoint/portable/powers.hpp>
#include <fixedpoint/portable/tan.hpp>

#define FIXEDPOINT_ELEMENTARY_FUNCTIONS(X) \
    X(tan, Tan)                            \
    X(asin, Asin)                          \
    X(acos, Acos)                          \
    X(exp2, Exp2)                          \
    X(expm1, Expm1)                        \
    X(log2, Log2)                          \
    X(log10, Log10)                        \
    X(log1p, Log1p)                        \
    X(sinh, Sinh)                          \
    X(cosh, Cosh)                          \
    X(tanh, Tanh)                          \
    X(cbrt, Cbrt)                          \
    X(pow, Pow)
