// SPDX-License-Identifier: MIT
/// \file
/// Fixed-point numbers as decimal text, exact to the last bit, without heap and on the device too.
#pragma once

#include <fixedpoint/fixed.hpp>
#include <fixedpoint/portable/decimal_parse.hpp>
#include <fixedpoint/portable/decimal_print.hpp>
#include <fixedpoint/portable/hexadecimal.hpp>

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

/// What to_chars and from_chars say, as std::errc does of the standard's; none is TextError().
enum class TextError : unsigned char {
    none,                 ///< all went well
    invalid_argument,     ///< the text does not begin with a number
    result_out_of_range,  ///< it does, with one that the format cannot hold
    value_too_large,      ///< the buffer is too small
};
/// What to_chars returns.
struct ToCharsResult {
    char* ptr;     ///< behind the text, or the end of the buffer where that is too small
    TextError ec;  ///< none or value_too_large
};
/// What from_chars returns.
struct FromCharsResult {
    const char* ptr;  ///< behind the number, or the begin of a text that has none
    TextError ec;     ///< none, invalid_argument or result_out_of_range
};

/// Writes the shortest text that from_chars reads as x to [first, last), as std::to_chars does.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR ToCharsResult to_chars(char* first, char* last, Fixed<IntegerBits, F, A> x) {
    const size_t length = print(x, first, static_cast<size_t>(last - first));
    return length == 0 ? ToCharsResult{last, TextError::value_too_large}
                       : ToCharsResult{first + length, TextError::none};
}
/// Writes x with so many decimals, rounded to nearest, half up.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR ToCharsResult to_chars(char* first, char* last, Fixed<IntegerBits, F, A> x,
                                            uint8_t decimals) {
    const size_t length = print(x, decimals, first, static_cast<size_t>(last - first));
    return length == 0 ? ToCharsResult{last, TextError::value_too_large}
                       : ToCharsResult{first + length, TextError::none};
}
/// Reads the longest number that [first, last) begins with, as std::from_chars does: no blanks and
/// no plus before it, what follows is left alone, and x keeps its value where there is an error.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR FromCharsResult from_chars(const char* first, const char* last,
                                                Fixed<IntegerBits, F, A>& x) {
    const size_t length = portable::decimal_prefix(first, static_cast<size_t>(last - first));
    if (length == 0) return {first, TextError::invalid_argument};
    const auto parsed = parse<Fixed<IntegerBits, F, A>>(first, length);
    if (parsed.status != TextStatus::ok) return {first + length, TextError::result_out_of_range};
    x = parsed.number;
    return {first + length, TextError::none};
}

/// What stands in front of a number that is not negative.
enum class Sign : unsigned char {
    minus_only,  ///< nothing
    always,      ///< a plus
    space,       ///< a blank
};
/// How a number is laid out: aligned to the right in `width`, with `fill` before it, zeros behind
/// its sign. A longer text is not cut.
struct Layout {
    /// In place of the decimals: the shortest text that parse reads as the number.
    static constexpr uint8_t shortest = 255;

    /// So wide, with so many decimals.
    constexpr explicit Layout(uint8_t width_, uint8_t decimals_ = shortest,
                              Sign sign_ = Sign::minus_only, char fill_ = ' ')
        : width(width_), decimals(decimals_), sign(sign_), fill(fill_) {}

    /// What the constructor takes.
    /// @{
    uint8_t width, decimals;
    Sign sign;
    char fill;
    /// @}
};
/// x laid out, without a terminating zero. Returns its length, or 0 where it does not fit into the
/// buffer; layout.width or text_capacity + 1 is enough, whichever is more.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR size_t print(Fixed<IntegerBits, F, A> x, Layout layout, char* buffer,
                                  size_t capacity) {
    // Behind the place of a sign that the number itself does not have.
    const uint8_t sign = x.raw() >= 0 && layout.sign != Sign::minus_only ? 1 : 0;
    if (capacity < sign) return 0;
    const size_t length = layout.decimals == Layout::shortest
                              ? print(x, buffer + sign, capacity - sign)
                              : print(x, layout.decimals, buffer + sign, capacity - sign);
    if (length == 0) return 0;
    if (sign != 0) buffer[0] = layout.sign == Sign::always ? '+' : ' ';
    return portable::align_right(buffer, length + sign, capacity, layout.width, layout.fill);
}

/// The raw of x as hexadecimal digits of its two's complement, W / 4 of them behind 0x, without a
/// terminating zero: what a debugger shows, and exact at a glance. Returns its length, or 0 where
/// it does not fit into the buffer.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR size_t print_raw(Fixed<IntegerBits, F, A> x, char* buffer, size_t capacity) {
    return portable::print_hexadecimal(static_cast<UnsignedInteger<IntegerBits + F>>(x.raw()),
                                       buffer, capacity);
}
/// The number whose raw text[0 .. length) says as print_raw writes it; letters of either case, and
/// leading zeros may be missing.
template <class Number>
FIXEDPOINT_CONSTEXPR Parsed<Number> parse_raw(const char* text, size_t length) {
    const auto result = portable::parse_hexadecimal<Unsigned<typename Number::Raw>>(text, length);
    return {Number::from_raw(static_cast<typename Number::Raw>(result.number)), result.status,
            result.position};
}

/// The capacity that is always enough: for the shortest text, or for so many decimals.
template <class Number>
constexpr size_t text_capacity(uint8_t decimals = Number::fraction_bits) {
    return portable::decimal_capacity<typename Number::Raw, Number::fraction_bits>(decimals);
}

}  // namespace fixedpoint
