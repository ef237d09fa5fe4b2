// SPDX-License-Identifier: MIT
// Exact sums of products of raw numbers, the reference for the blocks.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/fixed.hpp>
#include <random>

namespace exact {

using Exact = __int128;

// floor(a / 2^bits + 1/2).
inline Exact rounded(Exact a, int bits) {
    return bits == 0 ? a : (a + (Exact(1) << (bits - 1))) >> bits;
}
template <class Number>
Exact product(Number a, Number b) {
    return Exact(a.raw()) * b.raw();
}
template <class Number>
long double value(Number a) {
    return std::ldexp(static_cast<long double>(a.raw()), -Number::fraction_bits);
}
template <class Number>
long double ulp() {
    return std::ldexp(1.0L, -Number::fraction_bits);
}
// x truncated to the format. x must be in range.
template <class Number>
Number number(long double x) {
    return Number::from_raw(
        static_cast<typename Number::Raw>(std::ldexp(x, Number::fraction_bits)));
}
// A number in [-limit, limit], of every magnitude.
template <class Number>
Number random_number(std::mt19937_64& random, long double limit) {
    const long double most = std::min(limit, value(Number::max()));
    const long double x = std::ldexp(most * (static_cast<long double>(random()) / 0x1p63L - 1),
                                     -static_cast<int>(random() % 4) * int(random() % 3));
    return number<Number>(x);
}

}  // namespace exact
