// SPDX-License-Identifier: GPL-3.0-or-later
// What each operation returns, for every input: the exact value x of operation_table.h, as each
// arithmetic rounds it, and what it does with a result that does not fit.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "reference/operation.hpp"

namespace reference {

enum class Rounding {
    nearest_upward,  // floor(x + 1/2)
    nearest_even,    // nearest, ties to the even neighbour
    toward_zero,     // the digits after the last place dropped from the magnitude
    downward,        // floor(x)
    within_bound     // not rounded to a certain neighbour: at most bound_ulp from x
};

enum class Overflow {
    wraps,        // modulo 2^W
    clamps,       // to the nearest representable number
    to_infinity,  // IEEE 754
    undefined     // not judged
};

struct Definition {
    Rounding rounding;
    Overflow overflow;
    double bound_ulp;  // of |result - x|; infinite where nothing is promised
};

inline constexpr double no_bound = std::numeric_limits<double>::infinity();

constexpr Definition definition(Operation operation, Arithmetic arithmetic) {
    const double bound = shape(operation).bound_ulp;
    const bool function = shape(operation).kind == Kind::function;
    const bool ring = shape(operation).kind == Kind::ring;
    const auto rounded = [&](Rounding rounding, Overflow overflow) {
        return Definition{operation == Operation::shift_right ? Rounding::downward : rounding,
                          overflow, rounding == Rounding::nearest_upward ? 0.5 : 1};
    };
    switch (arithmetic) {
        case Arithmetic::nearest:
        case Arithmetic::saturating: {
            const bool wrapping = ring && arithmetic == Arithmetic::nearest;
            const Overflow overflow = wrapping ? Overflow::wraps : Overflow::clamps;
            if (function) return {Rounding::within_bound, overflow, bound};
            return rounded(Rounding::nearest_upward, overflow);
        }
        case Arithmetic::published:
            // Its arc tangent interpolates in a table and promises nothing, and takes a ratio
            // outside [0, 1] for the nearer end; its atan2 lies in [0, 2 pi).
            if (function) return {Rounding::within_bound, Overflow::wraps, no_bound};
            return rounded(Rounding::toward_zero, Overflow::wraps);
        case Arithmetic::integer:
            // C leaves a zero divisor and MIN / -1 undefined.
            return rounded(Rounding::toward_zero,
                           operation == Operation::divide ? Overflow::undefined : Overflow::wraps);
        case Arithmetic::ieee:
            // Only + - * / remainder, sqrt and conversion are bound by IEEE 754; a compound
            // operation rounds its parts, a function promises nothing.
            switch (operation) {
                case Operation::multiply_add:
                case Operation::dot2:
                case Operation::dot3:
                    return {Rounding::within_bound, Overflow::to_infinity, no_bound};
                default:
                    if (function) return {Rounding::within_bound, Overflow::to_infinity, no_bound};
                    return {Rounding::nearest_even, Overflow::to_infinity, 0.5};
            }
        case Arithmetic::accum:
            return {Rounding::within_bound, Overflow::undefined, no_bound};
    }
    return {};
}

// Whether the operation has an exact value there. `x` are raws or values.
template <class Number>
constexpr bool in_domain(Operation operation, std::span<const Number> x) {
    switch (shape(operation).domain) {
        case Domain::everywhere:
            return true;
        case Domain::nonzero_divisor:
            return x[1] != 0;
        case Domain::not_negative:
            return x[0] >= 0;
        case Domain::positive:
            return x[0] > 0;
        case Domain::nonzero_vector:
            for (const Number& component : x)
                if (component != 0) return true;
            return false;
    }
    return false;
}

// What a fixed-point operation returns where there is none; a is the first operand's raw.
constexpr std::int64_t outside_domain(Operation operation, const NumberFormat& format,
                                      std::int64_t a) {
    switch (operation) {
        case Operation::divide:
            return a > 0 ? format.max() : a < 0 ? format.min() : 0;
        case Operation::remainder:
            return a;
        case Operation::reciprocal_sqrt:
            return a == 0 ? format.max() : 0;
        case Operation::log:
            return format.min();
        default:
            return 0;  // sqrt of a negative number, atan2(0, 0), the zero vector normalised
    }
}

// The definition of a subject: a conversion to float is IEEE 754's; one from float clamps what does
// not fit (NaN: 0), into C's integers it truncates and leaves undefined what does not fit.
constexpr Definition definition(const Subject& subject) {
    if (subject.format.is_float()) return definition(subject.operation, Arithmetic::ieee);
    if (!subject.operand_format.is_float())
        return definition(subject.operation, subject.arithmetic);
    if (subject.format.kind == FormatKind::integer)
        return {Rounding::toward_zero, Overflow::undefined, 1};
    Definition conversion = definition(subject.operation, subject.arithmetic);
    conversion.overflow = Overflow::clamps;
    return conversion;
}

}  // namespace reference
