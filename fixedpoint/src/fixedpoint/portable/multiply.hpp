// SPDX-License-Identifier: MIT
// multiply: floor(a b / 2^F + 1/2) modulo 2^W, the product rounded to nearest, ties upward.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/wide.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw, int F>
struct Multiplication {
    static constexpr Raw apply(Raw a, Raw b) {
        // The double-width product plus half an ulp cannot overflow: |a b| <= 2^(2W-2).
        return static_cast<Raw>(
            (static_cast<Wide<Raw>>(a) * b + ((Wide<Raw>(1) << F) >> 1)) >> F);
    }
};

template <int F>
struct Multiplication<int64_t, F> {
    static constexpr int64_t apply(int64_t a, int64_t b) {
        // Two's complement: the signed product is the unsigned one less b 2^64 where a < 0 and
        // a 2^64 where b < 0.
        const Wide128 product = multiply_full(static_cast<uint64_t>(a), static_cast<uint64_t>(b));
        uint64_t high = product.high;
        if (a < 0) high -= static_cast<uint64_t>(b);
        if (b < 0) high -= static_cast<uint64_t>(a);
        const uint64_t half = (uint64_t(1) << F) >> 1;
        const uint64_t low = product.low + half;
        if (low < half) ++high;
        return static_cast<int64_t>(F == 0 ? low : (high << (63 - (F - 1))) | (low >> F));
    }
};

template <class Raw, int F>
constexpr Raw multiply(Raw a, Raw b) {
    return Multiplication<Raw, F>::apply(a, b);
}

}  // namespace portable
}  // namespace fixedpoint
