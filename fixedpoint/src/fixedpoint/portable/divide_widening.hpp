// SPDX-License-Identifier: MIT
// divide_widening: the result of divide, by a division that widens to 2W bits only if it must, that
// is, if |a| 2^F does not fit in W bits.
#pragma once

#include <fixedpoint/portable/divide.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw divide_widening(Raw a, Raw b) {
    const Unsigned<Raw> dividend = magnitude(a);
    const bool fits = F == 0 || dividend >> (F == 0 ? 0 : RawLimits<Raw>::width - F) == 0;
    if (!fits || b == 0) return divide<Raw, F>(a, b);
    const bool negative = (a < 0) != (b < 0);
    return saturated_with_sign<Raw>(
        rounded_quotient<Raw>(static_cast<Unsigned<Raw>>(dividend << F % RawLimits<Raw>::width),
                              magnitude(b), !negative),
        negative);
}

}  // namespace portable
}  // namespace fixedpoint
