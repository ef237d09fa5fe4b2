// SPDX-License-Identifier: MIT
// sin, cos and sincos against long double and a wider binary float: all inputs of 8 and 16-bit
// formats, boundary and random operands, and multiples of pi/2 elsewhere.
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

constexpr double bound = 0.75;

template <class Raw, int F>
void expect_sine_and_cosine(Raw angle, Raw sine, Raw cosine) {
    using std::cos;
    using std::sin;
    const Exact<Raw> radians = exact_value<Raw, F>(angle);
    const Exact<Raw> exact_sine = sin(radians), exact_cosine = cos(radians);
    ASSERT_LE((error_in_ulp<Raw, F>(sine, exact_sine)), bound)
        << "sin(" << +angle << "), " << F << " fraction bits, gave " << +sine;
    ASSERT_LE((error_in_ulp<Raw, F>(cosine, exact_cosine)), bound)
        << "cos(" << +angle << "), " << F << " fraction bits, gave " << +cosine;
    if (F < fixedpoint::RawLimits<Raw>::width - 1) {
        const Raw one = static_cast<Raw>(Raw(1) << (F % (fixedpoint::RawLimits<Raw>::width - 1)));
        ASSERT_TRUE(-one <= sine && sine <= one && -one <= cosine && cosine <= one)
            << "beyond 1 at " << +angle << ", " << F << " fraction bits";
    }
}

template <class Raw, int F>
void check(Raw angle) {
    using namespace fixedpoint;
    const Raw sine = kernel::sin<Raw, F>(angle), cosine = kernel::cos<Raw, F>(angle);
    expect_sine_and_cosine<Raw, F>(angle, sine, cosine);
    Raw both[2] = {};
    kernel::sincos<Raw, F>(angle, both);
    ASSERT_EQ(both[0], sine) << +angle;
    ASSERT_EQ(both[1], cosine) << +angle;
}

template <class Raw, int... F>
void check_every_input(std::integer_sequence<int, F...>) {
    for (int angle = std::numeric_limits<Raw>::min(); angle <= std::numeric_limits<Raw>::max();
         ++angle) {
        (check<Raw, F>(static_cast<Raw>(angle)), ...);
    }
}

template <class Raw, int F>
void check_boundaries_and_random(int samples, int stride) {
    using std::ldexp;
    using std::trunc;
    for (const Raw angle : boundaries<Raw>(stride)) check<Raw, F>(angle);
    std::mt19937_64 generator(F);
    for (int i = 0; i < samples; ++i) {
        check<Raw, F>(random_raw<Raw>(generator));
        const Raw angle = static_cast<Raw>(generator());
        check<Raw, F>(angle);
        // A multiple of pi/2 next to it.
        using std::acos;
        const Exact<Raw> quarter = ldexp(acos(Exact<Raw>(0)), F);
        const Exact<Raw> multiple = trunc(Exact<Raw>(angle) / quarter) * quarter;
        check<Raw, F>(static_cast<Raw>(multiple));
    }
}

template <class Raw, int... F>
void check_every_split(std::integer_sequence<int, F...>, int samples, int stride) {
    (check_boundaries_and_random<Raw, F>(samples, stride), ...);
}

TEST(Sine, EveryInputOfEverySplitOf8Bits) {
    check_every_input<int8_t>(std::make_integer_sequence<int, 8>{});
}

TEST(Sine, EveryInputOfEverySplitOf16Bits) {
    check_every_input<int16_t>(std::make_integer_sequence<int, 16>{});
}

TEST(Sine, EverySplitOf32Bits) {
    check_every_split<int32_t>(std::make_integer_sequence<int, 32>{}, 5000, 1);
}

TEST(Sine, EverySplitOf64Bits) {
    check_every_split<int64_t>(std::make_integer_sequence<int, 64>{}, 20, 9);
}

// The small variant of the format that has tables of its own.
TEST(Sine, SmallVariantOfQ16_16) {
    using namespace fixedpoint;
    std::mt19937_64 generator(16);
    for (int i = 0; i < 100000; ++i) {
        const int32_t angle = random_raw<int32_t>(generator);
        int32_t both[2] = {};
        portable::sincos_small<int32_t, 16>(angle, both);
        expect_sine_and_cosine<int32_t, 16>(angle, both[0], both[1]);
        ASSERT_EQ((portable::sin_small<int32_t, 16>(angle)), both[0]);
        ASSERT_EQ((portable::cos_small<int32_t, 16>(angle)), both[1]);
    }
}

TEST(Sine, ExactAtZeroAndClampedAtOne) {
    using namespace fixedpoint;
    EXPECT_EQ((kernel::sin<int32_t, 16>(0)), 0);
    EXPECT_EQ((kernel::cos<int32_t, 16>(0)), 65536);
    EXPECT_EQ((kernel::cos<int16_t, 15>(0)), 32767);
    EXPECT_EQ((kernel::sin<int8_t, 4>(0)), 0);
    EXPECT_EQ((kernel::cos<int64_t, 63>(0)), std::numeric_limits<int64_t>::max());
}

TEST(Sine, IsAConstantExpression) {
    using namespace fixedpoint;
    static_assert(kernel::sin<int32_t, 16>(65536) == 55147, "sin(1) = 0.84147");
    static_assert(kernel::cos<int64_t, 60>(int64_t(1) << 60) == 622926147424044489,
                  "cos(1) = 0.54030");
}

}  // namespace
