// SPDX-License-Identifier: MIT
// Whether a result is in range, in every split of 16, 24, 32 and 64 bits: operands on both sides of
// the limit against exact arithmetic. For 8 bits checked_test.cpp covers every operand.
#include <gtest/gtest.h>

#include <cmath>
#include <fixedpoint/portable/range.hpp>
#include <random>
#include <utility>
#include <vector>

#include "exact.hpp"

namespace {

using namespace fixedpoint;
using exact::Function;

struct Ranges {
    exact::Format format;
    int64_t exp_limit, log_limit;
    bool (*cos_fits)(int64_t);
    bool (*reciprocal_sqrt_fits)(int64_t);
    bool (*atan2_fits)(int64_t, int64_t);
    bool (*normalised_fits)(const int64_t*);
};
template <class Raw, int F>
constexpr Ranges ranges = {
    {RawLimits<Raw>::width, F},
    portable::exp_limit<Raw, F>(),
    portable::log_limit<Raw, F>(),
    [](int64_t a) { return portable::cos_fits<Raw, F>(Raw(a)); },
    [](int64_t a) { return portable::reciprocal_sqrt_fits<Raw, F>(Raw(a)); },
    [](int64_t y, int64_t x) { return portable::atan2_fits<Raw, F>(Raw(y), Raw(x)); },
    [](const int64_t* v) {
        const Raw raw[3] = {Raw(v[0]), Raw(v[1]), Raw(v[2])};
        return portable::normalised_fits<Raw, F>(raw, 0);
    }};
template <class Raw, int... F>
std::vector<Ranges> every_split(std::integer_sequence<int, F...>) {
    return {ranges<Raw, F>...};
}

class Range : public testing::TestWithParam<int> {
  protected:
    static std::vector<Ranges> splits() {
        if (GetParam() == 16) return every_split<int16_t>(std::make_integer_sequence<int, 16>{});
        if (GetParam() == 24) return every_split<Int24>(std::make_integer_sequence<int, 24>{});
        if (GetParam() == 32) return every_split<int32_t>(std::make_integer_sequence<int, 32>{});
        return every_split<int64_t>(std::make_integer_sequence<int, 64>{});
    }
};

TEST_P(Range, ExpAndLogChangeAtTheirLimits) {
    for (const Ranges& split : splits()) {
        SCOPED_TRACE(split.format.fraction);
        EXPECT_FALSE(exact::function(Function::exp, split.exp_limit, split.format).fits);
        EXPECT_TRUE(exact::function(Function::exp, split.exp_limit - 1, split.format).fits);
        EXPECT_TRUE(exact::function(Function::log, split.log_limit + 1, split.format).fits);
        if (split.log_limit > 0) {
            EXPECT_FALSE(exact::function(Function::log, split.log_limit, split.format).fits);
        }
    }
}

TEST_P(Range, CosAndReciprocalSqrt) {
    const int width = GetParam();
    std::vector<int64_t> operands;
    for (int bit = 0; bit < width - 1; ++bit) {
        for (int offset = -2; offset <= 2; ++offset)
            operands.push_back((int64_t(1) << bit) + offset);
    }
    const auto root = static_cast<int64_t>(std::sqrt(std::ldexp(1.0L, width - 1)));
    for (int64_t a = root - 2; a <= root + 2; ++a) operands.insert(operands.end(), {a, -a});
    for (const Ranges& split : splits()) {
        SCOPED_TRACE(split.format.fraction);
        for (const int64_t a : operands) {
            if (split.format.fraction >= width - 2) {
                ASSERT_EQ(split.cos_fits(a), exact::function(Function::cos, a, split.format).fits)
                    << a;
            }
            if (a > 0) {
                ASSERT_EQ(split.reciprocal_sqrt_fits(a),
                          exact::function(Function::reciprocal_sqrt, a, split.format).fits)
                    << a;
            }
        }
    }
}

TEST_P(Range, Atan2OnBothSidesOfTheLimit) {
    std::mt19937_64 random(4);
    for (const Ranges& split : splits()) {
        const int width = split.format.width, integer_bits = width - split.format.fraction;
        if (integer_bits > 3) continue;
        SCOPED_TRACE(split.format.fraction);
        for (int i = 0; i < 300; ++i) {
            const int64_t y = static_cast<int64_t>(random()) >> (64 - width);
            const long double at =
                y / std::tan(std::ldexp(1.0L, integer_bits - 1)) * (y < 0 ? -1 : 1);
            if (std::abs(at) > std::ldexp(0.99L, width - 1)) continue;
            for (int offset = -3; offset <= 3; ++offset) {
                // For 64 bits the limit is known to 2^-61, a few units of x.
                const int64_t x = std::llround(at) + (width == 64 ? 16 * offset + 8 : offset);
                ASSERT_EQ(split.atan2_fits(y, x), exact::atan2(y, x, split.format).fits)
                    << y << " " << x;
            }
        }
        for (const int64_t y : {int64_t(0), int64_t(1), int64_t(-1)}) {
            for (const int64_t x : {int64_t(-1), int64_t(0), int64_t(1)}) {
                ASSERT_EQ(split.atan2_fits(y, x), exact::atan2(y, x, split.format).fits);
            }
        }
    }
}

TEST_P(Range, NormaliseOnBothSidesOfTheLimit) {
    std::mt19937_64 random(5);
    const Ranges split = splits().back();  // one integer bit
    const int width = GetParam();
    for (int i = 0; i < 2000; ++i) {
        const int64_t x = static_cast<int64_t>(random() >> (65 - width));
        // v_y^2 is about 2 x^2 / 2^F.
        const auto y = static_cast<int64_t>(
            std::llround(std::sqrt(2.0L * x) * std::sqrt(std::ldexp((long double)x, -width))));
        for (int64_t offset = -2; offset <= 2; ++offset) {
            const int64_t v[3] = {x, y + offset, static_cast<int64_t>(random() % 3)};
            ASSERT_EQ(split.normalised_fits(v), exact::normalised(v, 0, split.format).fits)
                << v[0] << " " << v[1] << " " << v[2];
        }
    }
    const int64_t least[3] = {exact::smallest(width), 0, 0};
    EXPECT_TRUE(split.normalised_fits(least));
}

INSTANTIATE_TEST_SUITE_P(Widths, Range, testing::Values(16, 24, 32, 64));

}  // namespace
