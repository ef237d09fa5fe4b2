// SPDX-License-Identifier: GPL-3.0-or-later
// The judge for exhaustive runs and long searches: the definitions of definition.hpp for one
// subject that is known at compile time, in a few nanoseconds each. Integer results are judged
// exactly, by their residual in integers; functions in double or __float128, whose error stays
// below 2^-14 ulp of the result's format. In double, the C library uses other instructions on other
// processors, and the last bit of its results may differ: sums over many inputs hide that, a search
// that compares two errors does not. Binary128 is integer arithmetic, the same everywhere.
//
// Covers fixed-point and integer formats of every width; not float, not _Accum, not exp of a 64-bit
// format. A test compares it with judge.hpp.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <type_traits>

#include "reference/definition.hpp"
#include "reference/function.hpp"
#include "reference/judgement.hpp"

namespace reference::bulk {

// Raws of 8 and 16 bits and their products fit 64 bits.
__extension__ using Integer128 = __int128;
__extension__ using Unsigned128 = unsigned __int128;
template <int width>
using Wide = std::conditional_t<(width <= 16), std::int64_t, Integer128>;
template <int width>
using Float = std::conditional_t<(width <= 32), double, long double>;

template <class Number>
constexpr double to_double(Number x) {
    // The conversion from 128 bits is a library call; residuals are nearly always short.
    return x == Number(std::int64_t(x)) ? double(std::int64_t(x)) : double(x);
}

template <int bits, class Number>
constexpr Number sign_extend(Number x) {
    constexpr int excess = int(8 * sizeof(Number)) - bits;
    if constexpr (sizeof(Number) == 8)
        return Number(std::uint64_t(x) << excess) >> excess;
    else
        return Number(Unsigned128(x) << excess) >> excess;
}

// a + b and a - b modulo 2^64 or 2^128: a wrapping result does not depend on the bits lost at the
// top.
template <class Number>
using Unsigned = std::conditional_t<sizeof(Number) == 8, std::uint64_t, Unsigned128>;
template <class Number>
constexpr Number sum(Number a, Number b) {
    return Number(Unsigned<Number>(a) + Unsigned<Number>(b));
}
template <class Number>
constexpr Number difference(Number a, Number b) {
    return Number(Unsigned<Number>(a) - Unsigned<Number>(b));
}

constexpr Judgement pinned(std::int64_t target, std::int64_t result) {
    const double error = to_double(Integer128(result) - target);
    return {.error_ulp = error, .defined = true, .as_defined = result == target};
}

// Judges the result against x = n / q, q > 0, given the residual d = result q - n.
template <Rounding rounding, class Number>
constexpr bool is_rounded(Number d, Number q, bool x_is_negative, bool even) {
    static_assert(rounding != Rounding::within_bound);
    if constexpr (rounding == Rounding::nearest_even) {
        const Number distance = d < 0 ? -d : d, other = q - distance;
        return distance < other || (distance == other && even);
    }
    if constexpr (rounding == Rounding::nearest_half_up)
        return d <= q / 2 && -d < q - q / 2;  // -1/2 < d / q <= 1/2
    const bool from_below = rounding == Rounding::downward || !x_is_negative;
    return from_below ? -q < d && d <= 0 : 0 <= d && d < q;
}

// Where x = n / q, rounded, lies: +1 above the range, -1 below it, 0 within.
template <NumberFormat format, Rounding rounding, class Number>
constexpr int beyond_range(Number n, Number q) {
    const Number high = Number(format.max()) * q, low = Number(format.min()) * q;
    if constexpr (rounding == Rounding::nearest_half_up || rounding == Rounding::nearest_even)
        return n >= high + (q - q / 2) ? 1 : n < low - q / 2 ? -1 : 0;
    else if constexpr (rounding == Rounding::toward_zero)
        return n >= high + q ? 1 : n <= low - q ? -1 : 0;
    else
        return n >= high + q ? 1 : n < low ? -1 : 0;
}

// Judges x = n / q. `power` is log2 of q if that is known at compile time, otherwise negative.
template <Subject subject, int power = -1, class Number>
constexpr Judgement judge_quotient(Number n, Number q, std::int64_t result) {
    constexpr Definition held_to = definition(subject);
    constexpr NumberFormat format = subject.format;
    if constexpr (held_to.overflow != Overflow::wraps) {
        if (const int beyond = beyond_range<format, held_to.rounding>(n, q)) {
            if constexpr (held_to.overflow == Overflow::undefined)
                return {.excluded = "overflow is undefined here"};
            return pinned(beyond > 0 ? format.max() : format.min(), result);
        }
    }
    Number d = difference(Number(result) * q, n);
    if constexpr (held_to.overflow == Overflow::wraps) {
        if constexpr (power >= 0) {
            d = sign_extend<format.width + power>(d);
        } else {
            const Number half_turn = q << (format.width - 1);
            if (d >= half_turn || d < -half_turn) {
                d %= 2 * half_turn;
                d += d >= half_turn ? -2 * half_turn : d < -half_turn ? 2 * half_turn : 0;
            }
        }
    }
    return {.error_ulp = to_double(d) / to_double(q),
            .as_defined = is_rounded<held_to.rounding>(d, q, n < 0, result % 2 == 0)};
}

// The error modulo 2^W that is nearest to 0.
template <NumberFormat format, class Number>
Number wrapped(Number error) {
    constexpr Number turn = Number(2) * -Number(format.sign());
    if ((error < 0 ? -error : error) < turn / 2) return error;
    return error - turn * functions::floor(error / turn + Number(0.5));
}

// Judges the value x of a function, in ulp.
template <Subject subject, class Number>
Judgement judge_function(Number x, std::int64_t result) {
    constexpr Definition held_to = definition(subject);
    constexpr NumberFormat format = subject.format;
    Number error = Number(result) - x;
    if constexpr (held_to.overflow == Overflow::wraps) {
        error = wrapped<format>(error);
    } else {
        if (x >= Number(format.max()) + Number(0.5)) return pinned(format.max(), result);
        if (x < Number(format.min()) - Number(0.5)) return pinned(format.min(), result);
    }
    const bool as_defined = held_to.rounding == Rounding::nearest_half_up
                                ? error > Number(-0.5) && error <= Number(0.5)
                                : std::abs(double(error)) <= held_to.bound_ulp;
    return {.error_ulp = double(error),
            .as_defined = as_defined,
            .underflow = vanishes(subject.operation) && x < Number(0.5) && x > Number(-0.5)};
}

// result - sqrt(square) without cancellation, for square >= 0.
template <class Number, class Square>
Number root_error(std::int64_t result, Square square) {
    const Number root = std::sqrt(Number(square));
    const Number r = Number(result);
    if (r <= 0) return r - root;
    // |result^2 - square| < 2^127 wherever the root does not saturate.
    const Integer128 residual =
        Integer128(Unsigned128(result) * Unsigned128(result) - Unsigned128(square));
    return (residual == std::int64_t(residual) ? Number(std::int64_t(residual))
                                               : Number(residual)) /
           (r + root);
}

// A root with F fraction bits, which may differ from those of the subject's format.
template <Subject subject>
Judgement judge_root(std::int64_t a, std::int64_t result, int F = subject.format.fraction) {
    constexpr NumberFormat format = subject.format;
    constexpr Definition held_to = definition(subject);
    using Number = Wide<format.width>;
    const Number square = Number(a) << F;
    const Number r = result;
    const bool nearest = square <= r * r + r && (r == 0 || square > r * r - r);
    const bool below = r * r <= square && square < (r + 1) * (r + 1);
    const bool rounded = held_to.rounding == Rounding::nearest_half_up ? nearest : below;
    // In a format whose range ends below 1, a root may round to 1.
    if (2 * F >= format.width) {
        const Number limit = Number(format.max());
        const bool above = held_to.rounding == Rounding::nearest_half_up
                               ? square > limit * limit + limit
                               : square >= (limit + 1) * (limit + 1);
        if (above && held_to.overflow == Overflow::saturates) return pinned(format.max(), result);
    }
    const auto error = root_error<Float<format.width>>(result, square);
    const bool wraps = held_to.overflow == Overflow::wraps;
    return {.error_ulp = double(wraps ? wrapped<format>(error) : error),
            .as_defined = result >= 0 && rounded};
}

template <Subject subject>
Judgement judge_length(std::span<const std::int64_t> v, std::int64_t result) {
    constexpr NumberFormat format = subject.format;
    static_assert(definition(subject).rounding == Rounding::nearest_half_up);
    using Square = std::conditional_t<(format.width <= 16), std::uint64_t, Unsigned128>;
    Square square = 0;
    for (const std::int64_t component : v) square += Square(component) * Square(component);
    // sqrt(square) >= MAX + 1/2
    const Square limit = Square(format.max());
    if (square > limit * limit + limit) return pinned(format.max(), result);
    const Square r(result);
    return {.error_ulp = double(root_error<Float<format.width>>(result, square)),
            .as_defined = result >= 0 && square <= r * r + r && (r == 0 || square > r * r - r)};
}

template <Subject subject>
Judgement judge_unit_vector(std::span<const std::int64_t> v,
                            std::span<const std::int64_t> results) {
    static_assert(definition(subject).rounding != Rounding::nearest_half_up,
                  "A double cannot show on which side of a tie a component lies.");
    constexpr NumberFormat format = subject.format;
    using Number = Float<format.width>;
    Number square = 0;
    for (const std::int64_t component : v) square += Number(component) * Number(component);
    const Number one = std::ldexp(Number(1), format.fraction);
    Judgement worst;
    for (std::size_t i = 0; i < v.size(); ++i) {
        const Judgement judgement =
            square == 0
                ? pinned(0, results[i])
                : judge_function<subject>(Number(v[i]) / std::sqrt(square) * one, results[i]);
        if (std::abs(judgement.error_ulp) > std::abs(worst.error_ulp))
            worst.error_ulp = judgement.error_ulp;
        worst.as_defined &= judgement.as_defined;
        worst.defined = (i == 0 || worst.defined) && judgement.defined;
    }
    return worst;
}

// The type in which functions are computed, unless the caller chooses another.
template <int width>
using FunctionFloat = std::conditional_t<(width <= 32), double, Binary128>;

// Takes the arguments of reference::judge; does not check the number of operands and results.
template <Subject subject, class Real = FunctionFloat<subject.format.width>>
Judgement judge(std::span<const std::int64_t> operands, std::span<const std::int64_t> results) {
    constexpr Operation operation = subject.operation;
    constexpr NumberFormat format = subject.format;
    constexpr int F = format.fraction;
    constexpr bool published = subject.arithmetic == Arithmetic::published;
    static_assert(format.kind == FormatKind::fixed || format.kind == FormatKind::integer,
                  "float and _Accum are judged by reference::judge.");
    static_assert(operation != Operation::exp || format.width <= 32,
                  "No C type holds exp of a 64-bit format to a fraction of its ulp.");
    using Number = Wide<format.width>;
    const auto raw = [&](std::size_t i) { return Number(operands[i]); };
    const auto real = [&](std::size_t i) { return Real(operands[i]) * Real(std::ldexp(1.0, -F)); };
    const Real one = Real(std::ldexp(1.0, F));
    const std::int64_t a = operands[0], result = results[0];
    const auto whole = [&](auto x) {
        return judge_quotient<subject, 0>(x, decltype(x)(1), result);
    };
    const auto product = [&](auto x) {
        return judge_quotient<subject, F>(x, decltype(x)(1) << F, result);
    };

    if (shape(operation).results == 1 && !in_domain(operation, operands, raw_one(format))) {
        if constexpr (subject.arithmetic == Arithmetic::integer)
            return {.excluded = "undefined outside the operation's domain"};
        return pinned(outside_domain(operation, format, a), result);
    }
    // Of several results: each is judged on its own, and the larger error counts.
    const auto worse_of = [](const Judgement& s, const Judgement& c) {
        Judgement worse = std::abs(c.error_ulp) > std::abs(s.error_ulp) ? c : s;
        worse.defined = s.defined && c.defined;
        worse.as_defined = s.as_defined && c.as_defined;
        return worse;
    };
    const auto sine_and_cosine = [&]<Operation sine, Operation cosine>() {
        return worse_of(
            judge<Subject{sine, format, subject.arithmetic}, Real>(operands, results.first(1)),
            judge<Subject{cosine, format, subject.arithmetic}, Real>(operands,
                                                                     results.subspan(1, 1)));
    };
    if constexpr (operation == Operation::add) {
        return whole(raw(0) + raw(1));
    } else if constexpr (operation == Operation::subtract) {
        return whole(raw(0) - raw(1));
    } else if constexpr (operation == Operation::negate) {
        return whole(-raw(0));
    } else if constexpr (operation == Operation::abs) {
        return whole(a < 0 ? -raw(0) : raw(0));
    } else if constexpr (operation == Operation::multiply) {
        return product(raw(0) * raw(1));
    } else if constexpr (operation == Operation::multiply_add) {
        return product(raw(0) * raw(1) + (raw(2) << F));
    } else if constexpr (operation == Operation::dot2 || operation == Operation::dot3) {
        static_assert(format.width <= 32 || subject.arithmetic == Arithmetic::nearest,
                      "The sum of 64-bit products is kept modulo 2^128: its sign is unknown.");
        constexpr std::size_t dimensions = shape(operation).operands / 2;
        Number total = 0;
        for (std::size_t i = 0; i < dimensions; ++i)
            total = sum(total, raw(i) * raw(dimensions + i));
        return product(total);
    } else if constexpr (operation == Operation::divide) {
        const std::int64_t b = operands[1];
        const Number n = raw(0) << F;
        return judge_quotient<subject>(b < 0 ? -n : n, b < 0 ? -raw(1) : raw(1), result);
    } else if constexpr (operation == Operation::remainder) {
        return whole(raw(0) % raw(1));
    } else if constexpr (operation == Operation::convert) {
        constexpr int gained = F - subject.operand_format.fraction;
        constexpr int lost = gained < 0 ? -gained : 0;
        using Either = std::conditional_t<(subject.operand_format.width <= 16), Number, Integer128>;
        const Either n = Either(a) << (gained > 0 ? gained : 0);
        return judge_quotient<subject, lost>(n, Either(1) << lost, result);
    } else if constexpr (operation == Operation::sqrt) {
        return judge_root<subject>(a, result);
    } else if constexpr (operation == Operation::sincos) {
        return sine_and_cosine.template operator()<Operation::sin, Operation::cos>();
    } else if constexpr (operation == Operation::sincos_turns) {
        return sine_and_cosine.template operator()<Operation::sin_turns, Operation::cos_turns>();
    } else if constexpr (operation == Operation::sincos_degrees) {
        return sine_and_cosine
            .template operator()<Operation::sin_degrees, Operation::cos_degrees>();
    } else if constexpr (gives_integer_quotient(operation)) {
        if (operands[1] == 0)
            return worse_of(pinned(outside_domain(operation, format, a, 0), result),
                            pinned(outside_domain(operation, format, a, 1), results[1]));
        Number quotient = raw(0) / raw(1), rest = raw(0) % raw(1);
        if (operation == Operation::divmod && rest != 0 && (rest < 0) != (raw(1) < 0)) {
            quotient -= 1;
            rest += raw(1);
        }
        return worse_of(whole(quotient), judge_quotient<subject, 0>(rest, Number(1), results[1]));
    } else if constexpr (operation == Operation::lerp) {
        return product(sum(raw(0) << F, raw(2) * (raw(1) - raw(0))));
    } else if constexpr (operation == Operation::smoothstep) {
        static_assert(F <= 40, "t^2 (3 - 2 t) 2^(3F) has to fit 128 bits.");
        const Integer128 unit = Integer128(1) << F, square = unit << F;
        const Integer128 t = a < 0 ? Integer128(0) : a > unit ? unit : Integer128(a);
        const Integer128 n = t * t * (3 * unit - 2 * t), target = (n + square / 2) / square;
        if (target > format.max()) return pinned(format.max(), result);
        return {.error_ulp =
                    to_double(result - target) + to_double(target * square - n) / to_double(square),
                .as_defined = result == target};
    } else if constexpr (operation == Operation::midpoint) {
        return judge_quotient<subject, 1>(raw(0) + raw(1), Number(2), result);
    } else if constexpr (operation == Operation::abs_diff) {
        return whole(a < operands[1] ? raw(1) - raw(0) : raw(0) - raw(1));
    } else if constexpr (operation == Operation::copysign) {
        return whole((a < 0) == (operands[1] < 0) ? raw(0) : -raw(0));
    } else if constexpr (operation == Operation::sign) {
        return whole(Number(a < 0 ? -1 : a > 0 ? 1 : 0));
    } else if constexpr (operation == Operation::isqrt) {
        std::int64_t root = std::int64_t(std::sqrt((long double)(a)));
        if (Integer128(root) * root > a) --root;
        return whole(Number(root));
    } else if constexpr (operation == Operation::length2 || operation == Operation::length3) {
        return judge_length<subject>(operands.first(shape(operation).operands), result);
    } else if constexpr (operation == Operation::normalise3) {
        return judge_unit_vector<subject>(operands.first(3), results.first(3));
    } else {
        static_assert(shape(operation).operands <= 2, "This operation has no fast judge.");
        Real x[2] = {real(0)};
        if constexpr (takes_integer(operation, 1))
            x[1] = Real(operands[1]);
        else if constexpr (shape(operation).operands == 2)
            x[1] = real(1);
        if (published && operation == Operation::atan)
            x[0] = x[0] < 0 ? Real(0) : x[0] > 1 ? Real(1) : x[0];
        Real exact = function(operation, x);
        if (published && operation == Operation::atan2 && exact < 0)
            exact += 2 * functions::atan2(Real(0), Real(-1));
        const Judgement judgement = judge_function<subject>(exact * one, result);
        if constexpr (definition(subject).rounding == Rounding::nearest_half_up &&
                      !std::is_same_v<Real, Binary128>) {
            // This close to a tie, double cannot decide on which side of it the value lies.
            if (std::abs(std::abs(judgement.error_ulp) - 0.5) < std::ldexp(1.0, -14))
                return judge<subject, Binary128>(operands, results);
        }
        return judgement;
    }
}

template <Subject subject>
Judgement judge(std::span<const std::int64_t> operands, std::int64_t result) {
    return judge<subject>(operands, std::span(&result, 1));
}

}  // namespace reference::bulk
