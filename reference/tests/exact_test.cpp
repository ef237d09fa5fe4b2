// SPDX-License-Identifier: GPL-3.0-or-later
// MPFR against GSL, and against values known to many digits.
#include "reference/exact.hpp"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <random>

namespace reference {
namespace {

double as_double(const Exact& exact) {
    return std::visit([](const auto& number) { return double(number); }, exact);
}

struct Region {
    Operation operation;
    double low, high;  // of each operand
};

class AgreesWithGsl : public testing::TestWithParam<Region> {};

TEST_P(AgreesWithGsl, OnRandomOperands) {
    const auto [operation, low, high] = GetParam();
    std::mt19937_64 random(1);
    for (int i = 0; i < 2000; ++i) {
        double operands[2];
        Rational exact_operands[2];
        const std::size_t count = shape(operation).operands;
        for (std::size_t k = 0; k < count; ++k) {
            operands[k] = low + (high - low) * std::ldexp(double(random() >> 11), -53);
            exact_operands[k] = Rational(operands[k]);
        }
        const double expected = as_double(exact(operation, std::span(exact_operands, count)));
        const auto opinion = second_opinion(operation, std::span(operands, count));
        ASSERT_TRUE(opinion.has_value());
        EXPECT_NEAR(*opinion, expected, 4e-15 * std::max(1.0, std::abs(expected)))
            << shape(operation).name << " at " << operands[0] << ", " << operands[1];
    }
}

INSTANTIATE_TEST_SUITE_P(
    Functions, AgreesWithGsl,
    testing::Values(Region{Operation::sqrt, 0, 32768}, Region{Operation::atan, -40, 40},
                    Region{Operation::atan2, -32768, 32768}, Region{Operation::sin, -20, 20},
                    Region{Operation::cos, -20, 20}, Region{Operation::exp, -12, 11},
                    Region{Operation::log, 1e-5, 32768}, Region{Operation::length2, -32768, 32768},
                    Region{Operation::tan, -1.5, 1.5}, Region{Operation::asin, -1, 1},
                    Region{Operation::acos, -1, 1}, Region{Operation::expm1, -12, 2},
                    Region{Operation::log1p, -0.9, 32768}, Region{Operation::sinh, -3, 3},
                    Region{Operation::cosh, -3, 3}, Region{Operation::tanh, -12, 12},
                    Region{Operation::pow, 0.01, 4}),
    [](const auto& region) { return std::string(shape(region.param.operation).name); });

TEST(Exact, KnownToManyDigits) {
    const auto distance = [](const Exact& exact, const char* digits) {
        return double(abs(std::get<Real>(exact) - Real(digits)));
    };
    const Rational one[] = {1}, two[] = {2}, quarter[] = {Rational(1, 4)};
    EXPECT_LT(distance(pi(), "3.14159265358979323846264338327950288419716939937510582097494459"),
              1e-60);
    EXPECT_LT(distance(exact(Operation::exp, one),
                       "2.71828182845904523536028747135266249775724709369995957496696763"),
              1e-60);
    EXPECT_LT(distance(exact(Operation::sqrt, two),
                       "1.41421356237309504880168872420969807856967187537694807317667974"),
              1e-60);
    EXPECT_LT(distance(exact(Operation::log, two),
                       "0.69314718055994530941723212145817656807550013436025525412068000"),
              1e-60);
    EXPECT_EQ(std::get<Real>(exact(Operation::reciprocal_sqrt, quarter)), 2);
}

TEST(Exact, AngleReductionHoldsFarOut) {
    // sin(2^31 - 2^-32), the largest angle of 64-bit formats, by the addition theorem from two
    // angles that MPFR reduces separately.
    const Rational whole[] = {scale(Rational(1), 31)}, ulp[] = {scale(Rational(1), -32)};
    const Rational angle[] = {whole[0] - ulp[0]};
    const auto real = [](const Exact& exact) { return std::get<Real>(exact); };
    const Real expected = real(exact(Operation::sin, whole)) * real(exact(Operation::cos, ulp)) -
                          real(exact(Operation::cos, whole)) * real(exact(Operation::sin, ulp));
    EXPECT_LT(double(abs(real(exact(Operation::sin, angle)) - expected)), 1e-80);
}

TEST(Exact, RationalOperations) {
    const auto rational = [](Operation operation, std::initializer_list<Rational> operands) {
        return std::get<Rational>(exact(operation, std::span(operands.begin(), operands.size())));
    };
    EXPECT_EQ(rational(Operation::remainder, {Rational(-7, 2), Rational(3, 2)}), Rational(-1, 2));
    EXPECT_EQ(rational(Operation::remainder, {Rational(7, 2), Rational(-3, 2)}), Rational(1, 2));
    EXPECT_EQ(rational(Operation::dot3, {1, 2, 3, 4, 5, Rational(1, 2)}), Rational(31, 2));
    EXPECT_EQ(rational(Operation::multiply_add, {2, 3, Rational(1, 8)}), Rational(49, 8));
    EXPECT_EQ(rational(Operation::shift_right, {3, 2}), Rational(3, 4));
}

TEST(ExactNumber, ValuesAndResolution) {
    EXPECT_EQ(value(q16_16, q16_16.max()), Rational(2147483647) / 65536);
    EXPECT_EQ(ulp(q16_16), Rational(1) / 65536);
    EXPECT_EQ(double(value(ieee_single, ieee_single.max())), FLT_MAX);
    for (float number : {0.1f, -1.0f, FLT_MAX, FLT_MIN, FLT_TRUE_MIN, 3 * FLT_TRUE_MIN, 0.0f}) {
        EXPECT_EQ(double(value(ieee_single, raw_of_float(number))), double(number));
        EXPECT_EQ(nearest_raw(ieee_single, value(ieee_single, raw_of_float(number))),
                  raw_of_float(number));
    }
    EXPECT_EQ(ulp(ieee_single, 1), scale(Rational(1), -23));
    EXPECT_EQ(ulp(ieee_single, Rational(99, 100)), scale(Rational(1), -24));
    EXPECT_EQ(ulp(ieee_single, 0), scale(Rational(1), -149));
    for (double number : {0.1, -1.0, DBL_MAX, DBL_MIN, DBL_TRUE_MIN, 3 * DBL_TRUE_MIN, 0.0}) {
        const std::int64_t raw = raw_of_double(ieee_double, number);
        EXPECT_EQ(double(value(ieee_double, raw)), number);
        EXPECT_EQ(nearest_raw(ieee_double, value(ieee_double, raw)), raw);
    }
    EXPECT_EQ(ulp(ieee_double, 1), scale(Rational(1), -52));
    EXPECT_EQ(ulp(ieee_double, 0), scale(Rational(1), -1074));
}

TEST(ExactNumber, NearestRawBreaksTies) {
    EXPECT_EQ(nearest_raw(q4_4, Rational(1, 32)), 1);   // a tie: half up
    EXPECT_EQ(nearest_raw(q4_4, Rational(-1, 32)), 0);  // a negative tie: half up
    EXPECT_EQ(nearest_raw(q4_4, 1000), 127);
    EXPECT_EQ(nearest_raw(q4_4, -1000), -128);
    EXPECT_EQ(nearest_raw(ieee_single, 16777217), raw_of_float(16777216));  // tie to even, down
    EXPECT_EQ(nearest_raw(ieee_single, 16777219), raw_of_float(16777220));  // tie to even, up
    EXPECT_EQ(nearest_raw(ieee_single, Rational(33554431) / 2), raw_of_float(16777216));
    EXPECT_EQ(nearest_raw(ieee_single, Rational(-1, 10)), raw_of_float(-0.1f));
}

TEST(Numbers, FloorAndBinade) {
    EXPECT_EQ(floor(Rational(-1, 3)), -1);
    EXPECT_EQ(floor(Rational(7, 3)), 2);
    EXPECT_EQ(floor(Rational(-4)), -4);
    EXPECT_EQ(floor(Real("-0.25")), -1);
    for (int exponent : {-149, -1, 0, 1, 127}) {
        const Rational power = scale(Rational(1), exponent);
        EXPECT_EQ(binade(power), exponent);
        EXPECT_EQ(binade(-power * Rational(2999, 3000)), exponent - 1);
        EXPECT_EQ(binade(to_real(power)), exponent);
        EXPECT_EQ(binade(Real(-to_real(power) * Real("0.999"))), exponent - 1);
    }
}

}  // namespace
}  // namespace reference
