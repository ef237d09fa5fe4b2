// SPDX-License-Identifier: GPL-3.0-or-later
// Random operands by class. The same seed gives the same operands on every machine: nothing but
// integers and exact scaling stands between the generator and the raw.
#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <string_view>

#include "reference/operation.hpp"

namespace operands {

// A class's range is clipped to the magnitudes that the format holds; no class but `uniform` draws
// 0 or MIN, which the boundary tables hold. Signs are even, but sqrt, reciprocal_sqrt and log get
// positive operands only: outside their domain they do no work worth measuring. The count of a
// shift is uniform in 0..W-1 in every class, the integer exponent of power in -8..8.
enum class OperandClass {
    // Uniform over the numbers with 0 < |x| < 1 (a float: over the multiples of 2^-p, p the bits
    // of its significand; integers have none, which leaves +-1).
    small,
    // Log-uniform with 0.01 <= |x| <= 20, the lengths, masses and forces of a scene in SI units.
    // exp takes no more than 10, since all formats of 32 bits that are compared hold exp(10).
    physics,
    // Log-uniform over all magnitudes of the format (a float: over all normal ones).
    full,
    // Every raw of the format with the same probability (a float: every finite pattern). Most
    // have the largest magnitudes, and all their bits are random: what log-uniform operands seldom
    // have.
    uniform,
    // The operands of the published timing harness, the same at every draw.
    published,
};

inline constexpr OperandClass operand_classes[] = {OperandClass::small, OperandClass::physics,
                                                   OperandClass::full, OperandClass::uniform,
                                                   OperandClass::published};

std::string_view class_name(OperandClass operand_class);
// Throws std::invalid_argument that lists the classes.
OperandClass parse_class(std::string_view name);

// An integer, where an operation takes one: a raw that stands for itself, or a float.
std::int64_t integer(const reference::NumberFormat& format, std::int64_t number);

// How many of `wanted` samples are worth taking: one of a class whose draws are all the same.
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
