// SPDX-License-Identifier: MIT
// Unsigned integers of at least twice the width of a Raw: a native one up to 64 bits, Word128
// above. Square roots of sums of squares and of ratios need them.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/wide.hpp>
#include <fixedpoint/portable/word128.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw>
struct DoubleWordOf {
    using Type = Unsigned<Wide<Raw>>;
    static constexpr Unsigned<Raw> high(Type a) {
        return static_cast<Unsigned<Raw>>(a >> RawLimits<Raw>::width);
    }
    static constexpr Unsigned<Raw> low(Type a) { return static_cast<Unsigned<Raw>>(a); }
    static constexpr Type multiply(Unsigned<Raw> a, Unsigned<Raw> b) {
        return static_cast<Type>(static_cast<Type>(a) * b);
    }
};

struct DoubleWordOf64 {
    using Type = Word128;
    static constexpr uint64_t high(Type a) { return a.high; }
    static constexpr uint64_t low(Type a) { return a.low; }
    static FIXEDPOINT_CONSTEXPR Type multiply(uint64_t a, uint64_t b) {
        const Wide128 product = multiply_full(a, b);
        return {product.high, product.low};
    }
};
template <>
struct DoubleWordOf<int64_t> : DoubleWordOf64 {};
template <>
struct DoubleWordOf<uint64_t> : DoubleWordOf64 {};

template <class Raw>
using DoubleWord = typename DoubleWordOf<Raw>::Type;

// a^2, and a_0^2 + ... + a_(n-1)^2, exact for up to 3 components: at most 3 * 2^(2W-2).
template <class Raw>
constexpr DoubleWord<Raw> square(Raw a) {
    return DoubleWordOf<Raw>::multiply(magnitude(a), magnitude(a));
}
template <class Raw>
FIXEDPOINT_CONSTEXPR DoubleWord<Raw> sum_of_squares(const Raw* a, int n) {
    DoubleWord<Raw> sum = square(a[0]);
    for (int i = 1; i < n; ++i) sum = static_cast<DoubleWord<Raw>>(sum + square(a[i]));
    return sum;
}

}  // namespace portable
}  // namespace fixedpoint
