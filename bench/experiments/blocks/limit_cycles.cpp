// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/blocks/limit_cycles.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fixedpoint/blocks/biquad.hpp>
#include <fixedpoint/blocks/one_pole.hpp>
#include <numbers>
#include <random>

#include "bench/lab/catalogue/formats.h"

namespace blocks {
namespace {

__extension__ using Exact = __int128;

constexpr unsigned starts = 64;

// The largest output in the limit cycle in which a filter ends, and the steps of its period. A copy
// of the filter, renewed after ever more steps, is compared with the filter until they are equal
// (Brent, "An improved Monte Carlo factorization algorithm", 1980). If the period is not found, the
// outputs of as many steps count.
struct Cycle {
    std::uint64_t largest = 0;
    std::optional<unsigned> period;
};
template <class Filter>
Cycle cycle_of(Filter filter) {
    constexpr unsigned longest = 1u << 20;
    Filter former = filter;
    unsigned steps = 0;
    Cycle cycle;
    for (unsigned next = 1; next <= longest && !cycle.period; next *= 2) {
        // All bytes, also those of padding, which no step changes.
        std::memcpy(static_cast<void*>(&former), &filter, sizeof filter);
        for (steps = 0; steps < next && !cycle.period;) {
            filter.step(0);
            ++steps;
            // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
            if (std::memcmp(&former, &filter, sizeof filter) == 0) cycle.period = steps;
        }
    }
    for (unsigned i = 0; i < steps; ++i) {
        const std::int64_t y = filter.step(0);
        cycle.largest = std::max(cycle.largest, static_cast<std::uint64_t>(std::abs(y)));
    }
    return cycle;
}
void add(LimitCycle& row, const Cycle& cycle) {
    row.largest_ulp = std::max(row.largest_ulp, cycle.largest);
    if (!cycle.period)
        row.longest_period = std::nullopt;
    else if (row.longest_period)
        row.longest_period = std::max(*row.longest_period, *cycle.period);
}

// The sum of products rounded to nearest, half up.
template <int F>
std::int64_t rounded(Exact sum) {
    return static_cast<std::int64_t>((sum + (Exact(1) << (F - 1))) >> F);
}

// First-order filters.
template <class Number>
struct WithFeedback1 {
    fixedpoint::OnePole<Number> filter;
    WithFeedback1(Number k, std::int64_t y)
        : filter(k, Number::from_raw(static_cast<typename Number::Raw>(y))) {}
    std::int64_t step(std::int64_t x) {
        return filter.update(Number::from_raw(static_cast<typename Number::Raw>(x))).raw();
    }
};
template <class Number>
struct WithoutFeedback1 {
    std::int64_t k, y;
    WithoutFeedback1(Number coefficient, std::int64_t start) : k(coefficient.raw()), y(start) {}
    std::int64_t step(std::int64_t x) {
        return y += rounded<Number::fraction_bits>(Exact(k) * (x - y));
    }
};

// Second-order filters with the output y = x - a1 y1 - a2 y2.
template <class Number>
struct WithFeedback2 {
    fixedpoint::Biquad<Number> filter;
    explicit WithFeedback2(const fixedpoint::BiquadCoefficients<Number>& c) : filter(c) {}
    std::int64_t step(std::int64_t x) {
        return filter.update(Number::from_raw(static_cast<typename Number::Raw>(x))).raw();
    }
};
template <class Number>
struct WithoutFeedback2 {
    std::int64_t a1, a2, y1 = 0, y2 = 0;
    explicit WithoutFeedback2(const fixedpoint::BiquadCoefficients<Number>& c)
        : a1(c.a1.raw()), a2(c.a2.raw()) {}
    std::int64_t step(std::int64_t x) {
        const std::int64_t y =
            x + rounded<Number::fraction_bits>(-(Exact(a1) * y1 + Exact(a2) * y2));
        y2 = y1, y1 = y;
        return y;
    }
};

template <class Number>
Number nearest(double x) {
    return fixedpoint::from_float<Number>(x);
}
template <class Number>
double value(Number x) {
    return fixedpoint::to_float<double>(x);
}

template <class Number, class Filter>
LimitCycle first_order(const std::string& format, int steps, bool feedback, std::uint64_t bound) {
    LimitCycle row{"one pole", format, steps, feedback, starts, 0, bound, 1};
    const Number k = nearest<Number>(-std::expm1(-1.0 / steps));
    std::mt19937_64 random(1);
    for (unsigned i = 0; i < starts; ++i) {
        // Of every magnitude.
        const int bits =
            8 * static_cast<int>(sizeof(typename Number::Raw)) - static_cast<int>(i / 8);
        const auto y = static_cast<std::int64_t>(random()) >> (64 - bits);
        add(row, cycle_of(Filter(k, y)));
    }
    return row;
}

// The poles of the low-pass filter (bilinear transform).
template <class Number>
fixedpoint::BiquadCoefficients<Number> low_pass(int steps) {
    const double w = std::tan(std::numbers::pi / steps), damping = std::numbers::sqrt2 * w;
    const double n = 1 + damping + w * w;
    return {nearest<Number>(1), Number(), Number(), nearest<Number>(2 * (w * w - 1) / n),
            nearest<Number>((1 - damping + w * w) / n)};
}

// 1/2 sum |g_n|, or nothing if the rounded coefficients are those of an unstable filter.
template <class Number>
std::optional<double> bound(const fixedpoint::BiquadCoefficients<Number>& c) {
    const double a1 = value(c.a1), a2 = value(c.a2);
    if (!(a2 < 1 && std::abs(a1) < 1 + a2)) return {};
    const double k1 = -std::floor(-a1 + 0.5), k2 = -std::floor(-a2 + 0.5);
    double sum = 0, y1 = 0, y2 = 0;
    for (int n = 0; n < 1'000'000; ++n) {
        const double y = (n == 0) + k1 * (n == 1) + k2 * (n == 2) - a1 * y1 - a2 * y2;
        sum += std::abs(y);
        y2 = y1, y1 = y;
    }
    return sum / 2;
}

template <class Number, class Filter>
LimitCycle second_order(const std::string& format, int steps, bool feedback,
                        std::optional<double> bound) {
    LimitCycle row{"biquad", format, steps, feedback, starts, 0, bound, 1};
    std::mt19937_64 random(2);
    for (unsigned i = 0; i < starts; ++i) {
        Filter filter(low_pass<Number>(steps));
        // Of every magnitude up to 1/8, from which the outputs stay in range.
        const int bits = std::max(1, Number::fraction_bits - 2 - static_cast<int>(i / 8));
        for (int n = 0; n < 2; ++n) filter.step(static_cast<std::int64_t>(random()) >> (64 - bits));
        add(row, cycle_of(filter));
    }
    return row;
}

template <class Number>
void add(std::vector<LimitCycle>& rows, const std::string& format) {
    for (const int steps : {10, 100, 1000}) {
        const std::int64_t k = nearest<Number>(-std::expm1(-1.0 / steps)).raw();
        if (k == 0) continue;
        rows.push_back(first_order<Number, WithFeedback1<Number>>(format, steps, true, 0));
        // The largest distance d with k d <= 1/2: the tie below 0 rounds to 0.
        const std::int64_t half = std::int64_t(1) << (Number::fraction_bits - 1);
        rows.push_back(first_order<Number, WithoutFeedback1<Number>>(
            format, steps, false, static_cast<std::uint64_t>(half / k)));
    }
    for (const int steps : {10, 100, 1000}) {
        const auto held = bound(low_pass<Number>(steps));
        if (!held) continue;
        rows.push_back(second_order<Number, WithFeedback2<Number>>(format, steps, true, held));
        rows.push_back(second_order<Number, WithoutFeedback2<Number>>(format, steps, false, {}));
    }
}

}  // namespace

std::vector<LimitCycle> limit_cycles() {
    std::vector<LimitCycle> rows;
#define ADD_FORMAT(name, I, F) add<fixedpoint::Fixed<I, F>>(rows, #name);
    BLOCK_FORMATS(ADD_FORMAT)
#undef ADD_FORMAT
    return rows;
}

}  // namespace blocks
