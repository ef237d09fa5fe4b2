// SPDX-License-Identifier: MIT
/// \file
/// Decimal constants for every scalar: `0.38_d` is the number 0.38, rounded once, at compile time,
/// to the scalar that it becomes: Q16.16, Q8.24, float, double or a wide type. A constant that does
/// not fit a fixed-point format does not compile.
#pragma once

#include <engine/scalar.hpp>
#include <fixedpoint/literals.hpp>

namespace engine {

/// \cond internal
template <int64_t digits, unsigned char places>
struct Decimal;

constexpr int64_t power_of_ten(unsigned char exponent) {
    return exponent == 0 ? 1 : 10 * power_of_ten(static_cast<unsigned char>(exponent - 1));
}

// digits / 10^places in a scalar.
template <class Scalar, int64_t digits, unsigned char places>
struct DecimalIn {
    static constexpr Scalar value() { return Scalar(digits) / Scalar(power_of_ten(places)); }
};

// |digits| / 10^places bit by bit: the quotient and the remainder of the numerator, doubled as
// often as needed, and the divisor. Each function is one return statement, so that C++11, too,
// evaluates constants at compile time.
template <int64_t digits, unsigned char places>
struct BinaryDigits {
    struct Division {
        uint64_t quotient, remainder;
    };
    static constexpr uint64_t divisor = static_cast<uint64_t>(power_of_ten(places));
    static constexpr uint64_t magnitude = static_cast<uint64_t>(digits < 0 ? -digits : digits);

    static constexpr Division first() { return {magnitude / divisor, magnitude % divisor}; }
    static constexpr Division doubled(Division d) {
        return {2 * d.quotient + (2 * d.remainder >= divisor), 2 * d.remainder % divisor};
    }
    static constexpr Division doubled(Division d, int times) {
        return times == 0 ? d : doubled(doubled(d), times - 1);
    }

    // Rounds once even where there are more digits than the type holds: the quotient has at least
    // two bits more than the type, its last bit is set where a remainder is left, and the scaling
    // by a power of two is exact.
    template <class Binary>
    static constexpr Binary rounded(Division d, int bits, Binary unit) {
        return d.remainder == 0 || d.quotient >> (bits + 2) != 0
                   ? static_cast<Binary>(d.quotient | (d.remainder != 0)) * unit
                   : rounded(doubled(d), bits, unit / 2);
    }
    template <class Binary>
    static constexpr Binary rounded(int bits) {
        return rounded<Binary>(first(), bits, digits < 0 ? -1 : 1);
    }

    // |raw| of the number with F fraction bits, rounded half up; all ones where it exceeds `limit`.
    static constexpr uint64_t rounded(Division d) {
        return d.quotient + (2 * d.remainder + (digits < 0 ? 0 : 1) > divisor);
    }
    static constexpr uint64_t magnitude_with(int F, uint64_t limit) {
        return magnitude / divisor > limit >> F || rounded(doubled(first(), F)) > limit
                   ? static_cast<uint64_t>(-1)
                   : rounded(doubled(first(), F));
    }
};

// Constants are members, so that they are evaluated at compile time wherever they are used.
template <class Binary, int bits, int64_t digits, unsigned char places>
struct DecimalInBinary {
    static constexpr Binary constant = BinaryDigits<digits, places>::template rounded<Binary>(bits);
    static constexpr Binary value() { return constant; }
};
template <int64_t digits, unsigned char places>
struct DecimalIn<float, digits, places> : DecimalInBinary<float, 24, digits, places> {};
template <int64_t digits, unsigned char places>
struct DecimalIn<double, digits, places> : DecimalInBinary<double, 53, digits, places> {};
template <int I, int F, class A, int64_t digits, unsigned char places>
struct DecimalIn<Fixed<I, F, A>, digits, places> {
    using Number = Fixed<I, F, A>;
    using Raw = typename Number::Raw;
    static constexpr uint64_t limit =
        static_cast<uint64_t>(fixedpoint::RawLimits<Raw>::max) + (digits < 0);
    static constexpr uint64_t magnitude = BinaryDigits<digits, places>::magnitude_with(F, limit);
    static_assert(magnitude <= limit,
                  "This decimal constant lies outside the range of the format.");
    static constexpr Raw raw = fixedpoint::with_sign<Raw>(
        static_cast<fixedpoint::UnsignedInteger<I + F>>(magnitude), digits < 0);
    static constexpr Number value() { return Number::from_raw(raw); }
};
/// \endcond

/// The constant digits / 10^places, which converts to the scalar that it is assigned to.
template <int64_t digits, unsigned char places>
struct Decimal {
    /// The constant as a scalar, rounded once. Does not compile if it is outside the range of a
    /// fixed-point format, or if the target is an integer.
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

namespace literals {

/// \cond internal
// The characters of a literal: digits, at most one point, separators.
template <char... Text>
struct DecimalText {
    using Literal = fixedpoint::literals::LiteralText<Text...>;
    static constexpr const char* begin() { return Literal::text; }
    static constexpr const char* end() { return Literal::text + sizeof...(Text); }
    static_assert(sizeof...(Text) < 19 && Literal::is_decimal &&
                      fixedpoint::portable::mantissa_end(begin(), end()) == end(),
                  "A decimal constant is digits with at most one point: 12, 0.38.");
    static constexpr int64_t digits =
        static_cast<int64_t>(fixedpoint::portable::literal_digits<uint64_t>(begin(), end(), 0));
    static constexpr unsigned char places =
        static_cast<unsigned char>(fixedpoint::portable::count_decimals(begin(), end(), false));
};
/// \endcond

/// The constant of at most 18 digits with at most one point: 12_d, 0.38_d.
template <char... Text>
constexpr Decimal<DecimalText<Text...>::digits, DecimalText<Text...>::places> operator""_d() {
    return {};
}

}  // namespace literals
}  // namespace engine
