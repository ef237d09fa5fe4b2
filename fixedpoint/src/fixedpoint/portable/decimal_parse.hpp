// SPDX-License-Identifier: MIT
// Decimal text to raw numbers, exact to the last bit for arbitrarily many digits. Accepted: sign?
// (digits point? digits? | point digits) ((e|E) sign? digits)?, with nothing before or after it.
#pragma once

#include <limits.h>
#include <stddef.h>

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/decimal_fraction.hpp>

namespace fixedpoint {
namespace portable {

/// What parse found in a text.
enum class TextStatus : unsigned char {
    ok,            ///< a number in the range
    empty,         ///< no text at all
    malformed,     ///< not a decimal number: it ends, or has an unexpected character, at `position`
    out_of_range,  ///< a decimal number that the format cannot hold, saturated
};

/// What parse returns.
template <class Number>
struct Parsed {
    /// The number; the nearer limit if it is out of range, 0 if the text is not a number.
    Number number;
    /// Whether that is the text's number, and if not, why.
    TextStatus status;
    size_t position;  ///< where reading stopped: the length of a well-formed text
};

/// \cond internal
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

// A decimal number as it stands in the text.
struct DecimalText {
    const char* first;  // its digits, possibly with a point: [first, last)
    const char* last;
    long decimals;  // the number of digits after the point, less the exponent
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
            // Exponents larger than the number of digits in any text need not be distinguished.
            if (exponent < LONG_MAX / 100) exponent = 10 * exponent + (*at - '0');
        }
        decimals -= exponent_is_negative ? -exponent : exponent;
    }
    const TextStatus status = length == 0              ? TextStatus::empty
                              : !complete || at != end ? TextStatus::malformed
                                                       : TextStatus::ok;
    return {first, last, decimals, negative, status, static_cast<size_t>(at - text)};
}

// The length of the number that the text begins with: an optional minus, digits, an exponent if it
// has digits. 0 if there is none.
FIXEDPOINT_CONSTEXPR size_t decimal_prefix(const char* text, size_t length) {
    if (length != 0 && *text == '+') return 0;
    const DecimalText source = scan_decimal(text, length);
    const size_t digits = static_cast<size_t>(source.last - text);
    // Either there is no exponent, or it is complete.
    if (source.position == digits || is_digit(text[source.position - 1])) {
        const bool has_digits = source.last != source.first &&
                                (source.last[-1] != '.' || source.last - source.first > 1);
        return has_digits ? source.position : 0;
    }
    return digits;
}

// 10 integer + digit, saturated to the largest Word, at which it then stays.
template <class Word>
FIXEDPOINT_CONSTEXPR Word append_digit(Word integer, uint8_t digit) {
    constexpr Word max = static_cast<Word>(-1);
    return integer > (max - 9) / 10 ? max : integer * 10 + digit;
}

// The number in the text, rounded to nearest, half up; the nearer limit if it is out of range, and
// 0 for empty or malformed text. Reads only text[0] to text[length - 1].
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Parsed<Raw> parse_decimal(const char* text, size_t length) {
    using Word = DecimalWord<Raw, F>;
    const DecimalText source = scan_decimal(text, length);
    if (source.status != TextStatus::ok) return {0, source.status, source.position};

    // After the point, from the last digit to the first, with zeros before the first.
    DecimalFraction<Word> fraction = {0, false};
    const char* last = source.last;
    long decimals = source.decimals;
    for (; decimals > 0 && (last != source.first || fraction.bits != 0); --decimals) {
        if (last != source.first && last[-1] == '.') --last;
        fraction.prepend(last == source.first ? 0 : static_cast<uint8_t>(*--last - '0'));
    }
    // Before the point, from the first digit to the last, with zeros after the last.
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
