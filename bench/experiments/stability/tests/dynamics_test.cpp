// SPDX-License-Identifier: GPL-3.0-or-later
// Long motion, compared with closed forms: radii of maps with known eigenvalues; maps fitted to
// their runs; and double, whose rounding is negligible, with theory.
#include "bench/experiments/stability/dynamics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stability {
namespace {

TEST(SpectralRadius, IsTheLargestEigenvalues) {
    EXPECT_NEAR(spectral_radius({3, 0, 0, -4}, 2), 4, 1e-12);
    EXPECT_NEAR(spectral_radius({0.6, -0.8, 0.8, 0.6}, 2), 1, 1e-12);  // a rotation
    EXPECT_NEAR(spectral_radius({1, 5, 0, 0, 1, 7, 0, 0, 2}, 3), 2, 1e-12);
}

// Closed forms: explicit Euler sqrt(1 + (omega h)^2), symplectic methods 1 up to omega h = 2 and
// the larger root of z^2 - (2 - (omega h)^2) z + 1 beyond it, the implicit one 1 / sqrt(1 +
// (omega h)^2). With damping, the product of the eigenvalues is the determinant.
TEST(StepMap, HasTheRadiusOfItsMethod) {
    for (const double product : {0.1, 1.0, 1.9, 2.1, 3.0}) {
        const double h = 0.125, omega = product / h;
        const auto radius = [&](const char* method) {
            return spectral_radius(step_map(method, omega, 0, h), 2);
        };
        EXPECT_NEAR(radius("explicit_euler"), std::sqrt(1 + product * product), 1e-9);
        EXPECT_NEAR(radius("implicit_springs"), 1 / std::sqrt(1 + product * product), 1e-9);
        const double half_trace = std::abs(1 - product * product / 2);
        const double beyond = product < 2 ? 1 : half_trace + std::sqrt(half_trace * half_trace - 1);
        for (const char* symplectic : {"semi_implicit_euler", "velocity_verlet"})
            EXPECT_NEAR(radius(symplectic), beyond, 1e-9) << symplectic << ' ' << product;
    }
    EXPECT_THROW(step_map("no_such_method", 1, 0, 1), std::invalid_argument);
}

TEST(FittedMap, IsTheMapOfTheRun) {
    const std::vector<double> map = {0.9, 0.3, -0.4, 1.05};
    std::vector<std::vector<double>> states = {{1, 0.5}};
    for (int i = 0; i < 40; ++i) {
        const auto& y = states.back();
        states.push_back({map[0] * y[0] + map[1] * y[1], map[2] * y[0] + map[3] * y[1]});
    }
    const auto fitted = fitted_map(states);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(fitted[i], map[i], 1e-9) << i;
}

TEST(FittedMap, IsNoneWhereTheStatesDoNotDetermineIt) {
    EXPECT_TRUE(fitted_map({{1, 0}, {0.5, 0}, {0.25, 0}}).empty());
}

class InDouble : public testing::TestWithParam<Subject> {};

TEST_P(InDouble, GrowsAsInTheory) {
    for (const DynamicsRow& row : growth_of(GetParam())) {
        ASSERT_TRUE(row.measured.has_value()) << row.at;
        EXPECT_NEAR(*row.measured, *row.theory, 1e-7) << row.system << ' ' << row.at;
    }
}
TEST_P(InDouble, GainsTheEnergyOfItsMethod) {
    for (const DynamicsRow& row : energy_of(GetParam(), 10000)) {
        if (!row.theory) continue;
        ASSERT_TRUE(row.measured.has_value()) << row.system;
        // Windows and periods do not end together.
        EXPECT_NEAR(*row.measured, *row.theory, 0.02 * std::abs(*row.theory) + 2e-3)
            << row.system << ' ' << row.at;
    }
}
// Velocity Verlet is its own inverse with reversed velocities; a first-order method is not.
TEST_P(InDouble, ComesBackWhereTheMethodIsSymmetric) {
    for (const DynamicsRow& row : reversal_of(GetParam())) {
        if (row.system == "pendulum") continue;
        ASSERT_TRUE(row.measured.has_value());
        if (row.integrator == "velocity_verlet")
            EXPECT_LT(*row.measured, 1e-9) << row.system;
        else
            EXPECT_GT(*row.measured, 1e-4) << row.system << ' ' << row.integrator;
    }
}
INSTANTIATE_TEST_SUITE_P(Methods, InDouble, testing::ValuesIn(subjects_of_double()),
                         [](const auto& instance) { return instance.param.integrator; });

// Where round-to-nearest lets a damped spring rest, in every fixed-point format.
TEST(DeadBand, IsWithinItsBound) {
    for (const Subject& subject : subjects()) {
        const auto rows = dead_band_of(subject);
        EXPECT_EQ(rows[0].theory.has_value(), subject.ulp > 0 && subject.arithmetic != "published");
        if (!rows[0].theory) continue;
        ASSERT_TRUE(rows[0].measured.has_value()) << subject.scalar << ' ' << subject.integrator;
        EXPECT_LE(*rows[0].measured, *rows[0].theory)
            << subject.scalar << ' ' << subject.arithmetic << ' ' << subject.integrator;
    }
}

// The period of rounded products, by counting: from the right, around, and back.
TEST(RoundedPeriod, IsThatOfTheMapOfIntegers) {
    const auto counted = [](double k, double h, double start) {
        double x = start, v = 0;
        unsigned steps = 0;
        for (int half = 0; half < 2; ++half) do {
                v -= std::round(h * k * x);
                x += std::round(h * v);
                ++steps;
            } while (half == 0 ? v < 0 : v > 0);
        return steps;
    };
    for (const double k : {1.0, 4.0, 9.0})
        for (const double h : {1.0 / 64, 1.0 / 256})
            for (const double start : {300.0, 1000.0, 20000.0}) {
                // The largest velocity of that run.
                double x = start, v = 0, fastest = 0;
                for (unsigned step = 0; step < 10000; ++step) {
                    v -= std::round(h * k * x);
                    x += std::round(h * v);
                    fastest = std::max(fastest, std::abs(v));
                }
                const double period = rounded_period(k, h, fastest);
                EXPECT_NEAR(period, counted(k, h, start), 0.01 * period)
                    << k << ' ' << h << ' ' << start;
            }
    const double pi = 3.14159265358979323846;
    EXPECT_NEAR(rounded_period(4, 1.0 / 256, 1e7), pi * 256, 0.1);  // rounding is negligible
    EXPECT_EQ(rounded_period(4, 1.0 / 256, 127), 1);                // the way of a step rounds to 0
    // At 129 ulp it passes the 32 ulp on either side of the middle at one ulp a step, and is then
    // turned round by one ulp a step while it hardly moves.
    EXPECT_NEAR(rounded_period(4, 1.0 / 256, 129), 4 * (32 + 129), 0.01);
}

// Where every motion ends: at rest, or swinging for ever where rounding undoes the damping.
TEST(LimitCycle, HasThePeriodOfItsTheory) {
    unsigned swinging = 0;
    for (const Subject& subject : subjects()) {
        const DynamicsRow row = dead_band_of(subject)[1];
        if (!row.theory) {
            EXPECT_TRUE(subject.ulp == 0 || subject.arithmetic == "published") << subject.scalar;
            continue;
        }
        ASSERT_TRUE(row.measured.has_value()) << subject.scalar << ' ' << subject.integrator;
        if (*row.theory == 1) {
            EXPECT_EQ(*row.measured, 1) << subject.scalar << ' ' << subject.integrator;
        } else {
            EXPECT_EQ(subject.integrator, "implicit_springs");
            EXPECT_NEAR(*row.measured, *row.theory, 0.005 * *row.theory) << subject.scalar;
            ++swinging;
        }
    }
    EXPECT_EQ(swinging, 4u);  // Q16.16 in two arithmetics, Q8.24 and Q32.32; Q8.8 comes to rest
}

// Forces of springs are sums: their order changes only the rounding of the sums.
TEST(Order, OfSpringsDoesNotMatter) {
    for (const Subject& subject : subjects()) {
        if (subject.ulp == 0 || subject.integrator == "implicit_springs") continue;
        for (const DynamicsRow& row : order_of(subject))
            if (row.system == "chain of springs") {
                ASSERT_TRUE(row.measured.has_value()) << subject.scalar;
                EXPECT_EQ(*row.measured, 0) << subject.scalar << ' ' << subject.integrator;
            }
    }
}

// The mean of a sample, and its standard error.
struct Estimate {
    double mean, error;
};
Estimate estimate(const std::vector<double>& sample) {
    const double n = double(sample.size());
    double sum = 0, squares = 0;
    for (const double x : sample) sum += x;
    for (const double x : sample) squares += (x - sum / n) * (x - sum / n);
    return {sum / n, std::sqrt(squares / (n - 1) / n)};
}

// From runs of the engine and from the equations of motion: both show how fast neighbours separate,
// and so what a bit of resolution gains. A motion of a few seconds grows at its own rate: the mean
// over the starts must agree within three of its standard errors, which must distinguish it from no
// growth.
TEST(Divergence, IsByTheLyapunovExponent) {
    const double exponent = lyapunov_exponent(30);
    EXPECT_NEAR(exponent, lyapunov_exponent(60), 0.03 * exponent);
    const Divergence coarse = divergence(subject("q16_16", "nearest", "velocity_verlet")),
                     fine = divergence(subject("q32_32", "nearest", "velocity_verlet"));
    ASSERT_EQ(coarse.times.size(), chaotic_starts);
    ASSERT_EQ(fine.times.size(), chaotic_starts);
    ASSERT_EQ(fine.rates.size(), chaotic_starts);
    std::vector<double> bought;  // s, by a bit
    for (unsigned seed = 0; seed < chaotic_starts; ++seed)
        bought.push_back((fine.times[seed] - coarse.times[seed]) / 16);
    const Estimate rate = estimate(fine.rates), bit = estimate(bought);
    EXPECT_NEAR(rate.mean, exponent, 3 * rate.error);
    EXPECT_GT(rate.mean, 3 * rate.error);
    EXPECT_NEAR(bit.mean, std::log(2) / exponent, 3 * bit.error);
    EXPECT_GT(bit.mean, 3 * bit.error);
}

// The method's own run in double is the same run, and never leaves itself.
TEST(Divergence, OfTheRunFromItselfIsNone) {
    for (const DynamicsRow& row : divergence_of(subjects_of_double().front()))
        EXPECT_FALSE(row.measured.has_value());
}

}  // namespace
}  // namespace stability
