// SPDX-License-Identifier: MIT
// Exact products and sums of products in twice the width, and their final rounding.
#pragma once

#include <fixedpoint/portable/double_word.hpp>

namespace fixedpoint {
namespace portable {

// a b modulo 2^(2W), which represents it exactly.
template <class Raw>
constexpr DoubleWord<Raw> exact_product(Raw a, Raw b) {
    return static_cast<DoubleWord<Raw>>(static_cast<Wide<Raw>>(a) * b);
}
template <>
FIXEDPOINT_CONSTEXPR Word128 exact_product<int64_t>(int64_t a, int64_t b) {
    // Two's complement: the signed product is the unsigned one minus b 2^64 if a < 0 and minus a
    // 2^64 if b < 0.
    const Wide128 product = multiply_full(static_cast<uint64_t>(a), static_cast<uint64_t>(b));
    return {product.high - (a < 0 ? static_cast<uint64_t>(b) : 0) -
                (b < 0 ? static_cast<uint64_t>(a) : 0),
            product.low};
}
template <>
FIXEDPOINT_CONSTEXPR Word128 exact_product<uint64_t>(uint64_t a, uint64_t b) {
    return DoubleWordOf<uint64_t>::multiply(a, b);
}

// floor(sum / 2^F + 1/2) modulo 2^W. The carry out of 2W bits is above the result, since F <= W.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw round_product_sum(DoubleWord<Raw> sum) {
    using Sum = DoubleWord<Raw>;
    const Sum half = static_cast<Sum>(Sum(uint8_t(F != 0)) << (F == 0 ? 0 : F - 1));
    return static_cast<Raw>(static_cast<Sum>(sum + half) >> F);
}

}  // namespace portable
}  // namespace fixedpoint
