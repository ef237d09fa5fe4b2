// SPDX-License-Identifier: GPL-3.0-or-later
// What each operation returns, for every input, written once: one sentence an operation, and how
// each arithmetic rounds and what it does with a result that does not fit.
//
// Notation: a, b raws of W bits, value = raw / 2^F; x the exact result in units of the last place.
#pragma once

#include <limits>

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

// The ring operations: exact, rounded, then taken modulo 2^W in the wrapping arithmetics, so that
// sums whose intermediates overflow still come out right.
constexpr bool is_ring(Operation operation) {
    switch (operation) {
        case Operation::add:           // x = a + b
        case Operation::subtract:      // x = a - b
        case Operation::multiply:      // x = a b / 2^F
        case Operation::negate:        // x = -a
        case Operation::abs:           // x = |a|
        case Operation::shift_left:    // x = a 2^n
        case Operation::shift_right:   // x = a / 2^n, always rounded downward: an arithmetic shift
        case Operation::convert:       // x = the value in the result's last places
        case Operation::multiply_add:  // x = a b / 2^F + c, one rounding
        case Operation::dot2:          // x = sum of a_i b_i / 2^F, one rounding
        case Operation::dot3:
            return true;
        default:
            return false;
    }
}

// The promise in ulp of the functions that are not rounded to a certain neighbour; 0 for the
// others.
constexpr double function_bound(Operation operation) {
    switch (operation) {
        case Operation::reciprocal_sqrt:  // a = 0: MAX; a < 0: 0
        case Operation::atan:
        case Operation::atan2:  // in (-pi, pi]; atan2(0, 0) = 0
        case Operation::sin:  // any angle in radians; never beyond +-1, which errs by 1 ulp or more
        case Operation::cos:
        case Operation::sincos:
            return 0.75;
        case Operation::exp:      // underflows to 0 by rounding
        case Operation::log:      // a <= 0: MIN
        case Operation::length2:  // no overflow of the squares
        case Operation::length3:
        case Operation::normalise3:  // of each component; the zero vector stays zero
            return 1;
        default:
            // divide: x = a 2^F / b; b = 0: MAX if a > 0, MIN if a < 0, 0 if a = 0.
            // remainder: x = a - b trunc(a / b), exact; b = 0: a.
            // sqrt: x = sqrt(a 2^F), never a tie; a < 0: 0.
            return 0;
    }
}

constexpr Definition definition(Operation operation, Arithmetic arithmetic) {
    const double bound = function_bound(operation);
    const bool function = bound > 0;
    const bool wraps = is_ring(operation);
    const auto rounded = [&](Rounding rounding, Overflow overflow) {
        return Definition{operation == Operation::shift_right ? Rounding::downward : rounding,
                          overflow, rounding == Rounding::nearest_upward ? 0.5 : 1};
    };
    switch (arithmetic) {
        case Arithmetic::nearest:
        case Arithmetic::saturating: {
            const bool wrapping = wraps && arithmetic == Arithmetic::nearest;
            const Overflow overflow = wrapping ? Overflow::wraps : Overflow::clamps;
            if (function) return {Rounding::within_bound, overflow, bound};
            return rounded(Rounding::nearest_upward, overflow);
        }
        case Arithmetic::truncating:
            if (function) return {Rounding::within_bound, Overflow::clamps, bound};
            return rounded(Rounding::toward_zero, wraps ? Overflow::wraps : Overflow::clamps);
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

// The same for a subject: a conversion to float is IEEE 754's; one from float clamps what does not
// fit (NaN: 0), into C's integers it truncates and leaves undefined what does not fit.
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
