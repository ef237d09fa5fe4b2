// SPDX-License-Identifier: GPL-3.0-or-later
// A subject on the host: the same source that the device compiles, by operation and policy.
#pragma once

#include <cstdint>
#include <span>

#include <fixedpoint/integer.hpp>

#include "reference/operation.hpp"

namespace operations {

// Computes `operation` of the operands in the policy's arithmetic.
template <reference::Subject subject, class Policy>
void evaluate(std::span<const std::int64_t> operands, std::span<std::int64_t> results) {
    using reference::Operation;
    constexpr Operation operation = subject.operation;
    constexpr int F = subject.format.fraction;
    using Raw = fixedpoint::Integer<subject.format.width>;
    const auto raw = [&](std::size_t i) { return static_cast<Raw>(operands[i]); };

    if constexpr (operation == Operation::add) {
        results[0] = Policy::template add<Raw, F>(raw(0), raw(1));
    } else if constexpr (operation == Operation::subtract) {
        results[0] = Policy::template subtract<Raw, F>(raw(0), raw(1));
    } else if constexpr (operation == Operation::multiply) {
        results[0] = Policy::template multiply<Raw, F>(raw(0), raw(1));
    } else if constexpr (operation == Operation::divide) {
        results[0] = Policy::template divide<Raw, F>(raw(0), raw(1));
    } else if constexpr (operation == Operation::remainder) {
        results[0] = Policy::template remainder<Raw, F>(raw(0), raw(1));
    } else if constexpr (operation == Operation::multiply_add) {
        results[0] = Policy::template multiply_add<Raw, F>(raw(0), raw(1), raw(2));
    } else if constexpr (operation == Operation::sqrt) {
        results[0] = Policy::template sqrt<Raw, F>(raw(0));
    } else if constexpr (operation == Operation::reciprocal_sqrt) {
        results[0] = Policy::template reciprocal_sqrt<Raw, F>(raw(0));
    } else if constexpr (operation == Operation::atan) {
        results[0] = Policy::template atan<Raw, F>(raw(0));
    } else if constexpr (operation == Operation::atan2) {
        results[0] = Policy::template atan2<Raw, F>(raw(0), raw(1));
    } else if constexpr (operation == Operation::sin) {
        results[0] = Policy::template sin<Raw, F>(raw(0));
    } else if constexpr (operation == Operation::cos) {
        results[0] = Policy::template cos<Raw, F>(raw(0));
    } else if constexpr (operation == Operation::exp) {
        results[0] = Policy::template exp<Raw, F>(raw(0));
    } else if constexpr (operation == Operation::log) {
        results[0] = Policy::template log<Raw, F>(raw(0));
    } else {
        constexpr std::size_t arity = reference::shape(operation).operands;
        Raw vectors[arity];
        for (std::size_t i = 0; i < arity; ++i) vectors[i] = raw(i);
        if constexpr (operation == Operation::dot2) {
            results[0] = Policy::template dot2<Raw, F>(vectors, vectors + 2);
        } else if constexpr (operation == Operation::dot3) {
            results[0] = Policy::template dot3<Raw, F>(vectors, vectors + 3);
        } else if constexpr (operation == Operation::length2) {
            results[0] = Policy::template length2<Raw, F>(vectors);
        } else if constexpr (operation == Operation::length3) {
            results[0] = Policy::template length3<Raw, F>(vectors);
        } else if constexpr (operation == Operation::normalise3) {
            Raw unit[3];
            Policy::template normalise3<Raw, F>(vectors, unit);
            for (std::size_t i = 0; i < 3; ++i) results[i] = unit[i];
        } else {
            static_assert(operation == Operation::add, "This operation has no host subject.");
        }
    }
}

}  // namespace operations
