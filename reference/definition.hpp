// SPDX-License-Identifier: GPL-3.0-or-later
// What each operation returns, for every input: the exact value x of operation_table.h, rounded as
// the arithmetic rounds, and what happens to a result that does not fit.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "reference/operation.hpp"

namespace reference {

enum class Rounding {
    nearest_half_up,  // floor(x + 1/2)
    nearest_even,     // round half to even
    toward_zero,      // the magnitude truncated
    downward,         // floor(x)
    within_bound      // any integer at most bound_ulp from x
};

enum class Overflow {
    wraps,        // modulo 2^W
    saturates,    // the nearest representable number
    to_infinity,  // IEEE 754
    undefined     // not judged
};

struct Definition {
    Rounding rounding;
    Overflow overflow;
    double bound_ulp;  // of |result - x|; infinite if nothing is promised
};

inline constexpr double no_bound = std::numeric_limits<double>::infinity();

constexpr Definition definition(Operation operation, Arithmetic arithmetic) {
    const double bound = shape(operation).bound_ulp;
    const bool function = shape(operation).kind == Kind::function;
    const bool ring = shape(operation).kind == Kind::ring;
    const auto rounded = [&](Rounding rounding, Overflow overflow) {
        return Definition{
            operation == Operation::shift_right ? Rounding::downward : rounding, overflow,
            rounding == Rounding::nearest_half_up || rounding == Rounding::nearest_even ? 0.5 : 1};
    };
    switch (arithmetic) {
        case Arithmetic::nearest:
        case Arithmetic::saturating:
        case Arithmetic::correctly_rounded: {
            const bool wrapping = ring && arithmetic != Arithmetic::saturating;
            const Overflow overflow = wrapping ? Overflow::wraps : Overflow::saturates;
            if (function && arithmetic != Arithmetic::correctly_rounded)
                return {Rounding::within_bound, overflow, bound};
            return rounded(Rounding::nearest_half_up, overflow);
        }
        case Arithmetic::toward_zero:
        case Arithmetic::downward:
        case Arithmetic::half_to_even: {
            const Definition plain = definition(operation, Arithmetic::nearest);
            if (operation != Operation::multiply && operation != Operation::divide &&
                operation != Operation::convert)
                return plain;
            return rounded(arithmetic == Arithmetic::toward_zero ? Rounding::toward_zero
                           : arithmetic == Arithmetic::downward  ? Rounding::downward
                                                                 : Rounding::nearest_even,
                           plain.overflow);
        }
        case Arithmetic::published:
            // Its arc tangent interpolates in a table without a bound, and replaces a ratio outside
            // [0, 1] by the nearer end. Its atan2 lies in [0, 2 pi).
            if (function) return {Rounding::within_bound, Overflow::wraps, no_bound};
            return rounded(Rounding::toward_zero, Overflow::wraps);
        case Arithmetic::integer:
            // C leaves a zero divisor and MIN / -1 undefined.
            return rounded(Rounding::toward_zero,
                           operation == Operation::divide ? Overflow::undefined : Overflow::wraps);
        case Arithmetic::ieee:
            // IEEE 754 defines only + - * / remainder, sqrt and conversion. A compound operation
            // rounds its parts, and a function has no bound.
            switch (operation) {
                case Operation::multiply_add:
                case Operation::dot2:
                case Operation::dot3:
                case Operation::divrem:
                case Operation::divmod:
                case Operation::lerp:
                case Operation::smoothstep:
                case Operation::midpoint:
                case Operation::isqrt:
                case Operation::length2:
                case Operation::length3:
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

// Whether the results for half of the operands are below half an ulp.
constexpr bool vanishes(Operation operation) {
    return operation == Operation::exp || operation == Operation::exp2 ||
           operation == Operation::pow || operation == Operation::power;
}

// The number 1 as a raw, which may exceed a raw of 64 bits.
__extension__ using LongRaw = __int128;
constexpr LongRaw raw_one(const NumberFormat& format) { return LongRaw(1) << format.fraction; }

constexpr bool is_multiple(std::int64_t a, LongRaw one) { return a % one == 0; }
inline bool is_multiple(double a, double one) { return std::fmod(a, one) == 0; }

// Whether the operation has an exact value for the operands `x`: raws of a format, with `one` its
// raw_one, or values of floats, with `one` 1.
template <class Number, class One>
constexpr bool in_domain(Operation operation, std::span<const Number> x, One one) {
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
            for (const Number component : x)
                if (component != 0) return true;
            return false;
        case Domain::above_minus_one:
            return x[0] > -one;
        case Domain::unit_interval:
            return x[0] >= -one && x[0] <= one;
        case Domain::power:
            return x[0] > 0 || x[1] == 0 || (x[0] == 0 ? x[1] > 0 : is_multiple(x[1], one));
        case Domain::integer_power:
            return x[0] != 0 || x[1] >= 0;
    }
    return false;
}

// pi / 2^halvings as a raw, rounded half up and saturated.
constexpr std::int64_t rounded_pi(const NumberFormat& format, int halvings) {
    // pi 2^62, as 2 bits and 62.
    constexpr std::uint64_t pi = 0xc90fdaa22168c234;
    const int surplus = 62 + halvings - format.fraction;
    if (surplus < 0) return format.max();
    const std::uint64_t half = surplus == 0 ? 0 : std::uint64_t(1) << (surplus - 1);
    const std::uint64_t rounded = (pi >> surplus) + ((pi & half) != 0 ? 1 : 0);
    return rounded > std::uint64_t(format.max()) ? format.max() : std::int64_t(rounded);
}

// What a fixed-point operation returns outside its domain, in result number `component`. `a` is the
// raw of the first operand.
constexpr std::int64_t outside_domain(Operation operation, const NumberFormat& format,
                                      std::int64_t a, std::size_t component = 0) {
    switch (operation) {
        case Operation::divrem:
        case Operation::divmod:
            if (component == 1) return a;
            [[fallthrough]];
        case Operation::divide:
            return a > 0 ? format.max() : a < 0 ? format.min() : 0;
        case Operation::remainder:
            return a;
        case Operation::reciprocal_sqrt:
            return a == 0 ? format.max() : 0;
        case Operation::log:
        case Operation::log2:
        case Operation::log10:
        case Operation::log1p:
            return format.min();
        case Operation::asin:
            return a > 0 ? rounded_pi(format, 1) : -rounded_pi(format, 1);
        case Operation::acos:
            return a > 0 ? 0 : rounded_pi(format, 0);
        case Operation::pow:
        case Operation::power:
            return a == 0 ? format.max() : 0;
        default:
            return 0;  // sqrt of a negative number, atan2(0, 0), the zero vector normalised
    }
}

// The definition of a subject. A conversion to float follows IEEE 754. One from float to fixed
// point saturates what does not fit, and turns NaN into 0. One from float to C's integers
// truncates, and leaves what does not fit undefined.
constexpr Definition definition(const Subject& subject) {
    if (subject.format.is_float()) return definition(subject.operation, Arithmetic::ieee);
    if (!subject.operand_format.is_float())
        return definition(subject.operation, subject.arithmetic);
    if (subject.format.kind == FormatKind::integer)
        return {Rounding::toward_zero, Overflow::undefined, 1};
    Definition conversion = definition(subject.operation, subject.arithmetic);
    conversion.overflow = Overflow::saturates;
    return conversion;
}

}  // namespace reference
