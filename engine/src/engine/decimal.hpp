// SPDX-License-Identifier: MIT
/// \file
/// Decimal constants for every scalar: `0.38_d` is the number 0.38, rounded once, at compile time,
/// to whatever scalar it becomes: Q16.16, Q8.24, float, double or a wide type. What does not fit a
/// fixed-point format does not compile.
#pragma once

#include <engine/scalar.hpp>

namespace engine {

/// \cond internal
template <int64_t digits, unsigned char places>
struct Decimal;

constexpr int64_t power_of_ten(unsigned char exponent) {
    return exponent == 0 ? 1 : 10 * power_of_ten(exponent - 1);
}

// digits / 10^places in a scalar.
template <class Scalar, int64_t digits, unsigned char places>
struct DecimalIn {
    static constexpr Scalar value() { return Scalar(digits) / Scalar(power_of_ten(places)); }
};
// Rounds once even where there are more digits than the type holds: the quotient has at least two
// bits more than the type, its last bit is set where a remainder is left, and the scaling by a
// power of two is exact.
template <class Binary, int bits, int64_t digits, unsigned char places>
struct DecimalInBinary {
    static constexpr Binary value() {
        constexpr Binary number = rounded();
        return number;
    }
    static constexpr Binary rounded() {
        const int64_t divisor = power_of_ten(places);
        const int64_t magnitude = digits < 0 ? -digits : digits;
        int64_t quotient = magnitude / divisor;
        int64_t remainder = magnitude % divisor;
        Binary unit = 1;
        while (remainder != 0 && quotient >> (bits + 2) == 0) {
            remainder *= 2;
            quotient = 2 * quotient + (remainder >= divisor);
            remainder %= divisor;
            unit /= 2;
        }
        const Binary size = static_cast<Binary>(quotient | (remainder != 0)) * unit;
        return digits < 0 ? -size : size;
    }
};
template <int64_t digits, unsigned char places>
struct DecimalIn<float, digits, places> : DecimalInBinary<float, 24, digits, places> {};
template <int64_t digits, unsigned char places>
struct DecimalIn<double, digits, places> : DecimalInBinary<double, 53, digits, places> {};
template <int I, int F, class A, int64_t digits, unsigned char places>
struct DecimalIn<Fixed<I, F, A>, digits, places> {
    using Number = Fixed<I, F, A>;
    static constexpr Number value() {
        constexpr auto rounded = fixedpoint::from_decimal_checked<Number>(digits, places);
        static_assert(rounded.fits, "This decimal constant lies outside the range of the format.");
        constexpr typename Number::Raw raw = rounded.number.raw();
        return Number::from_raw(raw);
    }
};
/// \endcond

/// The constant digits / 10^places, which becomes whatever scalar it is assigned to.
template <int64_t digits, unsigned char places>
struct Decimal {
    /// The constant in a scalar, rounded once. One out of the range of a fixed-point format does
    /// not compile, nor does an integer.
    template <class Scalar>
    constexpr operator Scalar() const {
        static_assert(!fixedpoint::BuiltinNumber<Scalar>::is_integer,
                      "A decimal constant is a fixed-point or floating-point number: an integer "
                      "would lose its fraction.");
        return DecimalIn<Scalar, digits, places>::value();
    }
    /// The negative constant.
    constexpr Decimal<-digits, places> operator-() const { return {}; }
};

/// \cond internal
// The characters of a literal: digits, at most one point, separators.
template <char... Text>
struct DecimalText {
    static constexpr int64_t digits() {
        const char text[] = {Text...};
        int64_t value = 0;
        for (char c : text) {
            if (c >= '0' && c <= '9') value = 10 * value + (c - '0');
        }
        return value;
    }
    static constexpr unsigned char places() {
        const char text[] = {Text...};
        unsigned char count = 0;
        bool fraction = false;
        for (char c : text) {
            if (fraction && c != '\'') ++count;
            if (c == '.') fraction = true;
        }
        return count;
    }
    static constexpr bool plain() {
        const char text[] = {Text...};
        for (char c : text) {
            if ((c < '0' || c > '9') && c != '.' && c != '\'') return false;
        }
        return true;
    }
};
/// \endcond

namespace literals {

/// The constant of up to 18 digits with at most one point: 12_d, 0.38_d.
template <char... Text>
constexpr Decimal<DecimalText<Text...>::digits(), DecimalText<Text...>::places()> operator""_d() {
    static_assert(DecimalText<Text...>::plain() && sizeof...(Text) < 19,
                  "A decimal constant is digits with at most one point: 12, 0.38.");
    return {};
}

}  // namespace literals
}  // namespace engine
