// SPDX-License-Identifier: MIT
// remainder: a - b trunc(a / b), exact, with the sign of a; a if b = 0. divrem: trunc(a / b), an
// integer, and that remainder. divmod: floor(a / b) and its remainder, which has the sign of b.
// Quotients are saturated; if b = 0, they are the limit with the sign of a, or 0.
#pragma once

#include <fixedpoint/portable/add_saturating.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw, int F>
constexpr Raw remainder(Raw a, Raw b) {
    // A divisor of -1 is a special case: the quotient of the smallest number would overflow.
    return b == 0 ? a : is_minus_one(b) ? Raw(0) : static_cast<Raw>(a % b);
}

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void divrem(Raw a, Raw b, Raw* quotient_and_remainder) {
    const Raw quotient = b == 0                     ? (a == 0 ? Raw(0) : limit_by_sign(a))
                         : !is_minus_one(b)         ? static_cast<Raw>(a / b)
                         : a == RawLimits<Raw>::min ? RawLimits<Raw>::max
                                                    : static_cast<Raw>(-a);
    quotient_and_remainder[0] = quotient;
    quotient_and_remainder[1] = b == 0            ? a
                                : is_minus_one(b) ? Raw(0)
                                                  : static_cast<Raw>(a - quotient * b);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void divmod(Raw a, Raw b, Raw* quotient_and_remainder) {
    divrem<Raw, F>(a, b, quotient_and_remainder);
    const Raw rest = quotient_and_remainder[1];
    if (b == 0 || rest == 0 || (rest < 0) == (b < 0)) return;
    quotient_and_remainder[0] = static_cast<Raw>(quotient_and_remainder[0] - 1);
    quotient_and_remainder[1] = static_cast<Raw>(rest + b);
}

}  // namespace portable
}  // namespace fixedpoint
