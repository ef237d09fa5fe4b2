// SPDX-License-Identifier: MIT
// The characters of a literal as a raw number, which is a constant in C++11 too: each function is a
// single return statement. At run time, and for signs, portable/decimal_parse.hpp does the same in
// loops.
//
// A literal does not have a sign. Rounding half up then depends only on the bit after the last one;
// all lower digits are dropped.
#pragma once

#include <limits.h>

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/converted.hpp>
#include <fixedpoint/portable/decimal_fraction.hpp>

namespace fixedpoint {
namespace portable {

constexpr bool is_literal_digit(char c) { return c >= '0' && c <= '9'; }
constexpr uint8_t literal_digit(char c) { return static_cast<uint8_t>(c - '0'); }
// The characters of a mantissa; digit separators are ignored.
constexpr bool is_mantissa(char c) { return is_literal_digit(c) || c == '.' || c == '\''; }

constexpr const char* mantissa_end(const char* at, const char* end) {
    return at != end && is_mantissa(*at) ? mantissa_end(at + 1, end) : at;
}
constexpr int count(char c, const char* at, const char* end) {
    return at == end ? 0 : (*at == c ? 1 : 0) + count(c, at + 1, end);
}
constexpr bool all_digits(const char* at, const char* end) {
    return at == end || ((is_literal_digit(*at) || *at == '\'') && all_digits(at + 1, end));
}
constexpr bool has_sign(const char* at, const char* end) {
    return at != end && (*at == '-' || *at == '+');
}
// Whether [at, end), what follows the mantissa, is empty or an exponent.
constexpr bool is_exponent(const char* at, const char* end) {
    return at == end || ((*at == 'e' || *at == 'E') && at + 1 + has_sign(at + 1, end) != end &&
                         all_digits(at + 1 + has_sign(at + 1, end), end));
}
// The compiler guarantees that a literal begins with a digit, or with a point and a digit.
constexpr bool is_decimal_literal(const char* at, const char* end) {
    return count('.', at, mantissa_end(at, end)) <= 1 && is_exponent(mantissa_end(at, end), end);
}

// Exponents larger than the number of digits in any literal need not be distinguished.
constexpr long exponent_digits(const char* at, const char* end, long exponent) {
    return at == end ? exponent
                     : exponent_digits(at + 1, end,
                                       *at == '\'' || exponent >= LONG_MAX / 100
                                           ? exponent
                                           : 10 * exponent + literal_digit(*at));
}
constexpr long literal_exponent(const char* at, const char* end) {
    return at == end                ? 0
           : !has_sign(at + 1, end) ? exponent_digits(at + 1, end, 0)
           : at[1] == '-'           ? -exponent_digits(at + 2, end, 0)
                                    : exponent_digits(at + 2, end, 0);
}
// The number of digits after the point.
constexpr long count_decimals(const char* at, const char* last, bool behind) {
    return at == last ? 0
                      : (behind && is_literal_digit(*at) ? 1 : 0) +
                            count_decimals(at + 1, last, behind || *at == '.');
}
// The position in [first, last) that `decimals` digits follow, or first if there are fewer.
constexpr const char* point_of(const char* first, const char* last, long decimals) {
    return decimals <= 0 || first == last
               ? last
               : point_of(first, last - 1, decimals - (is_literal_digit(last[-1]) ? 1 : 0));
}

// (digit + bits / 2^P) / 10, rounded down: see DecimalFraction::prepend.
template <class Word>
constexpr Word prepended(uint8_t digit, Word bits) {
    return static_cast<Word>(digit * (static_cast<Word>(-1) / 10) + bits / 10 +
                             (6u * digit + static_cast<unsigned>(bits % 10)) / 10);
}
// The fraction of `decimals` digits, which are the last ones of [first, last) with zeros before
// them.
template <class Word>
constexpr Word literal_fraction(const char* first, const char* last, long decimals, Word bits) {
    return decimals <= 0 || (first == last && bits == 0) ? bits
           : first == last ? literal_fraction(first, last, decimals - 1, prepended<Word>(0, bits))
           : is_literal_digit(last[-1])
               ? literal_fraction(first, last - 1, decimals - 1,
                                  prepended<Word>(literal_digit(last[-1]), bits))
               : literal_fraction(first, last - 1, decimals, bits);
}
// 10 integer + digit, saturated to the largest Word, at which it then stays.
template <class Word>
constexpr Word appended(Word integer, uint8_t digit) {
    return integer > (static_cast<Word>(-1) - 9) / 10 ? static_cast<Word>(-1)
                                                      : static_cast<Word>(integer * 10 + digit);
}
template <class Word>
constexpr Word literal_digits(const char* at, const char* last, Word integer) {
    return at == last ? integer
                      : literal_digits(at + 1, last,
                                       is_literal_digit(*at) ? appended(integer, literal_digit(*at))
                                                             : integer);
}
template <class Word>
constexpr Word with_zeros(Word integer, long zeros) {
    return zeros <= 0 || integer == 0 || integer == static_cast<Word>(-1)
               ? integer
               : with_zeros(appended(integer, 0), zeros - 1);
}

// (integer + fraction / 2^P) 2^F rounded to nearest, half up, and whether that is in range.
template <class Raw, class Word>
constexpr Converted<Raw> rounded_up(Word magnitude, Word up) {
    return {static_cast<Raw>(magnitude + up),
            magnitude <= static_cast<Word>(static_cast<Word>(RawLimits<Raw>::max) - up)};
}
template <class Raw, int F, class Word>
constexpr Converted<Raw> rounded_literal(Word integer, Word fraction) {
    return integer > static_cast<Word>(RawLimits<Raw>::max) >> F
               ? Converted<Raw>{0, false}
               : rounded_up<Raw, Word>(
                     (integer << F) + (fraction >> (RawLimits<Word>::width - 1 - F) >> 1),
                     fraction >> (RawLimits<Word>::width - 1 - F) & 1);
}
template <class Raw, int F>
constexpr Converted<Raw> parse_mantissa(const char* first, const char* last, long decimals) {
    return rounded_literal<Raw, F, DecimalWord<Raw, F>>(
        with_zeros(literal_digits<DecimalWord<Raw, F>>(first, point_of(first, last, decimals), 0),
                   -decimals),
        literal_fraction<DecimalWord<Raw, F>>(first, last, decimals, 0));
}
// The number that a decimal literal denotes, and whether it is in range.
template <class Raw, int F>
constexpr Converted<Raw> parse_literal(const char* first, const char* end) {
    return parse_mantissa<Raw, F>(first, mantissa_end(first, end),
                                  count_decimals(first, mantissa_end(first, end), false) -
                                      literal_exponent(mantissa_end(first, end), end));
}

}  // namespace portable
}  // namespace fixedpoint
