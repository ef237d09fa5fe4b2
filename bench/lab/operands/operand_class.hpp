// SPDX-License-Identifier: GPL-3.0-or-later
// Random operands by class. The same seed gives the same operands on every machine: between the
// generator and the raw there are only integers and exact scaling.
#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <string_view>

#include "reference/operation.hpp"

namespace operands {

// The range of a class is clipped to the magnitudes that the format holds. Only `uniform` draws 0
// and MIN, which the boundary tables contain. Signs are drawn with equal probability, except that
// sqrt, reciprocal_sqrt and log get positive operands only: outside their domain there is no work
// worth measuring, and formats without a sign have no others. In every class the count of a shift
// is uniform in 0..W-1, and the integer exponent of power in -8..8.
enum class OperandClass {
    // Uniform over the numbers with 0 < |x| < 1 (a float: over the multiples of 2^-p, where p is
    // the number of bits of its significand; integers: +-1, since they have no others).
    small,
    // Log-uniform with 0.01 <= |x| <= 20: the lengths, masses and forces of a scene in SI units.
    // exp takes at most 10, since all formats of 32 bits that are compared hold exp(10).
    physics,
    // Log-uniform over all magnitudes of the format (a float: over all normal ones).
    full,
    // Every raw of the format with the same probability (a float: every finite pattern). Most have
    // large magnitudes, and all their bits are random, which is rare in log-uniform operands.
    uniform,
    // The operands of the published timing harness, the same at every draw.
    published,
};

inline constexpr OperandClass operand_classes[] = {OperandClass::small, OperandClass::physics,
                                                   OperandClass::full, OperandClass::uniform,
                                                   OperandClass::published};

std::string_view class_name(OperandClass operand_class);
// Throws std::invalid_argument for an unknown name, with a message that lists the classes.
OperandClass parse_class(std::string_view name);

// An integer operand of an operation: a raw that equals it, or a float.
std::int64_t integer(const reference::NumberFormat& format, std::int64_t number);

// How many of `wanted` samples are worth taking: one for a class whose draws are all the same.
constexpr std::uint64_t distinct_samples(OperandClass operand_class, std::uint64_t wanted) {
    return operand_class == OperandClass::published && wanted > 1 ? 1 : wanted;
}

class Sampler {
  public:
    // `format` is that of the operands.
    Sampler(reference::Operation operation, const reference::NumberFormat& format,
            OperandClass operand_class, std::uint64_t seed);

    // Fills in the next operands, as many as the operation takes.
    void next(std::span<std::int64_t> operands);

  private:
    std::int64_t draw();
    std::int64_t draw_uniform(bool positive);
    std::int64_t draw_magnitude();
    std::int64_t log_uniform(double least, double greatest);
    std::int64_t below(std::int64_t count);

    reference::Operation operation_;
    reference::NumberFormat format_;
    OperandClass class_;
    std::mt19937_64 random_;
};

}  // namespace operands
