// SPDX-License-Identifier: MIT
// atan2 and atan against long double and a wider binary float: all inputs of 8-bit formats and all
// of atan in 16 bits, boundary and random operands elsewhere.
#include <gtest/gtest.h>

#include <cmath>
#include <fixedpoint/kernel/dispatch.hpp>
#include <random>
#include <utility>
#include <vector>

#include "function_accuracy.hpp"

namespace {

using fixedpoint::tests::boundaries;
using fixedpoint::tests::error_in_ulp;
using fixedpoint::tests::Exact;
using fixedpoint::tests::exact_value;
using fixedpoint::tests::random_raw;

constexpr double bound = 0.75;

template <class Raw, int F>
void expect_atan2(Raw y, Raw x, Raw result) {
    using std::atan2;
    const Exact<Raw> exact = y == 0 && x == 0 ? Exact<Raw>(0) : atan2(Exact<Raw>(y), Exact<Raw>(x));
    ASSERT_LE((error_in_ulp<Raw, F>(result, exact)), bound)
        << "atan2(" << +y << ", " << +x << "), " << F << " fraction bits, gave " << +result;
}

template <class Raw, int F>
void expect_atan(Raw a, Raw result) {
    using std::atan;
    const Exact<Raw> exact = atan(exact_value<Raw, F>(a));
    ASSERT_LE((error_in_ulp<Raw, F>(result, exact)), bound)
        << "atan(" << +a << "), " << F << " fraction bits, gave " << +result;
}

template <class Raw, int F>
void check_atan2(Raw y, Raw x) {
    using fixedpoint::portable::atan2_small;
    expect_atan2<Raw, F>(y, x, atan2_small<Raw, F>(y, x));
    expect_atan2<Raw, F>(y, x, fixedpoint::kernel::atan2<Raw, F>(y, x));
}

template <class Raw, int F>
void check_atan(Raw a) {
    using fixedpoint::portable::atan_small;
    expect_atan<Raw, F>(a, atan_small<Raw, F>(a));
    expect_atan<Raw, F>(a, fixedpoint::kernel::atan<Raw, F>(a));
}

template <class Raw, int F>
void check_boundaries_and_random(int samples, int stride) {
    const std::vector<Raw> values = boundaries<Raw>(stride);
    for (const Raw y : values) {
        check_atan<Raw, F>(y);
        for (const Raw x : values) check_atan2<Raw, F>(y, x);
    }
    std::mt19937_64 generator(F);
    for (int i = 0; i < samples; ++i) {
        const Raw y = random_raw<Raw>(generator), x = random_raw<Raw>(generator);
        check_atan2<Raw, F>(y, x);
        check_atan2<Raw, F>(static_cast<Raw>(generator()), static_cast<Raw>(generator()));
        check_atan<Raw, F>(y);
    }
}

template <int... F>
void check_all_of_8_bits(std::integer_sequence<int, F...>) {
    for (int y = -128; y < 128; ++y) {
        (check_atan<int8_t, F>(static_cast<int8_t>(y)), ...);
        for (int x = -128; x < 128; ++x) {
            (check_atan2<int8_t, F>(static_cast<int8_t>(y), static_cast<int8_t>(x)), ...);
        }
    }
}

template <int... F>
void check_all_of_atan_in_16_bits(std::integer_sequence<int, F...>) {
    for (int a = -32768; a < 32768; ++a) (check_atan<int16_t, F>(static_cast<int16_t>(a)), ...);
}

template <class Raw, int... F>
void check_every_split(std::integer_sequence<int, F...>, int samples, int stride) {
    (check_boundaries_and_random<Raw, F>(samples, stride), ...);
}

TEST(Atan2, EveryPairOfEverySplitOf8Bits) {
    check_all_of_8_bits(std::make_integer_sequence<int, 8>{});
}

TEST(Atan2, EverySplitOf16Bits) {
    check_every_split<int16_t>(std::make_integer_sequence<int, 16>{}, 10000, 1);
}

TEST(Atan2, EverySplitOf32Bits) {
    check_every_split<int32_t>(std::make_integer_sequence<int, 32>{}, 5000, 3);
}

TEST(Atan2, EverySplitOf64Bits) {
    check_every_split<int64_t>(std::make_integer_sequence<int, 64>{}, 40, 21);
}

TEST(Atan, EveryInputOfEverySplitOf16Bits) {
    check_all_of_atan_in_16_bits(std::make_integer_sequence<int, 16>{});
}

TEST(Atan2, Axes) {
    using fixedpoint::kernel::atan2;
    EXPECT_EQ((atan2<int32_t, 16>(0, 0)), 0);
    EXPECT_EQ((atan2<int32_t, 16>(0, 1)), 0);
    EXPECT_EQ((atan2<int32_t, 16>(0, -1)), 205887);
    EXPECT_EQ((atan2<int32_t, 16>(1, 0)), 102944);
    EXPECT_EQ((atan2<int32_t, 16>(-1, 0)), -102944);
    EXPECT_EQ((atan2<int16_t, 15>(0, -1)), 32767);
}

TEST(Atan2, IsAConstantExpression) {
    static_assert(fixedpoint::kernel::atan2<int32_t, 16>(65536, 65536) == 51472,
                  "The angle of (1, 1) is pi / 4.");
    static_assert(fixedpoint::kernel::atan<int64_t, 60>(int64_t(1) << 60) == 905502432259640355,
                  "The arc tangent of 1 is pi / 4.");
}

}  // namespace
