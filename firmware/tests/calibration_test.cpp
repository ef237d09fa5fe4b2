// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <firmware/calibration.hpp>

namespace firmware {
namespace {

using fixedpoint::Fixed;
using fixedpoint::Q16_16;

// The formula in the header's comment, in double, which every scalar approximates.
template <class Scalar>
double distance(double (*to_double)(Scalar)) {
    double worst = 0;
    for (int reading = 0; reading < 1024; ++reading)
        worst =
            std::max(worst, std::abs(to_double(grams<Scalar>(reading)) - grams<double>(reading)));
    return worst;
}

TEST(Calibration, EveryScalarAgrees) {
    EXPECT_LT(distance<Q16_16>([](Q16_16 x) { return x.raw() / 0x1p16; }), 0.1);
    using Wide = Fixed<24, 40>;
    EXPECT_LT(distance<Wide>([](Wide x) { return static_cast<double>(x.raw()) / 0x1p40; }), 1e-3);
    EXPECT_LT(distance<float>([](float x) { return static_cast<double>(x); }), 0.1);
}

TEST(Calibration, RisesWithinBoundsForEveryReading) {
    Q16_16 last = Q16_16::from_integer(0);
    for (int reading = -100; reading < 1200; ++reading) {
        const Q16_16 now = grams<Q16_16>(reading);
        EXPECT_GE(now, last) << reading;
        EXPECT_LE(now, Q16_16::from_integer(calibration::max_grams)) << reading;
        last = now;
    }
    EXPECT_GT(last, grams<Q16_16>(0));
    EXPECT_EQ(grams<Q16_16>(-1), grams<Q16_16>(0));
    EXPECT_EQ(grams<Q16_16>(5000), grams<Q16_16>(1023));
}

template <int sum_bits>
void expect_mean_of_readings() {
    double last = 0;
    for (int sum = 0; sum <= 1023 << sum_bits; ++sum) {
        const double now = grams<Q16_16, sum_bits>(sum).raw() / 0x1p16;
        EXPECT_NEAR(now, (grams<double, sum_bits>(sum)), 0.1) << sum;
        EXPECT_GE(now, last) << sum;
        last = now;
        if (sum % (1 << sum_bits) == 0) {
            EXPECT_NEAR(now, grams<double>(sum >> sum_bits), 0.1) << sum;
        }
    }
}

TEST(Calibration, ASumCountsAsTheMeanOfItsReadings) {
    expect_mean_of_readings<1>();
    expect_mean_of_readings<2>();
    expect_mean_of_readings<4>();
}

TEST(Calibration, ASumResolvesFractionsOfACount) {
    EXPECT_GT((grams<Q16_16, 1>(1801)), (grams<Q16_16, 1>(1800)));
    EXPECT_LT((grams<Q16_16, 1>(1801)), (grams<Q16_16, 1>(1802)));
}

}  // namespace
}  // namespace firmware
