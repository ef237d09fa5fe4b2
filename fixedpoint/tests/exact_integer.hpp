// SPDX-License-Identifier: MIT
// Exact integers for the tests whose numbers have any number of digits, as decimal text, or more
// than twice 64; other tests are held against exact.hpp, which is compiled once.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <fixedpoint/integer.hpp>
#include <vector>

#include "exact.hpp"

namespace exact {

using Int = boost::multiprecision::cpp_int;

inline Int floor_of(const Int& numerator, const Int& denominator) {
    const Int quotient = numerator / denominator;
    return numerator < 0 && quotient * denominator != numerator ? quotient - 1 : quotient;
}

// numerator / denominator to nearest, ties upward. The denominator is positive.
inline Int nearest(const Int& numerator, const Int& denominator) {
    return floor_of(2 * numerator + denominator, 2 * denominator);
}

inline Int power(int base, unsigned exponent) {
    return boost::multiprecision::pow(Int(base), exponent);
}

template <class Raw>
bool fits(const Int& n) {
    return n >= std::numeric_limits<Raw>::min() && n <= std::numeric_limits<Raw>::max();
}

template <class Raw>
Raw clamped(const Int& n) {
    return n < std::numeric_limits<Raw>::min()   ? std::numeric_limits<Raw>::min()
           : n > std::numeric_limits<Raw>::max() ? std::numeric_limits<Raw>::max()
                                                 : static_cast<Raw>(n);
}

// n modulo 2^W, as a two's-complement number is.
template <class Raw>
Raw wrapped(const Int& n) {
    const Int modulus = Int(1) << static_cast<int>(8 * sizeof(Raw));
    const Int rest = n - floor_of(n, modulus) * modulus;
    return static_cast<Raw>(static_cast<uint64_t>(rest));
}

template <class Raw>
std::vector<Raw> raws() {
    const std::vector<int64_t> numbers = raws(8 * int{sizeof(Raw)});
    return {numbers.begin(), numbers.end()};
}

}  // namespace exact
