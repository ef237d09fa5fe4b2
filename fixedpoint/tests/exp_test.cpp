// SPDX-License-Identifier: MIT
// exp and its small variant against long double and a wider binary float: all inputs of 8 and
// 16-bit formats and all of Q16.16 that are not clamped; elsewhere boundary operands, and random
// ones of the range that is not clamped.
#include <gtest/gtest.h>

#include <algorithm>
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

constexpr double bound = 1;

template <class Raw, int F>
void expect_exponential(Raw a, Raw result) {
    using std::exp;
    // Beyond +-100 every format's result is clamped.
    const Exact<Raw> argument =
        std::clamp<Exact<Raw>>(exact_value<Raw, F>(a), Exact<Raw>(-100), Exact<Raw>(100));
    const Exact<Raw> exact = exp(argument);
    ASSERT_LE((error_in_ulp<Raw, F>(result, exact)), bound)
        << "exp(" << +a << "), " << F << " fraction bits, gave " << +result;
}

template <class Raw, int F>
void check(Raw a) {
    expect_exponential<Raw, F>(a, fixedpoint::kernel::exp<Raw, F>(a));
    expect_exponential<Raw, F>(a, fixedpoint::portable::exp_small<Raw, F>(a));
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
    // From underflow to overflow.
    const int width = fixedpoint::RawLimits<Raw>::width;
    const double low = std::max(-(F + 2) * M_LN2, -std::ldexp(1, width - 1 - F));
    const double high = std::min((width - F) * M_LN2, std::ldexp(0.999, width - 1 - F));
    std::mt19937_64 generator(F);
    std::uniform_real_distribution<double> argument(low, high);
    for (int i = 0; i < samples; ++i) {
        const Raw a = static_cast<Raw>(std::ldexp(argument(generator), F));
        check<Raw, F>(a);
        // Log-uniform towards 0.
        check<Raw, F>(static_cast<Raw>(a >> generator() % width));
    }
}

template <class Raw, int... F>
void check_every_split(std::integer_sequence<int, F...>, int samples, int stride) {
    (check_boundaries_and_random<Raw, F>(samples, stride), ...);
}

TEST(Exponential, EveryInputOfEverySplitOf8Bits) {
    check_every_input<int8_t>(std::make_integer_sequence<int, 8>{});
}

TEST(Exponential, EveryInputOfEverySplitOf16Bits) {
    check_every_input<int16_t>(std::make_integer_sequence<int, 16>{});
}

TEST(Exponential, EverySplitOf32Bits) {
    check_every_split<int32_t>(std::make_integer_sequence<int, 32>{}, 5000, 1);
}

TEST(Exponential, EverySplitOf64Bits) {
    check_every_split<int64_t>(std::make_integer_sequence<int, 64>{}, 20, 9);
}

// Beyond +-12 the result is 0 or the largest number, which the boundaries show.
TEST(Exponential, EveryInputOfQ16_16ThatIsNotClamped) {
    for (int32_t a = -12 * 65536; a < 12 * 65536; ++a) check<int32_t, 16>(a);
}

TEST(Exponential, ExactAtZeroAndClamped) {
    using namespace fixedpoint;
    EXPECT_EQ((kernel::exp<int32_t, 16>(0)), 65536);
    EXPECT_EQ((kernel::exp<int8_t, 7>(0)), 127);
    EXPECT_EQ((kernel::exp<int64_t, 63>(0)), std::numeric_limits<int64_t>::max());
    // ln 32768 = 681391.4 / 65536, -17 ln 2 = -772243.6 / 65536
    EXPECT_LT((kernel::exp<int32_t, 16>(681391)), std::numeric_limits<int32_t>::max());
    EXPECT_EQ((kernel::exp<int32_t, 16>(681392)), std::numeric_limits<int32_t>::max());
    EXPECT_EQ((kernel::exp<int32_t, 16>(-772243)), 1);
    EXPECT_EQ((kernel::exp<int32_t, 16>(-772244)), 0);
    EXPECT_EQ((kernel::exp<int32_t, 16>(std::numeric_limits<int32_t>::max())),
              std::numeric_limits<int32_t>::max());
    EXPECT_EQ((kernel::exp<int32_t, 16>(std::numeric_limits<int32_t>::min())), 0);
}

TEST(Exponential, IsAConstantExpression) {
    using namespace fixedpoint;
    static_assert(kernel::exp<int32_t, 16>(65536) == 178145, "e = 2.71828");
    static_assert(kernel::exp<int64_t, 60>(int64_t(1) << 60) == 3133965575612453543, "e = 2.71828");
}

}  // namespace
