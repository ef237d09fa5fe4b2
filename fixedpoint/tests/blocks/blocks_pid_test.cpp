// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <fixedpoint/blocks/pid.hpp>

#include "exact_sum.hpp"

using namespace fixedpoint;
using exact::number;
using exact::random_number;
using exact::value;

namespace {

template <class Number>
class Controller : public testing::Test {};
using Numbers = testing::Types<Q4_4, Q8_8, Q16_16, Fixed<8, 24>, Q32_32, Fixed<16, 16, Saturating>>;
TYPED_TEST_SUITE(Controller, Numbers);

// Two products and the carried integral: three roundings, however many steps.
TYPED_TEST(Controller, FollowsTheExactOne) {
    using Number = TypeParam;
    std::mt19937_64 random(1);
    const PidGains<Number> gains = {number<Number>(1.25L), number<Number>(.0625L),
                                    number<Number>(.5L)};
    Pid<Number> pid(gains, number<Number>(-7.5L), number<Number>(7.5L));
    long double integral = 0, last = 0;
    for (int i = 0; i < 10000; ++i) {
        const Number setpoint = random_number<Number>(random, .5);
        Number measurement = random_number<Number>(random, .5);
        if ((value(setpoint) > value(measurement)) == (integral > 0))
            measurement = Number::from_raw(setpoint.raw() + (integral > 0 ? 1 : -1));
        const long double error = value(setpoint) - value(measurement);
        integral += .0625L * error;
        const long double output =
            1.25L * error + integral - (i == 0 ? 0 : .5L * (value(measurement) - last));
        last = value(measurement);
        ASSERT_LE(std::abs(value(pid.update(setpoint, measurement)) - output),
                  1.5L * exact::ulp<Number>() + 1e-15L)
            << i;
    }
}
// An error whose contribution per step rounds to 0 still moves the output eventually.
TYPED_TEST(Controller, AddsUpWhatIsBelowAnUlp) {
    using Number = TypeParam;
    Pid<Number> pid({Number(), number<Number>(.0625L), Number()}, Number::min(), Number::max());
    Number output;
    for (int i = 0; i < 160; ++i) output = pid.update(Number::ulp(), Number());
    EXPECT_EQ(output.raw(), 10);
}
TYPED_TEST(Controller, LeavesALimitInTheStepInWhichTheErrorTurns) {
    using Number = TypeParam;
    const Number one = number<Number>(1);
    Pid<Number> pid({one, number<Number>(.5L), Number()}, -one, one);
    for (int i = 0; i < 1000; ++i)
        ASSERT_EQ(pid.update(number<Number>(2), Number()).raw(), one.raw());
    EXPECT_LT(value(pid.update(-one, Number())), 0.0L);
    for (int i = 0; i < 1000; ++i) pid.update(number<Number>(-2), Number());
    EXPECT_GT(value(pid.update(one, Number())), 0.0L);
}
TYPED_TEST(Controller, DoesNotDifferentiateTheSetpoint) {
    using Number = TypeParam;
    const Number one = number<Number>(1);
    Pid<Number> pid({Number(), Number(), one}, Number::min(), Number::max());
    EXPECT_EQ(pid.update(Number(), one).raw(), 0);  // nor the first measurement
    EXPECT_EQ(pid.update(one, one).raw(), 0);
    EXPECT_EQ(pid.update(one, one + Number::ulp()).raw(), -1);
}
// At the limits of the range nothing changes its sign, in any arithmetic.
TYPED_TEST(Controller, SaturatesAtTheEndsOfTheRange) {
    using Number = TypeParam;
    const Number gain = number<Number>(3);
    Pid<Number> pid({gain, gain, Number()}, Number::min(), Number::max());
    for (int i = 0; i < 10; ++i) {
        ASSERT_EQ(pid.update(Number::max(), Number::min()).raw(), Number::max().raw());
    }
    for (int i = 0; i < 10; ++i) {
        ASSERT_EQ(pid.update(Number::min(), Number::max()).raw(), Number::min().raw());
    }
}
TYPED_TEST(Controller, TakesTheLowerOfContradictingLimits) {
    using Number = TypeParam;
    Pid<Number> pid({number<Number>(1), Number(), Number()}, number<Number>(1), number<Number>(-1));
    for (const long double setpoint : {-3., 0., 3.})
        EXPECT_EQ(pid.update(number<Number>(setpoint), Number()).raw(), number<Number>(1).raw());
}

}  // namespace
