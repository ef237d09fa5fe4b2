// SPDX-License-Identifier: MIT
// log and its small variant against long double and a wider binary float: all inputs of 8 and
// 16-bit formats, boundary and random operands elsewhere.
#include <gtest/gtest.h>

#include <cmath>
#include <fixedpoint/kernel/dispatch.hpp>
#include <limits>
#include <random>
#include <utility>

#include "function_accuracy.hpp"

namespace {

using fixedpoint::tests::boundaries;
using fixedpoint::tests::error_in_ulp;
using fixedpoint::tests::Exact;
using fixedpoint::tests::exact_value;
using fixedpoint::tests::random_raw;

constexpr double bound = 1;

template <class Raw, int F>
void expect_logarithm(Raw a, Raw result) {
    using std::log;
    if (a <= 0) {
        ASSERT_EQ(result, std::numeric_limits<Raw>::min()) << +a;
        return;
    }
    const Exact<Raw> exact = log(exact_value<Raw, F>(a));
    ASSERT_LE((error_in_ulp<Raw, F>(result, exact)), bound)
        << "log(" << +a << "), " << F << " fraction bits, gave " << +result;
}

template <class Raw, int F>
void check(Raw a) {
    expect_logarithm<Raw, F>(a, fixedpoint::kernel::log<Raw, F>(a));
    expect_logarithm<Raw, F>(a, fixedpoint::portable::log_small<Raw, F>(a));
}

template <class Raw, int... F>
void check_every_input(std::integer_sequence<int, F...>) {
    for (int a = std::numeric_limits<Raw>::min(); a <= std::numeric_limits<Raw>::max(); ++a) {
        (check<Raw, F>(static_cast<Raw>(a)), ...);
    }
}

template <class Raw, int F>
void check_boundaries_and_random(int samples, int stride) {
    for (const Raw a : boundaries<Raw>(stride)) check<Raw, F>(a);
    std::mt19937_64 generator(F);
    for (int i = 0; i < samples; ++i) {
        const Raw a = random_raw<Raw>(generator);
        check<Raw, F>(a);
        check<Raw, F>(fixedpoint::wrapping_negate(a));
    }
}

template <class Raw, int... F>
void check_every_split(std::integer_sequence<int, F...>, int samples, int stride) {
    (check_boundaries_and_random<Raw, F>(samples, stride), ...);
}

TEST(Logarithm, EveryInputOfEverySplitOf8Bits) {
    check_every_input<int8_t>(std::make_integer_sequence<int, 8>{});
}

TEST(Logarithm, EveryInputOfEverySplitOf16Bits) {
    check_every_input<int16_t>(std::make_integer_sequence<int, 16>{});
}

TEST(Logarithm, EverySplitOf32Bits) {
    check_every_split<int32_t>(std::make_integer_sequence<int, 32>{}, 5000, 1);
}

TEST(Logarithm, EverySplitOf64Bits) {
    check_every_split<int64_t>(std::make_integer_sequence<int, 64>{}, 20, 9);
}

// The format that has tables of its own: all interval limits.
TEST(Logarithm, EveryIntervalOfQ16_16) {
    std::mt19937_64 generator(16);
    for (int exponent = 0; exponent < 31; ++exponent) {
        for (int32_t interval = 128; interval < 256; ++interval) {
            const int64_t start = (int64_t(interval) << exponent) >> 7;
            const int64_t end = ((int64_t(interval) + 1) << exponent) >> 7;
            for (const int64_t offset : {int64_t(0), (end - start) / 2, end - start - 1}) {
                check<int32_t, 16>(static_cast<int32_t>(start + offset));
            }
        }
    }
}

TEST(Logarithm, ExactAtOneAndClamped) {
    using namespace fixedpoint;
    EXPECT_EQ((kernel::log<int32_t, 16>(65536)), 0);
    EXPECT_EQ((kernel::log<int8_t, 7>(1)), -128);
    EXPECT_EQ((kernel::log<int64_t, 62>(1)), std::numeric_limits<int64_t>::min());
    EXPECT_EQ((kernel::log<int32_t, 16>(0)), std::numeric_limits<int32_t>::min());
}

TEST(Logarithm, IsAConstantExpression) {
    using namespace fixedpoint;
    static_assert(kernel::log<int32_t, 16>(131072) == 45426, "ln 2 = 0.69315");
    static_assert(kernel::log<int64_t, 60>(int64_t(1) << 61) == 799144290325165979,
                  "ln 2 = 0.69315");
}

}  // namespace
