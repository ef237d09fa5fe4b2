// SPDX-License-Identifier: MIT
/// \file
/// Literals such as 0.38_q16_16, exact to the last bit: the source characters are parsed, no double
/// is involved, and the result is a constant. Literals are always decimal: 017 is 17. The sign is
/// not part of a literal: -0.38_q16_16 negates 0.38_q16_16, and the smallest number is written
/// Q16_16::min().
///
/// A format of your own gets its literal in one line:
///   template <char... Text>
///   constexpr Fixed<8, 24> operator""_q8_24() { return literal<Fixed<8, 24>, Text...>(); }
#pragma once

#include <fixedpoint/fixed.hpp>
#include <fixedpoint/portable/decimal_literal.hpp>

namespace fixedpoint {
namespace literals {

/// \cond internal
template <char... Text>
struct LiteralText {
    static constexpr char text[] = {Text...};
    static constexpr bool is_decimal = portable::is_decimal_literal(text, text + sizeof...(Text));
    template <class Raw, int F>
    static constexpr portable::Converted<Raw> number() {
        return portable::parse_literal<Raw, F>(text, text + sizeof...(Text));
    }
};
template <char... Text>
constexpr char LiteralText<Text...>::text[];

// The raw of a literal: a static member, so that it is always a constant.
template <class Raw, int F, char... Text>
struct LiteralRaw {
    static constexpr portable::Converted<Raw> parsed =
        LiteralText<Text...>::template number<Raw, F>();
    static_assert(parsed.fits, "This literal lies outside the range of its fixed-point format.");
    static constexpr Raw value = parsed.number;
};
/// \endcond

/// The number that the characters denote, rounded to nearest, half up. Anything but a decimal
/// number in range does not compile.
template <class Number, char... Text>
constexpr Number literal() {
    static_assert(LiteralText<Text...>::is_decimal,
                  "A fixed-point literal is a decimal number: 12, 0.38, 1e-3.");
    return Number::from_raw(
        LiteralRaw<typename Number::Raw, Number::fraction_bits, Text...>::value);
}

/// The number rounded to nearest, half up. Anything but a decimal number in the range of Q4_4 does
/// not compile.
template <char... Text>
constexpr Q4_4 operator""_q4_4() {
    return literal<Q4_4, Text...>();
}
/// The number rounded to nearest, half up. Anything but a decimal number in the range of Q8_8 does
/// not compile.
template <char... Text>
constexpr Q8_8 operator""_q8_8() {
    return literal<Q8_8, Text...>();
}
/// The number rounded to nearest, half up. Anything but a decimal number in the range of Q8_16 does
/// not compile.
template <char... Text>
constexpr Q8_16 operator""_q8_16() {
    return literal<Q8_16, Text...>();
}
/// The number rounded to nearest, half up. Anything but a decimal number in the range of Q12_12
/// does not compile.
template <char... Text>
constexpr Q12_12 operator""_q12_12() {
    return literal<Q12_12, Text...>();
}
/// The number rounded to nearest, half up. Anything but a decimal number in the range of Q16_16
/// does not compile.
template <char... Text>
constexpr Q16_16 operator""_q16_16() {
    return literal<Q16_16, Text...>();
}
/// The number rounded to nearest, half up. Anything but a decimal number in the range of Q32_32
/// does not compile.
template <char... Text>
constexpr Q32_32 operator""_q32_32() {
    return literal<Q32_32, Text...>();
}

}  // namespace literals
}  // namespace fixedpoint
