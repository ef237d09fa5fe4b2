// SPDX-License-Identifier: MIT
// The functions of Q32.32, which have kernels of their own, against functions of 113 bits: a
// million operands each, or a tenth of that for compositions, including those near the interval
// limits of the tables. The exact values of accuracy_test would take an hour for as many.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <fixedpoint/angle.hpp>
#include <fixedpoint/arithmetic/nearest.hpp>
#include <fixedpoint/fixed.hpp>
#include <fixedpoint/portable/atan.hpp>
#include <fixedpoint/portable/cbrt_q32_32.hpp>
#include <fixedpoint/portable/exp.hpp>
#include <fixedpoint/portable/log.hpp>
#include <fixedpoint/portable/reciprocal_sqrt.hpp>
#include <fixedpoint/portable/sin.hpp>
#include <ostream>
#include <random>
#include <string>

#include "exact.hpp"

namespace {

namespace portable = fixedpoint::portable;
__extension__ typedef __float128 Real;

extern "C" {
Real sinf128(Real) noexcept;
Real cosf128(Real) noexcept;
Real logf128(Real) noexcept;
Real expf128(Real) noexcept;
Real sqrtf128(Real) noexcept;
Real atan2f128(Real, Real) noexcept;
Real exp2f128(Real) noexcept;
Real expm1f128(Real) noexcept;
Real log2f128(Real) noexcept;
Real log10f128(Real) noexcept;
Real sinhf128(Real) noexcept;
Real coshf128(Real) noexcept;
Real tanhf128(Real) noexcept;
Real tanf128(Real) noexcept;
Real cbrtf128(Real) noexcept;
Real powf128(Real, Real) noexcept;
}

constexpr Real one = Real(int64_t(1) << 32);
constexpr int64_t largest = fixedpoint::RawLimits<int64_t>::max;

// Under a sanitizer the first part of the operands is enough, and it need not include the pinned
// one.
void expect_pinned(double worst, double largest_error, const std::string& witness) {
    EXPECT_LE(worst, 0.65);
    EXPECT_LE(worst, largest_error + 1e-6) << witness;
    if (exact::operand_step == 1) {
        EXPECT_GE(worst, largest_error - 1e-6) << witness;
    }
}

struct Function {
    const char* name;
    int64_t (*compute)(int64_t a, int64_t b);
    Real (*exact)(Real a, Real b);  // NaN outside the domain
    // An operand at the limit of two intervals of a table. index must be in 0..2047, scale in
    // 0..61.
    double (*limit)(int index, int scale);
    double largest_error;
    int operands = 1'000'000;
};
void PrintTo(const Function& function, std::ostream* stream) { *stream << function.name; }

class Operands {
  public:
    explicit Operands(const Function& function) : function_(function) {}
    std::array<int64_t, 2> next() {
        const int64_t a = number(), b = number();
        switch (random_() % 8) {
            case 0:
                return {a, near(a)};
            case 1:
                return {a, wrapping(0 - static_cast<uint64_t>(near(a)))};
            case 2:  // the ratio near an interval limit of the arc tangent table
                return {near(static_cast<int64_t>(std::ldexp(double(a), -8) *
                                                  double(random_() % 513) * 0.5)),
                        a};
            default:
                return {a, b};
        }
    }

  private:
    int64_t near(int64_t a) { return wrapping(static_cast<uint64_t>(a) + random_() % 5 - 2); }
    static int64_t wrapping(uint64_t a) { return static_cast<int64_t>(a); }
    uint64_t power() { return uint64_t(1) << random_() % 64; }
    int64_t number() {
        switch (random_() % 5) {
            case 0:
                return wrapping(random_());
            case 1:  // long runs of equal bits make long carries
                return wrapping((power() - power()) ^ (power() - power()));
            case 2:
                return wrapping(random_()) >> random_() % 64;
            case 3:
                return wrapping(random_()) >> (24 + random_() % 8);
            default: {  // in separate statements: the order of evaluation of arguments is
                        // unspecified
                const int scale = static_cast<int>(random_() % 62);
                const int index = static_cast<int>(random_() % 2048);
                return near(static_cast<int64_t>(function_.limit(index, scale)));
            }
        }
    }

