// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/operands/operand_class.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bench/lab/operands/published_operands.hpp"

namespace operands {
namespace {

using reference::NumberFormat;
using reference::Operation;

__extension__ using Unsigned128 = unsigned __int128;

// exp(20) is 4.9e8, and Q16.16 ends at 32768.
constexpr double physics_least = 0.01, physics_greatest = 20, physics_greatest_of_exp = 10;

// Whether the operation has no result to measure for most negative operands.
bool takes_positive_operands(Operation operation) {
    const reference::Domain domain = reference::shape(operation).domain;
    return domain == reference::Domain::not_negative || domain == reference::Domain::positive ||
           domain == reference::Domain::above_minus_one || domain == reference::Domain::power;
}

bool is_exponential(Operation operation) {
    return operation == Operation::exp || operation == Operation::exp2 ||
           operation == Operation::expm1 || operation == Operation::sinh ||
           operation == Operation::cosh;
}

double greatest_of_physics(Operation operation) {
    return reference::shape(operation).domain == reference::Domain::unit_interval ? 1
           : is_exponential(operation) ? physics_greatest_of_exp
                                       : physics_greatest;
}

// The raw nearest to mantissa 2^(exponent - 63) among the positive raws. The top bit of the
// mantissa must be set. Of a float the mantissa is truncated.
std::int64_t raw_of(const NumberFormat& format, std::uint64_t mantissa, int exponent) {
    if (format.is_float()) {
        const std::uint64_t stored = (mantissa << 1) >> (65 - format.significand_bits());
        const int biased = exponent - format.min_exponent() + 1;
        return std::int64_t(biased) << (format.significand_bits() - 1) | std::int64_t(stored);
    }
    const int drop = 63 - exponent - format.fraction;  // 1..63
    const std::uint64_t twice = mantissa >> (drop - 1);
    return std::int64_t(std::min((twice + 1) >> 1, std::uint64_t(format.max())));
}

}  // namespace

std::int64_t integer(const NumberFormat& format, std::int64_t number) {
    return format.is_float() ? reference::raw_of_double(format, double(number)) : number;
}

std::string_view class_name(OperandClass operand_class) {
    switch (operand_class) {
        case OperandClass::small:
            return "small";
        case OperandClass::physics:
            return "physics";
        case OperandClass::full:
            return "full";
        case OperandClass::uniform:
            return "uniform";
        case OperandClass::published:
            return "published";
    }
    throw std::logic_error("an operand class without a name");
}

OperandClass parse_class(std::string_view name) {
    for (const OperandClass candidate : operand_classes) {
        if (class_name(candidate) == name) return candidate;
    }
    std::string allowed;
    for (const OperandClass each : operand_classes)
        allowed += fmt::format("{}{}", allowed.empty() ? "" : ", ", class_name(each));
    throw std::invalid_argument(
        fmt::format("unknown operand class '{}': allowed are {}", name, allowed));
}

Sampler::Sampler(Operation operation, const NumberFormat& format, OperandClass operand_class,
                 std::uint64_t seed)
    : operation_(operation), format_(format), class_(operand_class), random_(seed) {}

void Sampler::next(std::span<std::int64_t> operands) {
    for (std::size_t i = 0; i < operands.size(); ++i) {
        if (class_ == OperandClass::published) {
            operands[i] = format_.is_float()
                              ? reference::raw_of_double(format_, published_floats[i % 2])
                              : format_.extend(std::uint64_t(published_raws[i % 2]));
        } else {
            operands[i] = draw();
        }
    }
    if (reference::is_shift(operation_)) operands[1] = below(format_.width);
    if (operation_ == Operation::power) operands[1] = integer(format_, below(17) - 8);
}

std::int64_t Sampler::draw() {
    const bool positive = takes_positive_operands(operation_);
    if (class_ == OperandClass::uniform) return draw_uniform(positive);
    const std::int64_t magnitude = draw_magnitude();
    const bool negative = !positive && !format_.is_unsigned && (random_() >> 63) != 0;
    if (!negative) return magnitude;
    return format_.is_float() ? magnitude | format_.sign() : -magnitude;
}

std::int64_t Sampler::draw_uniform(bool positive) {
    for (;;) {
        const std::uint64_t sign_bit =
            format_.is_unsigned ? 0 : std::uint64_t(1) << (format_.width - 1);
        const std::uint64_t pattern = random_() >> (64 - format_.width);
        const std::int64_t raw = format_.extend(positive ? pattern & ~sign_bit : pattern);
        if (reference::is_finite(format_, raw)) return raw;
    }
}

std::int64_t Sampler::draw_magnitude() {
    switch (class_) {
        case OperandClass::small: {
            const int bits = format_.is_float() ? format_.significand_bits() : format_.fraction;
            const std::int64_t one = std::int64_t(1) << bits;
            const std::int64_t drawn = one == 1 ? 1 : 1 + below(one - 1);
            return format_.is_float()
                       ? reference::raw_of_double(format_, std::ldexp(double(drawn), -bits))
                       : drawn;
        }
        case OperandClass::physics:
            return log_uniform(physics_least, greatest_of_physics(operation_));
        default:
            return log_uniform(0, HUGE_VAL);
    }
}

std::int64_t Sampler::log_uniform(double least, double greatest) {
    // The binades of the format's positive numbers (of a float, of its normal numbers).
    const int first = format_.is_float() ? format_.min_exponent() : -format_.fraction;
    const int last = format_.is_float()
                         ? format_.infinity_exponent() - 1
                         : format_.width - (format_.is_unsigned ? 1 : 2) - format_.fraction;
    const int low = std::max(first, least > 0 ? std::ilogb(least) : first);
    const int high = std::min(last, std::isfinite(greatest) ? std::ilogb(greatest) : last);
    // In a format without fraction bits, 0.01..1 contains only 1, which no draw below would hit.
    if (low == high && greatest == std::ldexp(1.0, high))
        return raw_of(format_, std::uint64_t(1) << 63, high);
    for (;;) {
        const int exponent = low + int(below(high - low + 1));
        const std::uint64_t mantissa = random_() | std::uint64_t(1) << 63;
        // Within a binade the density of a log-uniform number is that of 1 / mantissa.
        const bool accepted = Unsigned128(random_()) * mantissa < Unsigned128(1) << 127;
        const double number = std::ldexp(double(mantissa), exponent - 63);
        if (accepted && number >= least && number <= greatest)
            return raw_of(format_, mantissa, exponent);
    }
}

std::int64_t Sampler::below(std::int64_t count) {
    return std::int64_t((Unsigned128(random_()) * std::uint64_t(count)) >> 64);
}

}  // namespace operands
