// SPDX-License-Identifier: MIT
/// \file
/// The square root of an integer.
#pragma once

#include <fixedpoint/builtin.hpp>
#include <fixedpoint/kernel/integer_root.hpp>

namespace fixedpoint {

/// floor(sqrt(n)) for an integer n of any type, exact; 0 if n < 0.
template <class Int>
FIXEDPOINT_CONSTEXPR Int isqrt(Int n) {
    static_assert(BuiltinNumber<Int>::kind == BuiltinKind::integer,
                  "isqrt takes an integer: use sqrt for a fixed-point number.");
    return static_cast<Int>(kernel::has_assembly ? kernel::integer_root(n)
                            : n < Int(1)         ? Unsigned<Int>(0)
                                         : portable::integer_root(static_cast<Unsigned<Int>>(n)));
}

}  // namespace fixedpoint
