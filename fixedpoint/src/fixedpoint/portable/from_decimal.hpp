// SPDX-License-Identifier: MIT
// from_decimal: a number given as an integer divided by a power of ten.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/decimal_fraction.hpp>

namespace fixedpoint {
namespace portable {

// n / 10^decimals, rounded to nearest, half up, and saturated: from_decimal(38, 2) is 0.38. n must
// be a signed integer, of any width.
template <class Raw, int F, class Int>
FIXEDPOINT_CONSTEXPR Converted<Raw> from_decimal(Int n, uint8_t decimals) {
    static_assert(Int(-1) < Int(1), "from_decimal takes a signed integer.");
    using Word =
        UnsignedInteger<(sizeof(DecimalWord<Raw, F>) > 4 || RawLimits<Int>::width > 32) ? 64 : 32>;
    Word integer = magnitude<Integer<RawLimits<Int>::width>>(n);
    DecimalFraction<Word> fraction = {0, false};
    for (; decimals > 0; --decimals) {
        fraction.prepend(static_cast<uint8_t>(integer % 10));
        integer /= 10;
    }
    return assemble<Raw, F>(integer, fraction, n < 0);
}

}  // namespace portable
}  // namespace fixedpoint
