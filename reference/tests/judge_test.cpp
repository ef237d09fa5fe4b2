// SPDX-License-Identifier: GPL-3.0-or-later
// Every row is worked out by hand.
#include "reference/judge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

namespace reference {
namespace {

using Raws = std::vector<std::int64_t>;

constexpr std::int64_t max16 = INT16_MAX, min16 = INT16_MIN, max32 = INT32_MAX, min32 = INT32_MIN;
constexpr std::int64_t one = 65536;  // 1 in q16_16

Judgement judged(Operation operation, const char* format, Arithmetic arithmetic,
                 const Raws& operands, const Raws& results) {
    return judge({operation, parse_format(format), arithmetic}, operands, results);
}

struct Row {
    Operation operation;
    const char* format;
    Arithmetic arithmetic;
    Raws operands;
    std::int64_t result;  // what the definition requires
    double error_ulp;     // of that result
    bool defined;
    const char* what;
};

void PrintTo(const Row& row, std::ostream* out) {
    *out << shape(row.operation).name << " " << row.format << ": " << row.what;
}

TEST(Judge, ReportsWhereAFunctionUnderflows) {
    // exp(x) 2^16 = 1/2 at x = -17 ln 2, raw -772243.6.
    const auto underflows = [](Operation operation, std::int64_t operand) {
        return judged(operation, "q16_16", Arithmetic::nearest, {operand}, {0}).underflow;
    };
    EXPECT_FALSE(underflows(Operation::exp, -772243));
    EXPECT_TRUE(underflows(Operation::exp, -772244));
    EXPECT_TRUE(underflows(Operation::exp, min32));
    EXPECT_FALSE(underflows(Operation::exp, 0));
    EXPECT_FALSE(underflows(Operation::sin, 1));
    // A product below half an ulp is rounded like any other.
    EXPECT_FALSE(judged(Operation::multiply, "q16_16", Arithmetic::nearest, {1, 1}, {0}).underflow);
}

class DefinedResult : public testing::TestWithParam<Row> {};

TEST_P(DefinedResult, AloneIsAccepted) {
    const Row& row = GetParam();
    const Judgement right =
        judged(row.operation, row.format, row.arithmetic, row.operands, {row.result});
    EXPECT_TRUE(right.as_defined);
    EXPECT_EQ(right.defined, row.defined);
    EXPECT_NEAR(right.error_ulp, row.error_ulp, 1e-4);
    EXPECT_EQ(right.excluded, nullptr);
    if (definition(row.operation, row.arithmetic).rounding == Rounding::within_bound &&
        !row.defined)
        return;
    const NumberFormat format = parse_format(row.format);
    for (const std::int64_t step : {-1, 1}) {
        const std::int64_t neighbour =
            format.extend(std::uint64_t(row.result) + std::uint64_t(step));
        const Judgement wrong =
            judged(row.operation, row.format, row.arithmetic, row.operands, {neighbour});
        EXPECT_FALSE(wrong.as_defined) << "neighbour " << neighbour;
    }
}

constexpr auto toward_zero = Arithmetic::toward_zero, downward = Arithmetic::downward,
               half_to_even = Arithmetic::half_to_even;
constexpr auto nearest = Arithmetic::nearest;
constexpr auto published = Arithmetic::published;
constexpr auto saturating = Arithmetic::saturating;
constexpr auto integer = Arithmetic::integer;

INSTANTIATE_TEST_SUITE_P(
    Ring, DefinedResult,
    testing::Values(
        Row{Operation::add, "q4_4", nearest, {100, 100}, -56, 0, false, "200 wraps to -56"},
        Row{Operation::add, "q4_4", saturating, {100, 100}, 127, 0, true, "200 saturates"},
        Row{Operation::add, "q4_4", published, {100, 100}, -56, 0, false, "200 wraps to -56"},
        Row{Operation::subtract, "q8_8", nearest, {min16, 1}, max16, 0, false, "below MIN wraps"},
        Row{Operation::subtract,
            "q8_8",
            saturating,
            {min16, 1},
            min16,
            0,
            true,
            "below MIN saturates"},
        Row{Operation::add, "q4_4", saturating, {100, 27}, 127, 0, false, "MAX itself"},
        Row{Operation::add, "q4_4", saturating, {-100, -28}, -128, 0, false, "MIN itself"},
        Row{Operation::negate, "q16_16", nearest, {min32}, min32, 0, false, "-MIN wraps to MIN"},
        Row{Operation::abs, "q16_16", nearest, {min32}, min32, 0, false, "|MIN| wraps to MIN"},
        Row{Operation::abs, "q16_16", saturating, {min32}, max32, 0, true, "|MIN| saturates"},
        Row{Operation::multiply, "q4_4", nearest, {2, 4}, 1, 0.5, false, "0.5 ulp: up"},
        Row{Operation::multiply, "q4_4", nearest, {-2, 4}, 0, 0.5, false, "-0.5 ulp: up"},
        Row{Operation::multiply, "q4_4", nearest, {3, 3}, 1, 0.4375, false, "9/16"},
        Row{Operation::multiply, "q4_4", nearest, {-3, 3}, -1, -0.4375, false, "-9/16"},
        Row{Operation::multiply,
            "q4_4",
            nearest,
            {127, 127},
            -16,
            -1.0 / 16,
            false,
            "1008.0625 wraps to -16"},
        Row{Operation::multiply, "q4_4", published, {3, 3}, 0, -0.5625, false, "9/16 truncated"},
        Row{Operation::multiply, "q4_4", published, {-3, 3}, 0, 0.5625, false, "-9/16 truncated"},
        Row{Operation::multiply,
            "q4_4",
            published,
            {-127, 127},
            16,
            1.0 / 16,
            false,
            "-1008.0625 truncates to -1008 and wraps to 16"},
        Row{Operation::multiply, "q4_4", saturating, {127, 127}, 127, 0, true, "saturates"},
        Row{Operation::multiply, "q4_4", saturating, {-128, 127}, -128, 0, true, "saturates"},
        Row{Operation::multiply, "q16_16", nearest, {min32, min32}, 0, 0, false, "2^46 wraps to 0"},
        Row{Operation::multiply,
            "q32_32",
            nearest,
            {INT64_MIN, -1},
            INT64_C(1) << 31,
            0,
            false,
            "-2^31 times -ulp"},
        Row{Operation::multiply,
            "q32_32",
            nearest,
            {INT64_MAX, INT64_MAX},
            -(INT64_C(1) << 32),
            -std::ldexp(1, -32),
            false,
            "2^94 - 2^32 + 2^-32 ulp"},
        Row{Operation::shift_left, "q8_8", nearest, {0x4001, 2}, 4, 0, false, "top bits leave"},
        Row{Operation::shift_left, "q8_8", saturating, {0x4001, 2}, max16, 0, true, "saturates"},
        Row{Operation::shift_right, "q8_8", nearest, {-1, 3}, -1, -0.875, false, "downward"},
        Row{Operation::sign, "q16_16", nearest, {min32}, -1, 0, false, "an integer"},
        Row{Operation::sign, "q16_16", nearest, {0}, 0, 0, false, "no sign"},
        Row{Operation::sign, "q16_16", nearest, {1}, 1, 0, false, "of 1 ulp"},
        Row{Operation::isqrt, "q16_16", nearest, {24}, 4, 0, false, "of an integer, downward"},
        Row{Operation::isqrt, "q16_16", nearest, {max32}, 46340, 0, false, "46341^2 does not fit"},
        Row{Operation::isqrt, "q16_16", nearest, {-1}, 0, 0, true, "of a negative integer"},
        Row{Operation::power, "q4_4", nearest, {-24, 3}, -54, 0, false, "-1.5^3 = -3.375"},
        Row{Operation::power, "q4_4", nearest, {0, -1}, 127, 0, true, "1 / 0"},
        Row{Operation::shift_right, "q8_8", nearest, {15, 3}, 1, -0.875, false, "downward"},
        Row{Operation::multiply_add,
            "q4_4",
            nearest,
            {2, 4, 10},
            11,
            0.5,
            false,
            "tie, rounded once"},
        Row{Operation::dot2,
            "q4_4",
            nearest,
            {1, 1, 4, 4},
            1,
            0.5,
            false,
            "two quarters, rounded once"},
        Row{Operation::dot3,
            "q4_4",
            nearest,
            {127, 127, 127, 127, 127, 127},
            -48,
            -3.0 / 16,
            false,
            "3024.1875 wraps to -48"}));

INSTANTIATE_TEST_SUITE_P(
    Division, DefinedResult,
    testing::Values(
        Row{Operation::divide, "q4_4", nearest, {1, 32}, 1, 0.5, false, "0.5 ulp: up"},
        Row{Operation::divide, "q4_4", nearest, {-1, 32}, 0, 0.5, false, "-0.5 ulp: up"},
        Row{Operation::divide, "q4_4", half_to_even, {1, 32}, 0, -0.5, false, "0.5 ulp: even"},
        Row{Operation::divide, "q4_4", half_to_even, {3, 32}, 2, 0.5, false, "1.5 ulp: even"},
        Row{Operation::divide, "q4_4", half_to_even, {-3, 32}, -2, -0.5, false, "-1.5 ulp: even"},
        Row{Operation::divide, "q4_4", downward, {-1, 32}, -1, -0.5, false, "-0.5 ulp: down"},
        Row{Operation::divide, "q4_4", toward_zero, {-31, 32}, -15, 0.5, false, "-15.5 ulp"},
        Row{Operation::divide, "q4_4", downward, {-100, 1}, -128, 0, true, "saturates"},
        Row{Operation::multiply, "q4_4", half_to_even, {1, 24}, 2, 0.5, false, "1.5 ulp: even"},
        Row{Operation::multiply, "q4_4", half_to_even, {5, 8}, 2, -0.5, false, "2.5 ulp: even"},
        Row{Operation::multiply, "q4_4", half_to_even, {127, 120}, -72, -0.5, false, "952.5 wraps"},
        Row{Operation::multiply, "q4_4", downward, {-1, 1}, -1, -0.9375, false, "down"},
        Row{Operation::multiply, "q4_4", toward_zero, {-1, 31}, -1, 0.9375, false, "to zero"},
        Row{Operation::add, "q4_4", downward, {127, 1}, -128, 0, false, "wraps as nearest"},
        Row{Operation::divide, "q4_4", nearest, {1, -32}, 0, 0.5, false, "-0.5 ulp: up"},
        Row{Operation::divide, "q4_4", published, {-1, 17}, 0, 16.0 / 17, false, "toward zero"},
        Row{Operation::divide, "q4_4", published, {100, 1}, 64, 0, false, "1600 wraps to 64"},
        Row{Operation::divide, "q4_4", nearest, {100, 1}, 127, 0, true, "1600 saturates"},
        Row{Operation::divide, "q4_4", nearest, {-100, 1}, -128, 0, true, "saturates"},
        Row{Operation::divide, "q4_4", nearest, {-128, -16}, 127, 0, true, "MIN / -1 saturates"},
        Row{Operation::divide, "q4_4", nearest, {1, 0}, 127, 0, true, "a > 0 by zero"},
        Row{Operation::divide, "q4_4", nearest, {-1, 0}, -128, 0, true, "a < 0 by zero"},
        Row{Operation::divide, "q4_4", nearest, {0, 0}, 0, 0, true, "0 / 0"},
        Row{Operation::divide, "q4_4", published, {1, 0}, 127, 0, true, "a > 0 by zero"},
        Row{Operation::divide,
            "q32_32",
            nearest,
            {INT64_MAX, INT64_MAX - 1},
            (INT64_C(1) << 32) + 0,
            -std::ldexp(1, -31),
            false,
            "just above 1"},
        Row{Operation::divide, "int16", integer, {-7, 2}, -3, 0.5, false, "C truncates"},
        Row{Operation::remainder, "q4_4", nearest, {-23, 16}, -7, 0, false, "sign of a"},
        Row{Operation::remainder, "q4_4", nearest, {23, -16}, 7, 0, false, "sign of a"},
        Row{Operation::remainder, "q4_4", nearest, {23, 0}, 23, 0, true, "by zero: a"},
        Row{Operation::remainder, "q4_4", nearest, {-128, -1}, 0, 0, false, "MIN by -ulp"}));

INSTANTIATE_TEST_SUITE_P(
    Functions, DefinedResult,
    testing::Values(
        Row{Operation::sqrt, "q16_16", nearest, {2 * one}, 92682, 0.0999, false, "92681.900"},
        Row{Operation::sqrt, "q16_16", published, {2 * one}, 92681, -0.9001, false, "92681.900"},
        Row{Operation::sqrt, "q16_16", nearest, {max32}, 11863283, -0.2003, false, "11863283.2003"},
        Row{Operation::sqrt, "q16_16", nearest, {-1}, 0, 0, true, "a < 0"},
        Row{Operation::sqrt,
            "q32_32",
            nearest,
            {INT64_MAX},
            199032864766430,
            -0.3926,
            false,
            "199032864766430.3926"},
        Row{Operation::reciprocal_sqrt, "q16_16", nearest, {4 * one}, one / 2, 0, false, "1/2"},
        Row{Operation::reciprocal_sqrt, "q16_16", nearest, {0}, max32, 0, true, "a = 0"},
        Row{Operation::reciprocal_sqrt, "q16_16", nearest, {-1}, 0, 0, true, "a < 0"},
        Row{Operation::reciprocal_sqrt, "q4_4", nearest, {1}, 64, 0, false, "4"},
        Row{Operation::reciprocal_sqrt,
            "q1_15",
            nearest,
            {16384},
            32767,
            0,
            true,
            "1.41 saturates"},
        Row{Operation::atan2, "q16_16", nearest, {0, 0}, 0, 0, true, "the origin"},
        Row{Operation::atan2, "q16_16", nearest, {0, -1}, 205887, -0.4161, false, "pi"},
        Row{Operation::atan2, "q16_16", nearest, {-1, min32}, -205887, 0.4161, false, "nearly -pi"},
        Row{Operation::atan2, "q16_16", published, {-one, 0}, 308831, -0.1242, false, "3 pi/2"},
        Row{Operation::atan2, "q16_16", published, {0, one}, 0, 0, false, "0 and not 2 pi"},
        Row{Operation::atan, "q16_16", published, {one + 1}, 51471, -0.8540, false, "pi/4"},
        Row{Operation::atan, "q16_16", published, {-one}, 0, 0, false, "below 0: 0"},
        Row{Operation::atan, "q16_16", nearest, {one}, 51472, 0.1460, false, "pi/4"},
        Row{Operation::atan, "q16_16", published, {max32}, 51471, -0.8540, false, "beyond 1: pi/4"},
        Row{Operation::sin, "q16_16", nearest, {one}, 55147, 0.3575, false, "55146.6425"},
        Row{Operation::cos, "q16_16", nearest, {0}, one, 0, false, "1"},
        Row{Operation::cos, "q1_15", nearest, {0}, 32767, 0, true, "1 saturates"},
        Row{Operation::exp, "q16_16", nearest, {one}, 178145, -0.3179, false, "e"},
        Row{Operation::exp, "q16_16", nearest, {min32}, 0, 0, false, "underflows"},
        Row{Operation::exp, "q16_16", nearest, {11 * one}, max32, 0, true, "saturates"},
        Row{Operation::exp,
            "q32_32",
            nearest,
            {INT64_MAX},
            INT64_MAX,
            0,
            true,
            "e^(2^31) saturates"},
        Row{Operation::log, "q16_16", nearest, {one}, 0, 0, false, "0"},
        Row{Operation::log, "q16_16", nearest, {0}, min32, 0, true, "log 0"},
        Row{Operation::log, "q16_16", nearest, {-1}, min32, 0, true, "log of a negative number"},
        Row{Operation::length2, "q16_16", nearest, {3 * one, -4 * one}, 5 * one, 0, false, "3 4 5"},
        Row{Operation::length3,
            "q16_16",
            nearest,
            {min32, min32, min32},
            max32,
            0,
            true,
            "saturates"}));

TEST(Judge, FunctionsMayErrWithinTheirBound) {
    // sin(1) is 55146.6425 ulp, so 55146 is off by 0.6425 and 55145 by 1.6425.
    const auto sine = [](std::int64_t result) {
        return judged(Operation::sin, "q16_16", nearest, {one}, {result});
    };
    EXPECT_TRUE(sine(55146).as_defined);
    EXPECT_NEAR(sine(55146).error_ulp, -0.6425, 1e-4);
    EXPECT_FALSE(sine(55145).as_defined);
    EXPECT_FALSE(sine(55148).as_defined);
}

// Sums and products of integers, rounded by integers.
TEST(Judge, RingOperationsWrapOrSaturate) {
    constexpr int F = 8;
    struct Ring {
        Operation operation;
        std::int64_t (*exact)(const std::int64_t*);  // in 2^-16
    };
    const Ring rings[] = {
        {Operation::add, [](const std::int64_t* x) { return (x[0] + x[1]) << F; }},
        {Operation::subtract, [](const std::int64_t* x) { return (x[0] - x[1]) << F; }},
        {Operation::negate, [](const std::int64_t* x) { return -x[0] << F; }},
        {Operation::abs, [](const std::int64_t* x) { return std::abs(x[0]) << F; }},
        {Operation::multiply, [](const std::int64_t* x) { return x[0] * x[1]; }},
        {Operation::multiply_add, [](const std::int64_t* x) { return x[0] * x[1] + (x[2] << F); }},
        {Operation::dot2, [](const std::int64_t* x) { return x[0] * x[2] + x[1] * x[3]; }},
        {Operation::dot3,
         [](const std::int64_t* x) { return x[0] * x[3] + x[1] * x[4] + x[2] * x[5]; }},
    };
    std::mt19937_64 random(3);
    for (const auto& [operation, exact] : rings) {
        for (int i = 0; i < 300; ++i) {
            Raws operands(shape(operation).operands);
            for (std::int64_t& raw : operands) raw = q8_8.extend(random()) >> (random() % 12);
            const std::int64_t rounded = (exact(operands.data()) + 128) >> F;
            const std::int64_t wrapped = q8_8.extend(std::uint64_t(rounded));
            const std::int64_t saturated = std::clamp(rounded, min16, max16);
            const auto accepts = [&](Arithmetic arithmetic, std::int64_t result) {
                return judged(operation, "q8_8", arithmetic, operands, {result}).as_defined;
            };
            EXPECT_TRUE(accepts(nearest, wrapped)) << shape(operation).name;
            EXPECT_EQ(accepts(nearest, saturated), saturated == wrapped) << shape(operation).name;
            EXPECT_TRUE(accepts(saturating, saturated)) << shape(operation).name;
            EXPECT_EQ(accepts(saturating, wrapped), saturated == wrapped) << shape(operation).name;
        }
    }
}

// What the library promises for each function, next to the functions of the C library.
TEST(Judge, FunctionsAreHeldToTheirBound) {
    struct Function {
        Operation operation;
        double bound_ulp;
        long double (*exact)(const long double*);
        std::int64_t least, greatest;
    };
    using X = const long double*;
    constexpr std::int64_t far = 100 * one;
    const Function functions[] = {
        {Operation::reciprocal_sqrt, 0.75, [](X x) { return 1 / std::sqrt(x[0]); }, 1, far},
        {Operation::atan, 0.75, [](X x) { return std::atan(x[0]); }, -far, far},
        {Operation::atan2, 0.75, [](X x) { return std::atan2(x[0], x[1]); }, -far, far},
        {Operation::sin, 0.75, [](X x) { return std::sin(x[0]); }, -far, far},
        {Operation::cos, 0.75, [](X x) { return std::cos(x[0]); }, -far, far},
        {Operation::exp, 0.75, [](X x) { return std::exp(x[0]); }, -9 * one, 9 * one},
        {Operation::log, 0.75, [](X x) { return std::log(x[0]); }, 1, far},
        {Operation::length2, 0.5, [](X x) { return std::hypot(x[0], x[1]); }, -far, far},
        {Operation::length3, 0.5, [](X x) { return std::hypot(x[0], x[1], x[2]); }, -far, far},
    };
    std::mt19937_64 random(5);
    for (const auto& [operation, bound_ulp, exact, least, greatest] : functions) {
        for (int i = 0; i < 100; ++i) {
            Raws operands(shape(operation).operands);
            long double numbers[3];
            for (std::size_t k = 0; k < operands.size(); ++k) {
                operands[k] = least + std::int64_t(random() % std::uint64_t(greatest - least + 1));
                numbers[k] = std::ldexp((long double)(operands[k]), -16);
            }
            const long double x = std::ldexp(exact(numbers), 16);
            for (int step = -1; step <= 2; ++step) {
                const std::int64_t result = std::int64_t(std::floor(x)) + step;
                const Judgement judgement =
                    judged(operation, "q16_16", nearest, operands, {result});
                const double error = double((long double)(result)-x);
                EXPECT_NEAR(judgement.error_ulp, error, 1e-6) << shape(operation).name;
                EXPECT_EQ(judgement.as_defined, std::abs(error) <= bound_ulp)
                    << shape(operation).name << " at " << operands[0] << " errs by " << error;
            }
        }
    }
}

TEST(Judge, VectorsReportTheirWorstComponent) {
    // (3, 4, 0) / 5 = (39321.6, 52428.8, 0) ulp
    const Raws v = {3 * one, 4 * one, 0};
    const Judgement good = judged(Operation::normalise3, "q16_16", nearest, v, {39322, 52429, 0});
    EXPECT_TRUE(good.as_defined);
    EXPECT_NEAR(good.error_ulp, 0.4, 1e-9);
    const Judgement bad = judged(Operation::normalise3, "q16_16", nearest, v, {39322, 52427, 0});
    EXPECT_FALSE(bad.as_defined);
    EXPECT_NEAR(bad.error_ulp, -1.8, 1e-9);
    EXPECT_TRUE(judged(Operation::normalise3, "q16_16", nearest, {0, 0, 0}, {0, 0, 0}).as_defined);
    EXPECT_FALSE(judged(Operation::normalise3, "q16_16", nearest, {0, 0, 0}, {0, 0, 1}).as_defined);
    // sin(1), cos(1) = 55146.6425, 35409.2517 ulp
    const Judgement both = judged(Operation::sincos, "q16_16", nearest, {one}, {55147, 35409});
    EXPECT_TRUE(both.as_defined);
    EXPECT_NEAR(both.error_ulp, 0.3575, 1e-4);
}

TEST(Judge, AVectorIsPinnedIfAllComponentsAre) {
    // sin(0) = 0 is exact; cos(0) = 1 saturates where the sign is the only integer bit.
    const Judgement mixed = judged(Operation::sincos, "q1_15", nearest, {0}, {0, 32767});
    EXPECT_TRUE(mixed.as_defined);
    EXPECT_FALSE(mixed.defined);
    EXPECT_TRUE(judged(Operation::normalise3, "q1_15", nearest, {0, 0, 0}, {0, 0, 0}).defined);
    EXPECT_FALSE(judged(Operation::sincos, "q1_15", nearest, {0}, {2, 32767}).as_defined);
    EXPECT_FALSE(judged(Operation::sincos, "q1_15", nearest, {0}, {0, 32765}).as_defined);
}

TEST(Judge, WrongPinnedResultsAreRejectedWithTheirDistance) {
    const Judgement wrong = judged(Operation::divide, "q4_4", nearest, {1, 0}, {0});
    EXPECT_TRUE(wrong.defined);
    EXPECT_FALSE(wrong.as_defined);
    EXPECT_EQ(wrong.error_ulp, -127);
}

TEST(Judge, UndefinedOperationsAreExcluded) {
    EXPECT_NE(judged(Operation::divide, "int16", integer, {1, 0}, {0}).excluded, nullptr);
    EXPECT_NE(judged(Operation::divide, "int16", integer, {min16, -1}, {0}).excluded, nullptr);
    EXPECT_NE(judged(Operation::multiply, "s8_7", Arithmetic::accum, {max16, max16}, {0}).excluded,
              nullptr);
    const Judgement accum = judged(Operation::multiply, "s8_7", Arithmetic::accum, {128, 3}, {5});
    EXPECT_EQ(accum.excluded, nullptr);
    EXPECT_EQ(accum.error_ulp, 2);
    EXPECT_TRUE(accum.as_defined);
}

Judgement judged_float(Operation operation, std::initializer_list<float> operands, float result) {
    Raws raws;
    for (const float operand : operands) raws.push_back(raw_of_float(operand));
    return judged(operation, "float", Arithmetic::ieee, raws, {raw_of_float(result)});
}

TEST(JudgeFloat, BasicOperationsAreRoundedToNearestEven) {
    EXPECT_TRUE(judged_float(Operation::add, {16777216, 1}, 16777216).as_defined);
    EXPECT_EQ(judged_float(Operation::add, {16777216, 1}, 16777216).error_ulp, -0.5);
    EXPECT_FALSE(judged_float(Operation::add, {16777216, 1}, 16777218).as_defined);
    EXPECT_TRUE(judged_float(Operation::add, {16777218, 1}, 16777220).as_defined);
    EXPECT_TRUE(judged_float(Operation::divide, {1, 3}, 1.0f / 3).as_defined);
    EXPECT_FALSE(judged_float(Operation::divide, {1, 3}, std::nextafter(1.0f / 3, 0.f)).as_defined);
    EXPECT_TRUE(judged_float(Operation::sqrt, {2}, std::sqrt(2.0f)).as_defined);
    // A subnormal result: the ulp stays 2^-149.
    EXPECT_EQ(judged_float(Operation::multiply, {FLT_TRUE_MIN, 0.75f}, FLT_TRUE_MIN).error_ulp,
              0.25);
    EXPECT_EQ(judged_float(Operation::subtract, {1, 1}, -0.0f).error_ulp, 0);
}

TEST(JudgeFloat, RoundedUpOverABinadeIsStillNearest) {
    // 1 - 2^-25 lies in the binade below 1, whose ulp is 2^-24: a tie, and 1 is the even neighbour.
    EXPECT_TRUE(judged_float(Operation::subtract, {1, std::ldexp(1.f, -25)}, 1).as_defined);
    EXPECT_EQ(judged_float(Operation::subtract, {1, std::ldexp(1.f, -25)}, 1).error_ulp, 0.5);
}

TEST(JudgeFloat, SpecialCases) {
    const auto accepted = [](Operation operation, std::initializer_list<float> operands,
                             float result) {
        const Judgement judgement = judged_float(operation, operands, result);
        return judgement.defined && judgement.as_defined && judgement.error_ulp == 0;
    };
    EXPECT_TRUE(accepted(Operation::multiply, {FLT_MAX, 2}, INFINITY));
    EXPECT_TRUE(accepted(Operation::multiply, {FLT_MAX, -2}, -INFINITY));
    EXPECT_TRUE(accepted(Operation::divide, {1, 0}, INFINITY));
    EXPECT_TRUE(accepted(Operation::divide, {1, -0.0f}, -INFINITY));
    EXPECT_TRUE(accepted(Operation::divide, {0, 0}, NAN));
    EXPECT_TRUE(accepted(Operation::sqrt, {-1}, -NAN));
    EXPECT_TRUE(accepted(Operation::log, {0}, -INFINITY));
    EXPECT_TRUE(accepted(Operation::add, {INFINITY, -INFINITY}, NAN));
    EXPECT_TRUE(accepted(Operation::exp, {-INFINITY}, 0));
    EXPECT_TRUE(accepted(Operation::exp, {FLT_MAX}, INFINITY));
    EXPECT_TRUE(accepted(Operation::atan2, {0, 1}, 0) ||
                judged_float(Operation::atan2, {0, 1}, 0).as_defined);
    EXPECT_TRUE(accepted(Operation::subtract, {INFINITY, 1}, INFINITY));
    EXPECT_TRUE(accepted(Operation::subtract, {1, INFINITY}, -INFINITY));
    EXPECT_TRUE(accepted(Operation::remainder, {1, INFINITY}, 1));
    EXPECT_TRUE(accepted(Operation::remainder, {INFINITY, 1}, NAN));
    EXPECT_TRUE(accepted(Operation::remainder, {1, 0}, NAN));
    EXPECT_TRUE(accepted(Operation::negate, {INFINITY}, -INFINITY));
    EXPECT_TRUE(accepted(Operation::abs, {-INFINITY}, INFINITY));
    EXPECT_TRUE(accepted(Operation::multiply_add, {INFINITY, 2, 1}, INFINITY));
    EXPECT_TRUE(accepted(Operation::multiply_add, {1, 1, INFINITY}, INFINITY));
    EXPECT_TRUE(accepted(Operation::multiply_add, {INFINITY, 0, 1}, NAN));
    // The product of each pair of components: 0 times infinity would be NaN.
    EXPECT_TRUE(accepted(Operation::dot2, {INFINITY, 0, 1, 1}, INFINITY));
    EXPECT_TRUE(accepted(Operation::dot2, {0, INFINITY, 1, 1}, INFINITY));
    EXPECT_TRUE(accepted(Operation::dot3, {INFINITY, 0, 0, 1, 1, 1}, INFINITY));
    EXPECT_TRUE(accepted(Operation::dot3, {0, INFINITY, 0, 1, 1, 1}, INFINITY));
    EXPECT_TRUE(accepted(Operation::dot3, {0, 0, INFINITY, 1, 1, 1}, INFINITY));
    EXPECT_TRUE(accepted(Operation::reciprocal_sqrt, {0}, INFINITY));
    EXPECT_TRUE(accepted(Operation::reciprocal_sqrt, {INFINITY}, 0));
    EXPECT_TRUE(accepted(Operation::reciprocal_sqrt, {-1}, NAN));
    EXPECT_TRUE(accepted(Operation::atan, {INFINITY}, 1.57079633f));
    EXPECT_TRUE(accepted(Operation::atan2, {INFINITY, -INFINITY}, 2.35619449f));
    EXPECT_TRUE(accepted(Operation::sin, {INFINITY}, NAN));
    EXPECT_TRUE(accepted(Operation::cos, {-INFINITY}, NAN));
    EXPECT_FALSE(accepted(Operation::divide, {1, 0}, FLT_MAX));
    EXPECT_EQ(judged_float(Operation::divide, {1, 0}, FLT_MAX).error_ulp, INFINITY);
    EXPECT_FALSE(judged_float(Operation::add, {1, 1}, NAN).as_defined);
    // Half an ulp beyond the largest float overflows, less than that does not.
    EXPECT_TRUE(accepted(Operation::add, {FLT_MAX, std::ldexp(1.f, 103)}, INFINITY));
    EXPECT_TRUE(judged_float(Operation::add, {FLT_MAX, std::ldexp(1.f, 102)}, FLT_MAX).as_defined);
}

TEST(JudgeFloat, AtanTwoFollowsTheSignOfZero) {
    const float pi = 3.14159265f;
    EXPECT_LT(std::abs(judged_float(Operation::atan2, {0, -1}, pi).error_ulp), 0.5);
    EXPECT_LT(std::abs(judged_float(Operation::atan2, {-0.0f, -1}, -pi).error_ulp), 0.5);
}

Judgement judged_double(Operation operation, std::initializer_list<double> operands,
                        double result) {
    Raws raws;
    for (const double operand : operands) raws.push_back(raw_of_double(ieee_double, operand));
    return judged(operation, "float64", Arithmetic::ieee, raws,
                  {raw_of_double(ieee_double, result)});
}

// The host's operators follow IEEE 754 and share no code with the judge.
TEST(JudgeDouble, TheHostsOperatorsAreCorrectlyRounded) {
    std::mt19937_64 random(1);
    const auto draw = [&] {
        return std::ldexp(double(std::int64_t(random())), int(random() % 240) - 183);
    };
    for (int i = 0; i < 300; ++i) {
        const double a = draw(), b = draw(), c = std::abs(a);
        const auto expect = [](Operation operation, std::initializer_list<double> x,
                               double result) {
            const Judgement judgement = judged_double(operation, x, result);
            EXPECT_TRUE(judgement.regular() && judgement.as_defined);
            EXPECT_LE(std::abs(judgement.error_ulp), 0.5);
            for (const double beside : {-HUGE_VAL, HUGE_VAL})
                EXPECT_FALSE(
                    judged_double(operation, x, std::nextafter(result, beside)).as_defined);
        };
        expect(Operation::add, {a, b}, a + b);
        expect(Operation::subtract, {a, b}, a - b);
        expect(Operation::multiply, {a, b}, a * b);
        expect(Operation::divide, {a, b}, a / b);
        expect(Operation::sqrt, {c}, std::sqrt(c));
        // No more is required of it than of a product and a sum.
        EXPECT_LE(
            std::abs(
                judged_double(Operation::multiply_add, {a, b, c}, std::fma(a, b, c)).error_ulp),
            0.5);
        for (const auto& [operation, result] :
             {std::pair{Operation::sin, std::sin(a)}, std::pair{Operation::atan2, std::atan2(a, b)},
              std::pair{Operation::length2, std::hypot(a, b)}}) {
            const bool of_two = shape(operation).operands == 2;
            const Judgement judgement = of_two ? judged_double(operation, {a, b}, result)
                                               : judged_double(operation, {a}, result);
            EXPECT_LT(std::abs(judgement.error_ulp), 1) << shape(operation).name << a << ' ' << b;
        }
    }
}

TEST(JudgeDouble, EdgesAndUlps) {
    const auto pinned = [](Operation operation, std::initializer_list<double> operands,
                           double result) {
        const Judgement judgement = judged_double(operation, operands, result);
        return judgement.defined && judgement.as_defined;
    };
    EXPECT_TRUE(pinned(Operation::multiply, {DBL_MAX, -2}, -INFINITY));
    EXPECT_TRUE(pinned(Operation::divide, {1, -0.0}, -INFINITY));
    EXPECT_TRUE(pinned(Operation::divide, {0, 0}, NAN));
    EXPECT_TRUE(pinned(Operation::exp, {DBL_MAX}, INFINITY));
    EXPECT_TRUE(pinned(Operation::log, {0}, -INFINITY));
    EXPECT_TRUE(pinned(Operation::atan, {INFINITY}, std::acos(0.0)));
    EXPECT_FALSE(pinned(Operation::divide, {1, 0}, DBL_MAX));
    // Half an ulp beyond the largest number overflows, less than that does not.
    EXPECT_TRUE(pinned(Operation::add, {DBL_MAX, 0x1p970}, INFINITY));
    EXPECT_TRUE(judged_double(Operation::add, {DBL_MAX, 0x1p969}, DBL_MAX).as_defined);
    EXPECT_EQ(judged_double(Operation::multiply, {DBL_TRUE_MIN, 0.75}, DBL_TRUE_MIN).error_ulp,
              0.25);
    // Even for a result that is far off, the ulp is that of the exact value.
    EXPECT_EQ(judged_double(Operation::add, {1, 2}, 0).error_ulp, -0x3p51);
    EXPECT_EQ(judged_double(Operation::add, {1, 2}, 0).error, 3);
    EXPECT_EQ(judged_float(Operation::add, {1, 2}, 0).error, 3);
    EXPECT_EQ(judged(Operation::add, "q16_16", nearest, {1, 2}, {0}).error, 0x3p-16);
    // The component with the largest error in ulp, the tiny one, does not have the largest error in
    // magnitude.
    const Judgement direction = judged(Operation::normalise3, "float", Arithmetic::ieee,
                                       {raw_of_float(0x1p-60f), raw_of_float(1), 0},
                                       {raw_of_float(0x1.fp-60f), raw_of_float(1.5f), 0});
    EXPECT_NEAR(direction.error_ulp, 0x.fp24, 1);
    EXPECT_EQ(direction.error, 0.5);
}

TEST(JudgeConversion, BetweenFormats) {
    const auto accepted = [](const char* from, const char* to, Arithmetic arithmetic,
                             std::int64_t raw, std::int64_t result) {
        const NumberFormat format = parse_format(to);
        const Judgement judgement =
            judge({Operation::convert, format, arithmetic, parse_format(from)}, Raws{raw}, result);
        const Judgement next = judge({Operation::convert, format, arithmetic, parse_format(from)},
                                     Raws{raw}, format.extend(std::uint64_t(result + 1)));
        return judgement.as_defined && !next.as_defined;
    };
    EXPECT_TRUE(accepted("q16_16", "q8_8", nearest, 128, 1));     // a tie: half up
    EXPECT_TRUE(accepted("q16_16", "q8_8", nearest, -128, 0));    // a tie: half up
    EXPECT_TRUE(accepted("q16_16", "q8_8", published, -255, 0));  // toward zero
    EXPECT_TRUE(accepted("q16_16", "q8_8", nearest, max32, 0));   // 32768 wraps
    EXPECT_TRUE(accepted("q16_16", "q8_8", saturating, max32, max16));
    EXPECT_TRUE(accepted("q8_8", "q32_32", nearest, -1, -(1 << 24)));
    EXPECT_TRUE(accepted("q16_16", "int16", nearest, 98304, 2));  // 1.5: half up
    EXPECT_TRUE(accepted("float", "q16_16", nearest, raw_of_float(0.1f), 6554));
    EXPECT_TRUE(accepted("float", "q16_16", nearest, raw_of_float(1e9f), max32));  // saturates
    EXPECT_TRUE(accepted("float", "q16_16", nearest, raw_of_float(-INFINITY), min32));
    EXPECT_TRUE(accepted("float", "q16_16", nearest, raw_of_float(NAN), 0));
    EXPECT_TRUE(accepted("q16_16", "float", nearest, max32, raw_of_float(32768)));
    EXPECT_TRUE(accepted("float", "int32", integer, raw_of_float(-1.75f), -1));
}

// A value that is not in range has one definition for every format: the nearer limit, and 0 for
// NaN.
TEST(JudgeConversion, FromFloatsOutsideTheRange) {
    for (const char* name : {"q4_4", "q8_8", "q1_15", "q16_16", "q8_24", "q32_32"}) {
        for (const Arithmetic arithmetic : {nearest, saturating}) {
            const NumberFormat format = parse_format(name);
            for (const auto& [number, result] :
                 {std::pair{INFINITY, format.max()}, std::pair{-INFINITY, format.min()},
                  std::pair{FLT_MAX, format.max()}, std::pair{-FLT_MAX, format.min()},
                  std::pair{NAN, std::int64_t(0)}, std::pair{-NAN, std::int64_t(0)}}) {
                for (const std::int64_t given : {format.min(), std::int64_t(-1), std::int64_t(0),
                                                 std::int64_t(1), format.max()}) {
                    const Judgement judgement =
                        judge({Operation::convert, format, arithmetic, ieee_single},
                              Raws{raw_of_float(number)}, given);
                    EXPECT_EQ(judgement.as_defined, given == result)
                        << name << ": " << given << " of " << number;
                    EXPECT_TRUE(judgement.defined);
                }
            }
        }
    }
    for (const float number : {INFINITY, -INFINITY, NAN, FLT_MAX})
        EXPECT_NE(judge({Operation::convert, parse_format("int32"), integer, ieee_single},
                        Raws{raw_of_float(number)}, 0)
                      .excluded,
                  nullptr);
}

TEST(Judge, WrongNumberOfOperandsOrResults) {
    const Subject add{Operation::add, q4_4, nearest};
    EXPECT_THROW(judge(add, Raws{1}, 1), std::invalid_argument);
    EXPECT_THROW(judge(add, Raws{1, 2, 3}, 1), std::invalid_argument);
    EXPECT_THROW(judge(add, Raws{1, 2}, Raws{1, 2}), std::invalid_argument);
}

}  // namespace
}  // namespace reference
