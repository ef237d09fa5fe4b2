// SPDX-License-Identifier: MIT
// Exact integers for the tests whose numbers have any number of digits, as decimal text, or more
// than twice 64; other tests are held against exact.hpp.
//
// The number itself, a type of Boost.Multiprecision, is behind plain functions: each test that
// inlined it compiled for three times as long, and ran slower under the sanitizers.
#pragma once

#include <compare>
#include <cstdint>
#include <ostream>
#include <string>

#include "exact.hpp"

namespace exact {

// Of up to 1024 bits; std::overflow_error for a result of more.
class Int {
  public:
    Int(__int128 n = 0);
    Int(const Int& other);
    Int& operator=(const Int& other);

    friend Int operator+(const Int& a, const Int& b);
    friend Int operator-(const Int& a, const Int& b);
    friend Int operator*(const Int& a, const Int& b);
    friend Int operator/(const Int& a, const Int& b);  // toward zero
    friend Int operator%(const Int& a, const Int& b);  // a - a / b * b
    friend Int operator<<(const Int& a, unsigned bits);
    Int operator-() const { return 0 - *this; }

    friend bool operator==(const Int& a, const Int& b) { return a <=> b == 0; }
    friend std::strong_ordering operator<=>(const Int& a, const Int& b);

    explicit operator uint64_t() const;  // modulo 2^64
    std::string str() const;
    friend std::ostream& operator<<(std::ostream& out, const Int& a) { return out << a.str(); }

  private:
    struct Access;  // to the number in the storage
    alignas(16) unsigned char storage_[160];
};

inline Int abs(const Int& a) { return a < 0 ? -a : a; }
// base^exponent.
Int power(int base, unsigned exponent);

Int floor_of(const Int& numerator, const Int& denominator);
// numerator / denominator to nearest, ties upward. The denominator is positive.
Int nearest(const Int& numerator, const Int& denominator);

// n modulo 2^W, as a two's-complement number is.
int64_t wrapped(const Int& n, int width);
// The number closest to n.
int64_t clamped(const Int& n, int width);
inline bool fits(const Int& n, int width) { return n == wrapped(n, width); }

}  // namespace exact
