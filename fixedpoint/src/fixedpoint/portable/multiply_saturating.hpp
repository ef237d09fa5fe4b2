// SPDX-License-Identifier: MIT
// multiply_saturating: floor(a b / 2^F + 1/2), saturated to the smallest or largest number.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/wide.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw, int F>
struct SaturatingMultiplication {
    static FIXEDPOINT_CONSTEXPR Raw apply(Raw a, Raw b) {
        const Wide<Raw> rounded = static_cast<Wide<Raw>>(
            (static_cast<Wide<Raw>>(a) * b + ((Wide<Raw>(1) << F) >> 1)) >> F);
        return rounded > RawLimits<Raw>::max   ? RawLimits<Raw>::max
               : rounded < RawLimits<Raw>::min ? RawLimits<Raw>::min
                                               : static_cast<Raw>(rounded);
    }
};

template <class Raw, int F>
struct SaturatingMultiplication64 {
    static FIXEDPOINT_CONSTEXPR Raw apply(Raw a, Raw b) {
        const bool negative = (a < 0) != (b < 0);
        const Wide128 product = multiply_full(magnitude(a), magnitude(b));
        // Half an ulp, less one unit if the result is negative: a tie then goes towards zero.
        const uint64_t half = (uint64_t(1) << F) >> 1;
        const uint64_t bias = half - (negative && F != 0 ? 1 : 0);
        const uint64_t low = product.low + bias;
        const uint64_t high = product.high + (low < bias ? 1 : 0);
        if (F == 0 ? high != 0 : (high >> F) != 0)
            return negative ? RawLimits<Raw>::min : RawLimits<Raw>::max;
        const uint64_t rounded = F == 0 ? low : (high << (63 - (F - 1))) | (low >> F);
        return saturated_with_sign<Raw>(rounded, negative);
    }
};
template <int F>
struct SaturatingMultiplication<int64_t, F> : SaturatingMultiplication64<int64_t, F> {};
template <int F>
struct SaturatingMultiplication<uint64_t, F> : SaturatingMultiplication64<uint64_t, F> {};

template <class Raw, int F>
constexpr Raw multiply_saturating(Raw a, Raw b) {
    return SaturatingMultiplication<Raw, F>::apply(a, b);
}

}  // namespace portable
}  // namespace fixedpoint
