// SPDX-License-Identifier: MIT
// Exact integers for tests whose numbers have arbitrarily many digits, such as decimal text, or
// more than twice 64 bits; other tests use exact.hpp.
//
// The number itself, a type of Boost.Multiprecision, is hidden behind plain functions: tests that
// inlined it took three times as long to compile, and ran slower under the sanitizers.
#pragma once

#include <compare>
#include <cstdint>
#include <ostream>
#include <string>

#include "exact.hpp"

namespace exact {

// Up to 1024 bits; a wider result throws std::overflow_error.
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
// numerator / denominator rounded to nearest, half up. The denominator must be positive.
Int nearest(const Int& numerator, const Int& denominator);

// n modulo 2^W, as a two's-complement number.
int64_t wrapped(const Int& n, int width);
// n saturated to `width` bits.
int64_t saturated(const Int& n, int width);
inline bool fits(const Int& n, int width) { return n == wrapped(n, width); }

}  // namespace exact
