// SPDX-License-Identifier: MIT
/// \file
/// Fixed-point numbers as decimal text, exact to the last bit. No heap is used; all of it runs on
/// the device too.
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

/// Reads text[0 .. length), which must be a decimal number as a whole: an optional sign, digits
/// with an optional point, an optional exponent. The number is rounded to nearest, half up. Out of
/// range, it is the nearer limit, with TextStatus::out_of_range. It is 0 for TextStatus::empty and
/// TextStatus::malformed; `position` is where reading stopped.
template <class Number>
FIXEDPOINT_CONSTEXPR Parsed<Number> parse(const char* text, size_t length) {
    const auto result =
        portable::parse_decimal<typename Number::Raw, Number::fraction_bits>(text, length);
    return {Number::from_raw(result.number), result.status, result.position};
}
/// The same for zero-terminated text: parse<Q16_16>("1.5").number.
template <class Number>
FIXEDPOINT_CONSTEXPR Parsed<Number> parse(const char* text) {
    size_t length = 0;
    while (text[length] != '\0') ++length;
    return parse<Number>(text, length);
}

/// Writes the shortest text that parse reads as x, and of several the closest to x, without a
/// terminating zero. Returns its length, or 0 if the buffer is too small; its content is then
/// unspecified.
template <int IntegerBits, int F, class A>
constexpr size_t print(Fixed<IntegerBits, F, A> x, char* buffer, size_t capacity) {
    return portable::print_decimal<RawOf<IntegerBits + F, A>, F>(x.raw(), buffer, capacity);
}

/// Writes x with that many decimals, rounded to nearest, half up; from F decimals on the text is
/// exact. Returns its length, or 0 if the buffer is too small; its content is then unspecified.
template <int IntegerBits, int F, class A>
constexpr size_t print(Fixed<IntegerBits, F, A> x, uint8_t decimals, char* buffer,
                       size_t capacity) {
    return portable::print_decimal<RawOf<IntegerBits + F, A>, F>(x.raw(), decimals, buffer,
                                                                 capacity);
}

/// What to_chars and from_chars report, as the standard's functions do by std::errc; TextError() is
/// none.
enum class TextError : unsigned char {
    none,                 ///< success
    invalid_argument,     ///< the text does not begin with a number
    result_out_of_range,  ///< it begins with a number that is out of range
    value_too_large,      ///< the buffer is too small
};
/// What to_chars returns.
struct ToCharsResult {
    char* ptr;     ///< the end of the text, or of the buffer if that is too small
    TextError ec;  ///< none or value_too_large
};
/// What from_chars returns.
struct FromCharsResult {
    const char* ptr;  ///< the end of the number, or the start of a text without one
    TextError ec;     ///< none, invalid_argument or result_out_of_range
};

/// Writes the shortest text that from_chars reads as x to [first, last), as std::to_chars does. If
/// the buffer is too small, its content is unspecified.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR ToCharsResult to_chars(char* first, char* last, Fixed<IntegerBits, F, A> x) {
    const size_t length = print(x, first, static_cast<size_t>(last - first));
    return length == 0 ? ToCharsResult{last, TextError::value_too_large}
                       : ToCharsResult{first + length, TextError::none};
}
/// Writes x with that many decimals, rounded to nearest, half up, to [first, last).
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR ToCharsResult to_chars(char* first, char* last, Fixed<IntegerBits, F, A> x,
                                            uint8_t decimals) {
    const size_t length = print(x, decimals, first, static_cast<size_t>(last - first));
    return length == 0 ? ToCharsResult{last, TextError::value_too_large}
                       : ToCharsResult{first + length, TextError::none};
}
/// Reads the longest number at the start of [first, last), as std::from_chars does: leading blanks
/// and a plus are not accepted, what follows the number is ignored, and x keeps its value on an
/// error.
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

/// The character in front of a number that is not negative.
enum class Sign : unsigned char {
    minus_only,  ///< nothing
    always,      ///< a plus
    space,       ///< a blank
};
/// How a number is laid out: right-aligned in `width` characters and padded with `fill` on the
/// left; zeros go between sign and digits. A longer text is not truncated.
struct Layout {
    /// Instead of a number of decimals: the shortest text that parse reads as the number.
    static constexpr uint8_t shortest = 255;

    /// At least `width_` characters wide, with `decimals_` decimals.
    constexpr explicit Layout(uint8_t width_, uint8_t decimals_ = shortest,
                              Sign sign_ = Sign::minus_only, char fill_ = ' ')
        : width(width_), decimals(decimals_), sign(sign_), fill(fill_) {}

    /// The arguments of the constructor.
    /// @{
    uint8_t width, decimals;
    Sign sign;
    char fill;
    /// @}
};
/// Writes x as `layout` says, without a terminating zero. Returns the length, or 0 if the buffer is
/// too small; its content is then unspecified. The larger of layout.width and
/// text_capacity<Number>(decimals) + 1 is enough.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR size_t print(Fixed<IntegerBits, F, A> x, Layout layout, char* buffer,
                                  size_t capacity) {
    // Leaves room for a plus or a blank in front.
    const uint8_t sign = x.raw() >= 0 && layout.sign != Sign::minus_only ? 1 : 0;
    if (capacity < sign) return 0;
    const size_t length = layout.decimals == Layout::shortest
                              ? print(x, buffer + sign, capacity - sign)
                              : print(x, layout.decimals, buffer + sign, capacity - sign);
    if (length == 0) return 0;
    if (sign != 0) buffer[0] = layout.sign == Sign::always ? '+' : ' ';
    return portable::align_right(buffer, length + sign, capacity, layout.width, layout.fill);
}

/// Writes the raw of x as 0x and the W / 4 hexadecimal digits of its two's complement, without a
/// terminating zero: exact, and what a debugger shows. Returns the length, or 0 if the buffer is
/// too small.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR size_t print_raw(Fixed<IntegerBits, F, A> x, char* buffer, size_t capacity) {
    return portable::print_hexadecimal(static_cast<UnsignedInteger<IntegerBits + F>>(x.raw()),
                                       buffer, capacity);
}
/// Reads text[0 .. length), a raw as print_raw writes it; letters may have either case, and leading
/// zeros may be missing. The number is 0 unless the status is TextStatus::ok; more than W bits are
/// out_of_range.
template <class Number>
FIXEDPOINT_CONSTEXPR Parsed<Number> parse_raw(const char* text, size_t length) {
    const auto result = portable::parse_hexadecimal<Unsigned<typename Number::Raw>>(text, length);
    return {Number::from_raw(static_cast<typename Number::Raw>(result.number)), result.status,
            result.position};
}

/// The capacity that is enough for every number: for the shortest text, or with that many decimals.
template <class Number>
constexpr size_t text_capacity(uint8_t decimals = Number::fraction_bits) {
    return portable::decimal_capacity<typename Number::Raw, Number::fraction_bits>(decimals);
}

}  // namespace fixedpoint