    const Function& function_;
    std::mt19937_64 random_{64};
};

// 2^scale (1 + index / 256).
double limit_of_mantissa(int index, int scale) {
    return std::floor(std::ldexp(256 + index % 256, scale - 8));
}
double limit_of_angle(int index, int) { return std::ldexp((index - 1024) * (M_PI / 512), 32); }
// Whole quarter turns and, on either side, a limit between two tangents of the table, or where
// another formula begins.
double limit_of_tangent(int index, int scale) {
    const double rest = index < 1024         ? (index / 2 % 202 + 0.5) / 256
                        : index / 2 % 2 == 0 ? 3.0 / 16
                                             : 1.0 / 1024;
    return std::ldexp(scale * M_PI_2 + (index % 2 == 0 ? rest : -rest), 32);
}
double limit_of_binary_exponent(int index, int scale) {
    return std::ldexp((scale - 31) - index / 256.0 / M_LN2 / (index % 2 == 0 ? 1 : 256), 32);
}
// Where the power of two or the table entry changes.
double limit_of_exponent(int index, int scale) {
    return std::ldexp((scale - 31) * M_LN2 - index / 256.0 / (index % 2 == 0 ? 1 : 256), 32);
}

#define ELEMENTARY(name, limit, largest_error)                                         \
    Function {                                                                         \
#name, [](int64_t a, int64_t) { return fixedpoint::Nearest::name<int64_t, 32>(a); }, \
            [](Real a, Real) { return name##f128(a); }, limit, largest_error, 100'000 \
    }

class Functions : public testing::TestWithParam<Function> {};

TEST_P(Functions, AreAsFarFromTheExactValueAsPinned) {
    const Function& function = GetParam();
    Operands operands(function);
    double worst = 0;
    std::array<int64_t, 2> witness{};
    for (int i = 0; i < function.operands / exact::operand_step; ++i) {
        const auto [a, b] = operands.next();
        const int64_t result = function.compute(a, b);
        const Real exact = function.exact(Real(a) / one, Real(b) / one) * one;
        if (!(exact - exact == 0) && !(exact > 0)) continue;
        if (exact >= Real(largest)) {
            ASSERT_EQ(result, largest) << a;
            continue;
        }
        if (exact <= -Real(largest) - 1) {
            ASSERT_EQ(result, -largest - 1) << a;
            continue;
        }
        const Real difference = Real(result) - exact;
        const double error = static_cast<double>(difference < 0 ? -difference : difference);
        if (error > worst) {
            worst = error;
            witness = {a, b};
        }
    }
    expect_pinned(worst, function.largest_error, testing::PrintToString(witness));
}

INSTANTIATE_TEST_SUITE_P(
    Q32_32, Functions,
    testing::Values(
        Function{"sin", [](int64_t a, int64_t) { return portable::sin<int64_t, 32>(a); },
                 [](Real a, Real) { return sinf128(a); }, limit_of_angle, 0.593366918},
        Function{"cos", [](int64_t a, int64_t) { return portable::cos<int64_t, 32>(a); },
                 [](Real a, Real) { return cosf128(a); }, limit_of_angle, 0.599344885},
        Function{"log", [](int64_t a, int64_t) { return portable::log<int64_t, 32>(a); },
                 [](Real a, Real) { return a > 0 ? logf128(a) : Real(NAN); }, limit_of_mantissa,
                 0.574785126},
        Function{"exp", [](int64_t a, int64_t) { return portable::exp<int64_t, 32>(a); },
                 [](Real a, Real) { return expf128(a); }, limit_of_exponent, 0.566566007},
        Function{"reciprocal_sqrt",
                 [](int64_t a, int64_t) { return portable::reciprocal_sqrt<int64_t, 32>(a); },
                 [](Real a, Real) { return a > 0 ? 1 / sqrtf128(a) : Real(NAN); },
                 limit_of_mantissa, 0.505873612},
        Function{"atan", [](int64_t a, int64_t) { return portable::atan<int64_t, 32>(a); },
                 [](Real a, Real) { return atan2f128(a, 1); }, limit_of_mantissa, 0.609189862},
        Function{"atan2", [](int64_t a, int64_t b) { return portable::atan2<int64_t, 32>(a, b); },
                 [](Real a, Real b) { return a == 0 && b == 0 ? Real(NAN) : atan2f128(a, b); },
                 limit_of_mantissa, 0.613605122},
        Function{"cbrt", [](int64_t a, int64_t) { return portable::cbrt<int64_t, 32>(a); },
                 [](Real a, Real) { return cbrtf128(a); }, limit_of_mantissa, 0.520655115},
        Function{"atan2_turns",
                 [](int64_t a, int64_t b) {
                     using fixedpoint::Q32_32;
                     return atan2_turns(Q32_32::from_raw(a), Q32_32::from_raw(b)).raw();
                 },
                 [](Real a, Real b) {
                     return a == 0 && b == 0 ? Real(NAN) : atan2f128(a, b) / (8 * atan2f128(1, 1));
                 },
                 limit_of_mantissa, 0.594721582, 100'000},
        Function{"atan2_degrees",
                 [](int64_t a, int64_t b) {
                     using fixedpoint::Q32_32;
                     return atan2_degrees(Q32_32::from_raw(a), Q32_32::from_raw(b)).raw();
                 },
                 [](Real a, Real b) {
                     return a == 0 && b == 0 ? Real(NAN) : atan2f128(a, b) * (45 / atan2f128(1, 1));
                 },
                 limit_of_mantissa, 0.506224, 100'000},
        ELEMENTARY(exp2, limit_of_binary_exponent, 0.530613079),
        ELEMENTARY(expm1, limit_of_exponent, 0.539775498),
        ELEMENTARY(sinh, limit_of_exponent, 0.537319023),
        ELEMENTARY(cosh, limit_of_exponent, 0.544508369),
        ELEMENTARY(tanh, limit_of_exponent, 0.507392960),
        ELEMENTARY(log2, limit_of_mantissa, 0.603063223),
        ELEMENTARY(log10, limit_of_mantissa, 0.531129597),
        ELEMENTARY(tan, limit_of_tangent, 0.587265)),
    [](const auto& function) { return std::string(function.param.name); });

// Bases near 1, near the interval limits of the first factor, and anywhere, each with an exponent
// that gives powers of every magnitude or in the highest octaves.
TEST(Pow, IsAsFarFromTheExactValueAsPinned) {
    std::mt19937_64 random(64);
    double worst = 0;
    std::array<int64_t, 2> witness{};
    for (int i = 0; i < 300'000 / exact::operand_step; ++i) {
        const uint64_t digits = random() >> random() % 62, beside = digits >> (36 + random() % 28);
        uint64_t a = digits;
        if (i % 4 == 1) a = (uint64_t(1) << 32) + beside;
        if (i % 4 == 2) a = (uint64_t(1) << 32) - beside;
        if (i % 4 == 3) a = ((64 + random() % 64) << 56 >> random() % 62) + random() % 5 - 2;
        const Real logarithm = logf128(Real(a) / one);
        if (a == 0 || logarithm == 0) continue;
        const Real place = static_cast<Real>(random() >> 11) / (int64_t(1) << 53);
        const Real exponent = (i / 4 % 2 == 0 ? 22 - place : 45 * place - 23) / logarithm * one;
        const Real limit = Real(largest);
        const auto b = static_cast<int64_t>(exponent > limit    ? limit
                                            : exponent < -limit ? -limit
                                                                : exponent);
        const auto power = static_cast<uint64_t>(
            portable::pow_unsaturated<int64_t, 32>(static_cast<int64_t>(a), b));
        const Real exact = powf128(Real(a) / one, Real(b) / one) * one;
        if (exact >= Real(largest) + 1) {
            ASSERT_GT(power, uint64_t(largest)) << a << " " << b;
            continue;
        }
        const Real difference = Real(power) - exact;
        const double error = static_cast<double>(difference < 0 ? -difference : difference);
        if (error > worst) {
            worst = error;
            witness = {static_cast<int64_t>(a), b};
        }
    }
    expect_pinned(worst, 0.594226753, testing::PrintToString(witness));
}

// A power that is a number of the format is that number; at the limits of the format it saturates.
TEST(Pow, IsExactWhereTheFormatHoldsIt) {
    const auto pow = [](int64_t a, int64_t b) {
        return fixedpoint::Nearest::pow<int64_t, 32>(a, b);
    };
    constexpr int64_t unit = int64_t(1) << 32;
    std::mt19937_64 random(5);
    for (int i = 0; i < 20'000; ++i) {
        const int64_t a = static_cast<int64_t>(random() >> (1 + random() % 62));
        EXPECT_EQ(pow(a, unit), a);
        EXPECT_EQ(pow(-a, unit), -a);
        EXPECT_EQ(pow(a, 0), unit);
        EXPECT_EQ(pow(unit, a), unit);
        EXPECT_EQ(pow(unit, -a), unit);
        EXPECT_EQ(pow(-unit, a >> 32 << 32), (a >> 32) % 2 == 0 ? unit : -unit);
        const int64_t root = a >> 33 << 17, square = (a >> 33) * (a >> 33) << 2;
        EXPECT_EQ(pow(root, 2 * unit), square);
        EXPECT_EQ(pow(square, unit / 2), root);
    }
    for (int64_t n = -32; n < 31; ++n) {
        const int64_t power = int64_t(1) << (32 + n);
        EXPECT_EQ(pow(2 * unit, n * unit), power);
        EXPECT_EQ(pow(unit / 2, -n * unit), power);
        EXPECT_EQ(pow(-2 * unit, n * unit), n % 2 == 0 ? power : -power);
    }
    EXPECT_EQ(pow(2 * unit, 31 * unit), largest);
    EXPECT_EQ(pow(-2 * unit, 31 * unit), INT64_MIN);
    EXPECT_EQ(pow(-2 * unit, 33 * unit), INT64_MIN);
    EXPECT_EQ(pow(INT64_MIN, unit), INT64_MIN);
    EXPECT_EQ(pow(INT64_MIN, 2 * unit), largest);
    EXPECT_EQ(pow(INT64_MIN, INT64_MIN), 0);
    EXPECT_EQ(pow(1, INT64_MIN), largest);
    EXPECT_EQ(pow(1, INT64_MAX), 0);
    EXPECT_EQ(pow(unit + 1, INT64_MAX), 7081203937);
}

// Near a pole, for small and for arbitrary angles, with tangents of every magnitude and out of
// range.
TEST(Tan, IsAsFarFromTheExactValueAsPinnedBesidePoles) {
    std::mt19937_64 random(11);
    const Real half_pi = 2 * atan2f128(1, 1), limit = Real(largest);
    double worst = 0;
    int64_t witness = 0;
    for (int i = 0; i < 200'000 / exact::operand_step; ++i) {
        const unsigned smaller = 34 + random() % 30;
        const uint64_t quarters = (random() >> smaller) | 1;
        const int nearer = 53 + int(random() % 34);
        const double distance = std::ldexp(double(random() >> 11), -nearer);
        const Real angle = (half_pi * static_cast<Real>(quarters) +
                            static_cast<Real>(i % 2 == 0 ? distance : -distance)) *
                           one;
        if (angle >= limit) continue;
        const auto positive = static_cast<int64_t>(angle);
        const int64_t a = i % 4 < 2 ? positive : -positive;
        const int64_t tangent = fixedpoint::Nearest::tan<int64_t, 32>(a);
        const Real exact = tanf128(Real(a) / one) * one;
        if (exact > limit || exact < -limit - 1) {
            ASSERT_EQ(tangent, exact > 0 ? largest : INT64_MIN) << a;
            continue;
        }
        const Real difference = Real(tangent) - exact;
        const double error = static_cast<double>(difference < 0 ? -difference : difference);
        if (error > worst) {
            worst = error;
            witness = a;
        }
    }
    expect_pinned(worst, 0.625557042, std::to_string(witness));
}

// The last operand of a composition and the first beyond it: 31 and 32 ln 2, 34 ln 2 / 2, poles.
TEST(Limits, LieWhereResultsLeaveTheRange) {
    using fixedpoint::Nearest;
    const auto expm1 = [](int64_t a) { return Nearest::expm1<int64_t, 32>(a); };
    EXPECT_EQ(expm1(92288378627), 9223372033833837081);
    EXPECT_EQ(expm1(92288378628), 9223372035981320730);
    EXPECT_EQ(expm1(92288378629), largest);
    EXPECT_EQ(expm1(INT64_MIN), -(int64_t(1) << 32));
    const auto exp2 = [](int64_t a) { return Nearest::exp2<int64_t, 32>(a); };
    for (int n = -32; n < 31; ++n) EXPECT_EQ(exp2(n * (int64_t(1) << 32)), int64_t(1) << (32 + n));
    EXPECT_EQ(exp2((int64_t(31) << 32) - 1), 9223372035366253572);
    EXPECT_EQ(exp2(int64_t(31) << 32), largest);
    EXPECT_EQ(exp2(-(int64_t(33) << 32) + 1000), 1);
    EXPECT_EQ(exp2(-(int64_t(33) << 32) - 1), 0);
    for (const int64_t sign : {1, -1}) {
        EXPECT_EQ((Nearest::sinh<int64_t, 32>(sign * 95265423099)), sign > 0 ? largest : INT64_MIN);
        EXPECT_LT((std::abs(Nearest::sinh<int64_t, 32>(sign * 95265423098))), largest);
        EXPECT_EQ((Nearest::cosh<int64_t, 32>(sign * 95265423099)), largest);
        EXPECT_EQ((Nearest::tanh<int64_t, 32>(sign * 50609756021)), sign << 32);
        EXPECT_EQ((Nearest::tanh<int64_t, 32>(sign * 50609756020)), sign * 0xffffffff);
    }
    for (int n = 0; n < 31; ++n) {
        EXPECT_EQ((Nearest::log2<int64_t, 32>(int64_t(1) << (32 + n))), int64_t(n) << 32);
    }
    for (int64_t n = 1; n < 1290; ++n) {
        EXPECT_EQ((Nearest::cbrt<int64_t, 32>(n * n * n << 32)), n << 32);
    }
    EXPECT_EQ((Nearest::cbrt<int64_t, 32>(INT64_MIN)), -5541191377757);
}

}  // namespace
