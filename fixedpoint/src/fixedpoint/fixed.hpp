// SPDX-License-Identifier: MIT
// Fixed<IntegerBits, FractionBits, Arithmetic>: a signed fixed-point number, value = raw / 2^F, in
// a two's-complement integer of IntegerBits + FractionBits = 8, 16, 32 or 64 bits. The sign counts
// as an integer bit. Arithmetic decides how results are rounded and what happens when they do not
// fit: see arithmetic/nearest.hpp for the rule that the default follows for every input.
//
// Conversions are explicit: from_raw, from_integer, or a literal of literals.hpp.
#pragma once

#include <fixedpoint/arithmetic/nearest.hpp>
#include <fixedpoint/integer.hpp>

namespace fixedpoint {

template <int IntegerBits, int FractionBits, class ArithmeticPolicy = Nearest>
class Fixed {
    static_assert(IntegerBits >= 1, "IntegerBits counts the sign and is at least 1.");
    static_assert(FractionBits >= 0, "FractionBits is not negative.");

  public:
    using Raw = Integer<IntegerBits + FractionBits>;
    using Arithmetic = ArithmeticPolicy;
    static constexpr int integer_bits = IntegerBits;
    static constexpr int fraction_bits = FractionBits;

    constexpr Fixed() : raw_(0) {}

    // The number raw / 2^F.
    static constexpr Fixed from_raw(Raw raw) { return Fixed(raw); }
    constexpr Raw raw() const { return raw_; }

    // The integer n: n 2^F as the arithmetic shifts (Nearest: modulo 2^W; Saturating: clamped).
    static constexpr Fixed from_integer(Raw n) {
        return Fixed(Arithmetic::template shift_left<Raw, FractionBits>(n, FractionBits));
    }

    // The largest and the smallest number, and the distance between neighbours (one ulp).
    static constexpr Fixed max() { return Fixed(RawLimits<Raw>::max); }
    static constexpr Fixed min() { return Fixed(RawLimits<Raw>::min); }
    static constexpr Fixed ulp() { return Fixed(1); }

    friend constexpr Fixed operator+(Fixed a, Fixed b) {
        return Fixed(Arithmetic::template add<Raw, FractionBits>(a.raw_, b.raw_));
    }
    friend constexpr Fixed operator-(Fixed a, Fixed b) {
        return Fixed(Arithmetic::template subtract<Raw, FractionBits>(a.raw_, b.raw_));
    }
    friend constexpr Fixed operator*(Fixed a, Fixed b) {
        return Fixed(Arithmetic::template multiply<Raw, FractionBits>(a.raw_, b.raw_));
    }
    friend constexpr Fixed operator/(Fixed a, Fixed b) {
        return Fixed(Arithmetic::template divide<Raw, FractionBits>(a.raw_, b.raw_));
    }
    friend constexpr Fixed operator%(Fixed a, Fixed b) {
        return Fixed(Arithmetic::template remainder<Raw, FractionBits>(a.raw_, b.raw_));
    }
    constexpr Fixed operator-() const {
        return Fixed(Arithmetic::template negate<Raw, FractionBits>(raw_));
    }
    constexpr Fixed operator+() const { return *this; }

    // a 2^count as the arithmetic shifts.
    friend constexpr Fixed operator<<(Fixed a, unsigned char count) {
        return Fixed(Arithmetic::template shift_left<Raw, FractionBits>(a.raw_, count));
    }
    // floor(a / 2^count) in units of one ulp, for every count.
    friend FIXEDPOINT_CONSTEXPR Fixed operator>>(Fixed a, unsigned char count) {
        constexpr unsigned char last = RawLimits<Raw>::width - 1;
        return Fixed(static_cast<Raw>(a.raw_ >> (count < last ? count : last)));
    }

    FIXEDPOINT_CONSTEXPR Fixed& operator+=(Fixed b) { return *this = *this + b; }
    FIXEDPOINT_CONSTEXPR Fixed& operator-=(Fixed b) { return *this = *this - b; }
    FIXEDPOINT_CONSTEXPR Fixed& operator*=(Fixed b) { return *this = *this * b; }
    FIXEDPOINT_CONSTEXPR Fixed& operator/=(Fixed b) { return *this = *this / b; }
    FIXEDPOINT_CONSTEXPR Fixed& operator%=(Fixed b) { return *this = *this % b; }
    FIXEDPOINT_CONSTEXPR Fixed& operator<<=(unsigned char count) { return *this = *this << count; }
    FIXEDPOINT_CONSTEXPR Fixed& operator>>=(unsigned char count) { return *this = *this >> count; }

    friend constexpr bool operator==(Fixed a, Fixed b) { return a.raw_ == b.raw_; }
    friend constexpr bool operator!=(Fixed a, Fixed b) { return a.raw_ != b.raw_; }
    friend constexpr bool operator<(Fixed a, Fixed b) { return a.raw_ < b.raw_; }
    friend constexpr bool operator>(Fixed a, Fixed b) { return a.raw_ > b.raw_; }
    friend constexpr bool operator<=(Fixed a, Fixed b) { return a.raw_ <= b.raw_; }
    friend constexpr bool operator>=(Fixed a, Fixed b) { return a.raw_ >= b.raw_; }

  private:
    explicit constexpr Fixed(Raw raw) : raw_(raw) {}

    Raw raw_;
};

// The formats of every width with equal halves, in the default arithmetic.
using Q4_4 = Fixed<4, 4>;
using Q8_8 = Fixed<8, 8>;
using Q16_16 = Fixed<16, 16>;
using Q32_32 = Fixed<32, 32>;

}  // namespace fixedpoint
