// SPDX-License-Identifier: MIT
// Decimal text to raw numbers, exact to the last bit for arbitrarily many digits.
// Accepted: sign? (digits point? digits? | point digits) ((e|E) sign? digits)?, and nothing around
// it.
#pragma once

#include <limits.h>
#include <stddef.h>

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/decimal_fraction.hpp>

namespace fixedpoint {
namespace portable {

/// What a text is, of which a number is read.
enum class TextStatus : unsigned char {
    ok,            ///< a number in the range
    empty,         // no text at all
    malformed,     // not a decimal number: it ends, or has an unexpected character, at `position`
    out_of_range,  ///< a decimal number that the format cannot hold, saturated
};

/// What parse returns.
template <class Number>
struct Parsed {
    /// The number; the limit of the range where the text is beyond it, 0 where it is none.
    Number number;
    /// Whether it is what the text says.
    TextStatus status;
    size_t position;  ///< where reading stopped: the length of a well-formed text
};

/// \cond internal
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

// A decimal number as it stands in the text.
struct DecimalText {
    const char* first;  // its digits, and perhaps a point between them: [first, last)
    const char* last;
    long decimals;  // the digits behind the point, less the exponent
    bool negative;
    TextStatus status;
    size_t position;
};

FIXEDPOINT_CONSTEXPR DecimalText scan_decimal(const char* text, size_t length) {
    const char* const end = text + length;
    const char* at = text;
    const bool negative = at != end && *at == '-';
    if (at != end && (*at == '-' || *at == '+')) ++at;

    const char* const first = at;
    bool has_digits = false;
    bool has_point = false;
    long decimals = 0;
    for (; at != end; ++at) {
        if (is_digit(*at)) {
            has_digits = true;
            if (has_point) ++decimals;
        } else if (*at == '.' && !has_point) {
            has_point = true;
        } else {
            break;
        }
    }
    const char* const last = at;

    bool complete = has_digits;
    if (has_digits && at != end && (*at == 'e' || *at == 'E')) {
        ++at;
        const bool exponent_is_negative = at != end && *at == '-';
        if (at != end && (*at == '-' || *at == '+')) ++at;
        complete = at != end && is_digit(*at);
        long exponent = 0;
        for (; at != end && is_digit(*at); ++at) {
            // Larger exponents than any text has digits need not be told apart.
            if (exponent < LONG_MAX / 100) exponent = 10 * exponent + (*at - '0');
        }
        decimals -= exponent_is_negative ? -exponent : exponent;
    }
    const TextStatus status = length == 0              ? TextStatus::empty
                              : !complete || at != end ? TextStatus::malformed
                                                       : TextStatus::ok;
    return {first, last, decimals, negative, status, static_cast<size_t>(at - text)};
}

// The characters that text begins with and that are a number: a minus or none, digits, an exponent
// that has digits. 0 where there is none.
FIXEDPOINT_CONSTEXPR size_t decimal_prefix(const char* text, size_t length) {
    if (length != 0 && *text == '+') return 0;
    const DecimalText source = scan_decimal(text, length);
    const size_t digits = static_cast<size_t>(source.last - text);
    // No digit of a mantissa, or all of an exponent.
    if (source.position == digits || is_digit(text[source.position - 1])) {
        const bool has_digits = source.last != source.first &&
                                (source.last[-1] != '.' || source.last - source.first > 1);
        return has_digits ? source.position : 0;
    }
    return digits;
}

// 10 integer + digit, or the largest Word where that is larger; once reached, it stays.
template <class Word>
FIXEDPOINT_CONSTEXPR Word append_digit(Word integer, uint8_t digit) {
    constexpr Word max = static_cast<Word>(-1);
    return integer > (max - 9) / 10 ? max : integer * 10 + digit;
}

// The number that the text says, rounded to nearest, half up. Out of range it is the
// limit of the range; for empty or malformed text it is 0. Reads text[0] to text[length - 1] only.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Parsed<Raw> parse_decimal(const char* text, size_t length) {
    using Word = DecimalWord<Raw>;
    const DecimalText source = scan_decimal(text, length);
    if (source.status != TextStatus::ok) return {0, source.status, source.position};

    // Behind the point, from the last digit to the first; in front of the first there are zeros.
    DecimalFraction<Word> fraction = {0, false};
    const char* last = source.last;
    long decimals = source.decimals;
    for (; decimals > 0 && (last != source.first || fraction.bits != 0); --decimals) {
        if (last != source.first && last[-1] == '.') --last;
        fraction.prepend(last == source.first ? 0 : static_cast<uint8_t>(*--last - '0'));
    }
    // In front of the point, from the first digit to the last; behind the last there are zeros.
    Word integer = 0;
    for (const char* at = source.first; at != last; ++at) {
        if (*at != '.') integer = append_digit(integer, static_cast<uint8_t>(*at - '0'));
    }
    for (; decimals < 0 && integer != 0 && integer != static_cast<Word>(-1); ++decimals) {
        integer = append_digit(integer, 0);
    }
    const Converted<Raw> result = assemble<Raw, F>(integer, fraction, source.negative);
    return {result.number, result.fits ? TextStatus::ok : TextStatus::out_of_range,
            source.position};
}
/// \endcond

}  // namespace portable
}  // namespace fixedpoint
