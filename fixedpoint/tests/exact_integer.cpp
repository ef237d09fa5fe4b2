// SPDX-License-Identifier: MIT
#include "exact_integer.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <new>
#include <type_traits>

namespace exact {

struct Int::Access {
    using Value = boost::multiprecision::number<
        boost::multiprecision::cpp_int_backend<1024, 1024, boost::multiprecision::signed_magnitude,
                                               boost::multiprecision::checked, void>,
        boost::multiprecision::et_off>;
    static_assert(sizeof(Value) <= sizeof(Int::storage_) && alignof(Value) <= 16,
                  "The storage of Int has to hold the number.");
    static_assert(std::is_trivially_destructible_v<Value>, "Nothing destroys the number.");

    static const Value& of(const Int& a) { return *reinterpret_cast<const Value*>(a.storage_); }
    static void set(Int& a, const Value& value) { new (a.storage_) Value(value); }
    static Int make(const Value& value) {
        Int made;
        set(made, value);
        return made;
    }
};

Int::Int(__int128 n) { Access::set(*this, Access::Value(n)); }
Int::Int(const Int& other) { Access::set(*this, Access::of(other)); }
Int& Int::operator=(const Int& other) {
    if (&other != this) Access::set(*this, Access::of(other));
    return *this;
}

Int operator+(const Int& a, const Int& b) {
    return Int::Access::make(Int::Access::of(a) + Int::Access::of(b));
}
Int operator-(const Int& a, const Int& b) {
    return Int::Access::make(Int::Access::of(a) - Int::Access::of(b));
}
Int operator*(const Int& a, const Int& b) {
    return Int::Access::make(Int::Access::of(a) * Int::Access::of(b));
}
Int operator/(const Int& a, const Int& b) {
    return Int::Access::make(Int::Access::of(a) / Int::Access::of(b));
}
Int operator%(const Int& a, const Int& b) {
    return Int::Access::make(Int::Access::of(a) % Int::Access::of(b));
}
Int operator<<(const Int& a, unsigned bits) {
    // Boost does not shift negative integers.
    return a < 0 ? -(-a << bits) : Int::Access::make(Int::Access::of(a) << bits);
}

std::strong_ordering operator<=>(const Int& a, const Int& b) {
    return Int::Access::of(a).compare(Int::Access::of(b)) <=> 0;
}

Int::operator uint64_t() const {
    const uint64_t low = *Access::of(*this).backend().limbs();
    return *this < 0 ? -low : low;
}
std::string Int::str() const { return Access::of(*this).str(); }

Int power(int base, unsigned exponent) {
    return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

Int floor_of(const Int& numerator, const Int& denominator) {
    const Int quotient = numerator / denominator;
    return numerator < 0 && quotient * denominator != numerator ? quotient - 1 : quotient;
}
Int nearest(const Int& numerator, const Int& denominator) {
    return floor_of(2 * numerator + denominator, 2 * denominator);
}
int64_t wrapped(const Int& n, int width) {
    return static_cast<int64_t>(static_cast<uint64_t>(n) << (64 - width)) >> (64 - width);
}
int64_t saturated(const Int& n, int width) {
    return n < smallest(width)  ? smallest(width)
           : n > largest(width) ? largest(width)
                                : wrapped(n, width);
}

}  // namespace exact
