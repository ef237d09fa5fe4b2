// SPDX-License-Identifier: MIT
// Exact integers for the tests whose numbers have any number of digits, as decimal text, or more
// than twice 64; other tests are held against exact.hpp, which is compiled once.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <fixedpoint/integer.hpp>
#include <random>
#include <vector>

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

// Every number of 8 and 16 bits; of wider ones those within 2 of a power of two, of either sign,
// and of the limits, and random ones of every magnitude.
template <class Raw>
std::vector<Raw> raws() {
    std::vector<Raw> numbers;
    if (sizeof(Raw) <= 2) {
        for (long n = std::numeric_limits<Raw>::min(); n <= std::numeric_limits<Raw>::max(); ++n) {
            numbers.push_back(static_cast<Raw>(n));
        }
        return numbers;
    }
    std::mt19937_64 random(20);
    const int width = static_cast<int>(8 * sizeof(Raw));
    for (int bit = 0; bit < width; ++bit) {
        const uint64_t one = uint64_t(1) << bit;
        for (int offset = -2; offset <= 2; ++offset) {
            numbers.push_back(static_cast<Raw>(one + static_cast<uint64_t>(offset)));
            numbers.push_back(static_cast<Raw>(static_cast<uint64_t>(offset) - one));
        }
        for (int i = 0; i < 50; ++i) {
            const uint64_t n = random() >> (63 - bit);
            numbers.push_back(static_cast<Raw>(n));
            numbers.push_back(static_cast<Raw>(-n));
        }
    }
    return numbers;
}

}  // namespace exact
