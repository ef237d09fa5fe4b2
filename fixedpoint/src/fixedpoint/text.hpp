// SPDX-License-Identifier: MIT
/// \file
/// Fixed-point numbers as decimal text, exact to the last bit, without heap and on the device too.
#pragma once

#include <fixedpoint/fixed.hpp>
#include <fixedpoint/portable/decimal_parse.hpp>
#include <fixedpoint/portable/decimal_print.hpp>

namespace fixedpoint {

/// \cond internal
using portable::Parsed;
using portable::TextStatus;
/// \endcond

/// The number that text[0 .. length) says, as a whole: a sign or none, digits with or without a
/// point, an exponent or none. Rounded to nearest, half up; the limit of the range with
/// TextStatus::out_of_range; 0 with TextStatus::empty or malformed, and then `position` is where.
template <class Number>
FIXEDPOINT_CONSTEXPR Parsed<Number> parse(const char* text, size_t length) {
    const auto result =
        portable::parse_decimal<typename Number::Raw, Number::fraction_bits>(text, length);
    return {Number::from_raw(result.number), result.status, result.position};
}
/// The same of text that ends with a zero: parse<Q16_16>("1.5").number.
template <class Number>
FIXEDPOINT_CONSTEXPR Parsed<Number> parse(const char* text) {
    size_t length = 0;
    while (text[length] != '\0') ++length;
    return parse<Number>(text, length);
}

/// The shortest text that parse reads as x and, of those, the closest to it, without a terminating
/// zero. Returns its length, or 0 where it does not fit into the buffer.
template <int IntegerBits, int F, class A>
constexpr size_t print(Fixed<IntegerBits, F, A> x, char* buffer, size_t capacity) {
    return portable::print_decimal<Integer<IntegerBits + F>, F>(x.raw(), buffer, capacity);
}

/// x with so many decimals, rounded to nearest, half up; exact from F decimals on. Returns as
/// above.
template <int IntegerBits, int F, class A>
constexpr size_t print(Fixed<IntegerBits, F, A> x, uint8_t decimals, char* buffer,
                       size_t capacity) {
    return portable::print_decimal<Integer<IntegerBits + F>, F>(x.raw(), decimals, buffer,
                                                                capacity);
}

/// The capacity that is always enough: for the shortest text, or for so many decimals.
template <class Number>
constexpr size_t text_capacity(uint8_t decimals = Number::fraction_bits) {
    return portable::decimal_capacity<typename Number::Raw, Number::fraction_bits>(decimals);
}

}  // namespace fixedpoint
