// SPDX-License-Identifier: GPL-3.0-or-later
// What a bit pattern means: the number formats by name, and their range. A raw is always the low W
// bits of the pattern, sign-extended to int64_t, even for an IEEE float, and extended by zeros for
// a format without a sign.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace reference {

enum class FormatKind {
    fixed,    // q<integer bits>_<fraction bits>, sign included: value = raw / 2^F; u... without one
    integer,  // int8, int16, int32, int64: F = 0, C's arithmetic
    accum,    // s<integer bits>_<fraction bits>, GCC's _Accum types: the sign has its own bit
    ieee      // IEEE 754: float is binary32, float64 is binary64
};

struct NumberFormat {
    FormatKind kind = FormatKind::fixed;
    int width = 32;     // W: 8, 16, 24, 32 or 64
    int fraction = 16;  // F: bits after the binary point; 0 for integers and floats
    // Of fixed-point formats of at most 32 bits: raws from 0 to 2^W - 1.
    bool is_unsigned = false;

    bool operator==(const NumberFormat&) const = default;

    constexpr bool is_float() const { return kind == FormatKind::ieee; }

    // Of a float, counted as in <cfloat>: the bits of its significand, whose first is not stored;
    // the exponent of infinity; the exponent of the smallest normal number.
    constexpr int significand_bits() const { return width == 32 ? 24 : 53; }
    constexpr int infinity_exponent() const { return width == 32 ? 128 : 1024; }
    constexpr int min_exponent() const { return 2 - infinity_exponent(); }
    // The exponent of the last place of the subnormal numbers.
    constexpr int min_place() const { return min_exponent() - significand_bits() + 1; }
    constexpr std::int64_t infinity() const {
        return std::int64_t(2 * infinity_exponent() - 1) << (significand_bits() - 1);
    }

    // The sign bit, extended like a raw.
    constexpr std::int64_t sign() const { return std::int64_t(std::uint64_t(-1) << (width - 1)); }

    // The smallest and largest raw; of a float, the patterns of the smallest and largest finite
    // number.
    constexpr std::int64_t min() const {
        return is_float() ? sign() | max() : is_unsigned ? 0 : sign();
    }
    constexpr std::int64_t max() const {
        return is_float() ? infinity() - 1 : is_unsigned ? ~(2 * sign()) : ~sign();
    }

    // The low W bits of a pattern as a raw.
    constexpr std::int64_t extend(std::uint64_t pattern) const {
        const std::uint64_t top = pattern << (64 - width);
        return is_unsigned ? std::int64_t(top >> (64 - width)) : std::int64_t(top) >> (64 - width);
    }
};

constexpr NumberFormat fixed_format(int integer_bits, int fraction_bits) {
    return {FormatKind::fixed, integer_bits + fraction_bits, fraction_bits};
}
constexpr NumberFormat unsigned_format(int integer_bits, int fraction_bits) {
    return {FormatKind::fixed, integer_bits + fraction_bits, fraction_bits, true};
}
inline constexpr NumberFormat q4_4 = fixed_format(4, 4);
inline constexpr NumberFormat q8_8 = fixed_format(8, 8);
inline constexpr NumberFormat q16_16 = fixed_format(16, 16);
inline constexpr NumberFormat q32_32 = fixed_format(32, 32);
inline constexpr NumberFormat ieee_single = {FormatKind::ieee, 32, 0};
inline constexpr NumberFormat ieee_double = {FormatKind::ieee, 64, 0};

// Reads "q16_16", "u16_16", "int32", "s16_15", "float" or "float64". Throws std::invalid_argument
// for any other name, with a message that lists what is allowed.
NumberFormat parse_format(std::string_view name);
std::string format_name(const NumberFormat& format);

bool is_nan(const NumberFormat& format, std::int64_t raw);
bool is_finite(const NumberFormat& format, std::int64_t raw);

// The double nearest to what a raw stands for.
double to_double(const NumberFormat& format, std::int64_t raw);
// The raw nearest to a double. `format` must be a float format.
std::int64_t raw_of_double(const NumberFormat& format, double number);

std::int64_t raw_of_float(float number);
float float_of_raw(std::int64_t raw);

}  // namespace reference
