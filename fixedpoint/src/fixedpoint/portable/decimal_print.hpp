// SPDX-License-Identifier: MIT
// Raw numbers to decimal text: the shortest that reads back, or a given number of decimals. Neither
// writes a terminating zero. Both return the length, or 0 if the buffer is too small; its content
// is then unspecified.
#pragma once

#include <stddef.h>

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/decimal_fraction.hpp>

namespace fixedpoint {
namespace portable {

// An upper bound on the length of any text: a sign, the integer digits, a point and the decimals,
// of which the shortest and the exact text have up to F.
template <class Raw, int F>
constexpr size_t decimal_capacity(uint8_t decimals = F) {
    // floor(n log10(2)) = floor(3 n / 10) for n < 64.
    return 1 + ((RawLimits<Raw>::width - 1 - F) * 3 / 10 + 1) + 1 + decimals;
}

// Counts every character and keeps those that fit.
struct DecimalWriter {
    char* const buffer;
    const size_t capacity;
    size_t length;

    FIXEDPOINT_CONSTEXPR void put(char character) {
        if (length < capacity) buffer[length] = character;
        ++length;
    }
    FIXEDPOINT_CONSTEXPR void put_digit(int digit) { put(static_cast<char>('0' + digit)); }
    template <class Word>
    FIXEDPOINT_CONSTEXPR void put_integer(Word n) {
        Word unit = 1;
        while (n / unit >= 10) unit *= 10;
        for (; unit != 0; unit /= 10) put_digit(static_cast<int>(n / unit % 10));
    }
    constexpr size_t written() const { return length <= capacity ? length : 0; }
};

// Right-aligns a text of `length` characters in `width` by padding with `fill` on the left; zeros
// go after the sign. Returns the new length, or 0 if it does not fit.
FIXEDPOINT_CONSTEXPR size_t align_right(char* text, size_t length, size_t capacity, uint8_t width,
                                        char fill) {
    if (length >= width) return length;
    if (capacity < width) return 0;
    const bool has_sign = text[0] == '-' || text[0] == '+' || text[0] == ' ';
    const size_t first = fill == '0' && has_sign ? 1 : 0;
    const size_t padding = width - length;
    for (size_t i = length; i > first; --i) text[i - 1 + padding] = text[i - 1];
    for (size_t i = first; i < first + padding; ++i) text[i] = fill;
    return width;
}

// The shortest decimal that parse_decimal reads as the same number and, of those, the closest to
// it.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR size_t print_decimal(Raw raw, char* buffer, size_t capacity) {
    using Word = DecimalWord<Raw, F>;
    constexpr Word max = static_cast<Word>(-1);
    const bool negative = raw < 0;
    const Word number = magnitude(raw);
    DecimalWriter writer = {buffer, capacity, 0};
    if (negative) writer.put('-');
    writer.put_integer(number >> F);

    // (Steele and White, How to print floating-point numbers accurately, 1990: fixed-point
    // fractions.) A decimal reads back if it is less than half an ulp away. No decimal considered
    // is exactly half an ulp away, since such a number has F + 1 decimals. Rounding up never
    // carries: the digit before a 9 would already have been close enough.
    DecimalFraction<Word> fraction = fraction_of<Word, F>(number);
    Word half_ulp = Word(1) << (RawLimits<Word>::width - 1 - F);
    bool last = fraction.bits == 0;
    if (!last) writer.put('.');
    while (!last) {
        const uint8_t digit = fraction.take();
        const bool up = fraction.rounds_away(negative);
        const Word distance = up ? Word(0) - fraction.bits : fraction.bits;
        // Half an ulp, ten times as large from here on, may by now exceed a whole digit.
        last = half_ulp > max / 10;
        half_ulp *= 10;
        last = last || distance < half_ulp;
        writer.put_digit(digit + (last && up ? 1 : 0));
    }
    return writer.written();
}

// The number with that many decimals, rounded to nearest, half up; exact from F decimals on. A
// number that rounds to zero is written without a sign, and without decimals there is no point.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR size_t print_decimal(Raw raw, uint8_t decimals, char* buffer,
                                          size_t capacity) {
    using Word = DecimalWord<Raw, F>;
    const Word number = magnitude(raw);
    const Word integer = number >> F;

    // The decimal at which the carry of rounding up ends: the last one that is not a 9, or 0 for
    // the integer.
    DecimalFraction<Word> fraction = fraction_of<Word, F>(number);
    int carry_ends = 0;
    bool is_zero = integer == 0;
    for (int i = 1; i <= decimals; ++i) {
        const uint8_t digit = fraction.take();
        if (digit != 9) carry_ends = i;
        if (digit != 0) is_zero = false;
    }
    const bool up = fraction.rounds_away(raw < 0);

    DecimalWriter writer = {buffer, capacity, 0};
    if (raw < 0 && (up || !is_zero)) writer.put('-');
    writer.put_integer(integer + (up && carry_ends == 0 ? 1 : 0));
    if (decimals > 0) writer.put('.');
    fraction = fraction_of<Word, F>(number);
    for (int i = 1; i <= decimals; ++i) {
        const uint8_t digit = fraction.take();
        if (!up || i < carry_ends) {
            writer.put_digit(digit);
        } else {
            writer.put_digit(i == carry_ends ? digit + 1 : 0);
        }
    }
    return writer.written();
}

}  // namespace portable
}  // namespace fixedpoint
