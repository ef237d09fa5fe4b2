// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/number_format.hpp"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace reference {
namespace {

std::optional<int> parse_number(std::string_view digits) {
    int number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const bool canonical =
        !digits.empty() && digits[0] != '-' && (digits[0] != '0' || digits == "0");
    if (error != std::errc() || end != digits.data() + digits.size() || !canonical)
        return std::nullopt;
    return number;
}

bool is_width(int bits) {
    return bits == 8 || bits == 16 || bits == 24 || bits == 32 || bits == 64;
}

std::optional<NumberFormat> parse_split(FormatKind kind, int sign_bits, std::string_view split) {
    const size_t underscore = split.find('_');
    if (underscore == split.npos) return std::nullopt;
    const auto integer_bits = parse_number(split.substr(0, underscore));
    const auto fraction_bits = parse_number(split.substr(underscore + 1));
    if (!integer_bits || !fraction_bits || *integer_bits > 64 || *fraction_bits > 63)
        return std::nullopt;
    const int width = sign_bits + *integer_bits + *fraction_bits;
    if (!is_width(width) || (width == 24 && kind != FormatKind::fixed) ||
        sign_bits + *integer_bits < 1)
        return std::nullopt;
    return NumberFormat{kind, width, *fraction_bits};
}

std::optional<NumberFormat> parse_unsigned(std::string_view split) {
    for (const int width : {8, 16, 32}) {
        for (int fraction = 0; fraction <= width; ++fraction) {
            const NumberFormat format = unsigned_format(width - fraction, fraction);
            if (format_name(format).substr(1) == split) return format;
        }
    }
    return std::nullopt;
}

std::optional<NumberFormat> try_parse(std::string_view name) {
    if (name == "float") return ieee_single;
    if (name == "float64") return ieee_double;
    if (name.starts_with("int")) {
        const auto width = parse_number(name.substr(3));
        if (!width || !is_width(*width) || *width == 24) return std::nullopt;
        return NumberFormat{FormatKind::integer, *width, 0};
    }
    if (name.starts_with("q")) return parse_split(FormatKind::fixed, 0, name.substr(1));
    if (name.starts_with("u")) return parse_unsigned(name.substr(1));
    if (name.starts_with("s")) return parse_split(FormatKind::accum, 1, name.substr(1));
    return std::nullopt;
}

}  // namespace

NumberFormat parse_format(std::string_view name) {
    if (const auto format = try_parse(name)) return *format;
    throw std::invalid_argument(fmt::format(
        "unknown number format '{}': allowed are q<integer bits>_<fraction bits> of 8, 16, 24, 32 "
        "or 64 bits, s<integer bits>_<fraction bits> (GCC's _Accum, its sign not counted) of 8, "
        "16, 32 or 64 bits in all, u<integer bits>_<fraction bits> (without a sign) of 8, 16 or 32 "
        "bits, int8, int16, int32, int64, float and float64",
        name));
}

std::string format_name(const NumberFormat& format) {
    const int integer_bits = format.width - format.fraction;
    switch (format.kind) {
        case FormatKind::fixed:
            return fmt::format("{}{}_{}", format.is_unsigned ? 'u' : 'q', integer_bits,
                               format.fraction);
        case FormatKind::accum:
            return fmt::format("s{}_{}", integer_bits - 1, format.fraction);
        case FormatKind::integer:
            return fmt::format("int{}", format.width);
        case FormatKind::ieee:
            return format.width == 32 ? "float" : "float64";
    }
    throw std::logic_error("a number format of no kind");
}

bool is_nan(const NumberFormat& format, std::int64_t raw) {
    return format.is_float() && std::isnan(to_double(format, raw));
}

bool is_finite(const NumberFormat& format, std::int64_t raw) {
    return !format.is_float() || std::isfinite(to_double(format, raw));
}

double to_double(const NumberFormat& format, std::int64_t raw) {
    if (!format.is_float()) return std::ldexp(double(raw), -format.fraction);
    return format.width == 32 ? float_of_raw(raw) : std::bit_cast<double>(raw);
}

std::int64_t raw_of_double(const NumberFormat& format, double number) {
    return format.width == 32 ? raw_of_float(float(number)) : std::bit_cast<std::int64_t>(number);
}

std::int64_t raw_of_float(float number) { return std::bit_cast<std::int32_t>(number); }

float float_of_raw(std::int64_t raw) { return std::bit_cast<float>(std::int32_t(raw)); }

}  // namespace reference
