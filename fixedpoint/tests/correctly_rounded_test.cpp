// SPDX-License-Identifier: MIT
// CorrectlyRounded against functions of 113 bits: the exact result, rounded, for every operation.
// Results in Q32.32 on a tie or next to one, which random operands rarely reach, are searched for;
// and the error bound of the code that decides them is checked on both sides of the tie.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fixedpoint/arithmetic/correctly_rounded.hpp>
#include <fixedpoint/math.hpp>
#include <fixedpoint/vector.hpp>
#include <random>
#include <utility>
#include <vector>

#include "float128.hpp"

namespace {

using fixedpoint::CorrectlyRounded;
using fixedpoint::Int24;
using fixedpoint::Nearest;
using fixedpoint::RawLimits;

struct Function {
    const char* name;
    bool (*has_result)(Real a);
    Real (*exact)(Real a);
    int32_t (*q16_16)(int32_t a);
    Int24 (*q8_16)(Int24 a);
    Int24 (*q12_12)(Int24 a);
    int16_t (*q8_8)(int16_t a);
    int8_t (*q4_4)(int8_t a);
    int64_t (*wide)(int64_t a);
    // Among all operands with a result in range, or 2^24 of them, those whose results are closest
    // to a tie: 2^-18 to 2^-33 ulp.
    std::vector<int32_t> hardest;
};

bool not_far(Real a) { return a >= -20 && a <= 20; }

#define FUNCTION(name, has_result, ...)                                                          \
    Function {                                                                                   \
#name, has_result,                                                                       \
            [](Real a) -> Real { return name##f128(a); }, CorrectlyRounded::name < int32_t, 16>, \
                                                       CorrectlyRounded::name < Int24, 16>,      \
                                                       CorrectlyRounded::name < Int24, 12>,      \
                                                       CorrectlyRounded::name < int16_t, 8>,     \
                                                       CorrectlyRounded::name < int8_t, 4>,      \
                                                       Nearest::name < int64_t, 32>, {           \
            __VA_ARGS__                                                                          \
        }                                                                                        \
    }
const std::vector<Function>& functions() {
    static const std::vector<Function> all = {
        FUNCTION(reciprocal_sqrt, above_zero, 981569017, 1638289780, 1444037183),
        FUNCTION(sin, anywhere, -887841717, 592530584, -1719254177),
        FUNCTION(cos, anywhere, 564153567, 2030042867, -505055703),
        FUNCTION(tan, anywhere, -1269382028, -1313407413, 2033189759),
        FUNCTION(asin, to_one),
        FUNCTION(acos, to_one, -7695, -64828),
        FUNCTION(atan, anywhere, -466434983, 1020649452, 1338799777),
        FUNCTION(exp, not_far, -129660, 780574, -481090),
        FUNCTION(exp2, not_far, -205477, 433072),
        FUNCTION(expm1, not_far, -129660, 780574, -481090),
        FUNCTION(log, above_zero, 45255651, 1113115911, 710352108),
        FUNCTION(log2, above_zero, 1746593424, 2124676799, 1056735271),
        FUNCTION(log10, above_zero, 1187172104, 772446083, 499414131),
        FUNCTION(log1p, above_minus_one, 2016388328, 846231697, 458138569),
        FUNCTION(sinh, not_far, -441619, 441619, -495328),
        FUNCTION(cosh, not_far, -256, 256, 355997),
        FUNCTION(tanh, not_far, -144246, 144246, -18085),
        FUNCTION(cbrt, anywhere, 2012702089, -1334439693, 221123593),
    };
    return all;
}

class CorrectRounding : public testing::TestWithParam<std::size_t> {
  protected:
    const Function& function_ = functions()[GetParam()];

    template <class Raw, int F>
    void check(Raw a, Raw result) const {
        const Real value = Real(a) / Real(1 << F);
        if (!function_.has_result(value)) return;
        ASSERT_EQ(result, rounded<Raw>(function_.exact(value), F)) << "of " << int64_t(a);
    }
};

TEST_P(CorrectRounding, OfEveryNumberOf8And16Bits) {
    for (int a = INT8_MIN; a <= INT8_MAX; ++a)
        check<int8_t, 4>(int8_t(a), function_.q4_4(int8_t(a)));
    for (int a = INT16_MIN; a <= INT16_MAX; ++a)
        check<int16_t, 8>(int16_t(a), function_.q8_8(int16_t(a)));
}

TEST_P(CorrectRounding, OfNumbersOf24Bits) {
    std::mt19937 random(7);
    for (int i = 0; i < 3000; ++i) {
        const Int24 a = static_cast<int32_t>(random()) >> (8 + random() % 24);
        check<Int24, 16>(a, function_.q8_16(a));
        check<Int24, 12>(a, function_.q12_12(a));
    }
    for (const int32_t a : function_.hardest)
        if (Int24(a) == a) check<Int24, 16>(a, function_.q8_16(a));
}

TEST_P(CorrectRounding, OfNumbersOf32Bits) {
    std::mt19937 random(1);
    for (int i = 0; i < 10'000; ++i) {
        const int32_t a = static_cast<int32_t>(random()) >> random() % 32;
        check<int32_t, 16>(a, function_.q16_16(a));
    }
    for (const int32_t a : {INT32_MIN, INT32_MIN + 1, INT32_MAX, 0, 1, -1, 65535, 65536, -65536})
        check<int32_t, 16>(a, function_.q16_16(a));
}

TEST_P(CorrectRounding, WhereTheWideResultIsAlmostATie) {
    for (const int32_t a : function_.hardest) check<int32_t, 16>(a, function_.q16_16(a));
    std::mt19937 random(2);
    for (int i = 0; i < 100'000; ++i) {
        const int32_t a = static_cast<int32_t>(random()) >> random() % 24;
        if (!function_.has_result(Real(a) / 65536)) continue;
        const int64_t wide = function_.wide(int64_t(a) * 65536);
        if (static_cast<uint16_t>(wide + 0x8020) <= 0x40)
            check<int32_t, 16>(a, function_.q16_16(a));
    }
}

TEST(CorrectRoundingByShortCores, LeavesFewOperandsInDoubt) {
    std::mt19937 random(6);
    int in_doubt[6] = {};
    for (int i = 0; i < 100'000; ++i) {
        const int32_t a = static_cast<int32_t>(random()) >> random() % 24;
        const int32_t positive = 1 + (a & (RawLimits<int32_t>::max - 1));
        const int32_t exponent = a % (8 << 16);
        const int32_t results[] = {fixedpoint::portable::certain_sin<int32_t, 16>(a),
                                   fixedpoint::portable::certain_cos<int32_t, 16>(a),
                                   fixedpoint::portable::certain_atan<int32_t, 16>(a),
                                   fixedpoint::portable::certain_atan2<int32_t, 16>(a, positive),
                                   fixedpoint::portable::certain_log<int32_t, 16>(positive),
                                   fixedpoint::portable::certain_exp<int32_t, 16>(exponent)};
        for (int k = 0; k < 6; ++k) in_doubt[k] += results[k] == RawLimits<int32_t>::min;
    }
    for (int k = 0; k < 5; ++k) EXPECT_LT(in_doubt[k], 100) << k;
    EXPECT_LT(in_doubt[5], 3000) << "those of exp, within 2/256 ulp and more of a tie";
}

constexpr Real two_to_64 = Real(18446744073709551616.0);

// In units of 2^-88.
fixedpoint::portable::Word128 wide_angle(Real angle) {
    const Real scaled = angle * Real(1 << 24);
    const auto upper = static_cast<uint64_t>(scaled);
    return {upper, static_cast<uint64_t>((scaled - Real(upper)) * two_to_64)};
}
void expect_direction(uint32_t a, uint32_t b) {
    uint32_t y = std::min(a, b), x = std::max(a, b);
    for (; x >> 31 == 0; x <<= 1) y <<= 1;
    const Real angle = atan2f128(y, x), error = Real(1) / (Real(1 << 18) * two_to_64);
    if (angle < error) return;
    ASSERT_TRUE(fixedpoint::portable::direction_exceeds(y, x, wide_angle(angle - error)))
        << y << ", " << x;
    ASSERT_FALSE(fixedpoint::portable::direction_exceeds(y, x, wide_angle(angle + error)))
        << y << ", " << x;
}
TEST(SideOfATie, OfDirectionsErrsByLessThan2ToTheMinus82) {
    std::mt19937 random(7);
    for (int i = 0; i < 10'000; ++i)
        expect_direction(1 + (random() >> (1 + random() % 31)), random() >> random() % 32);
    // Where a number of 1/2048 begins and ends, with it the largest of each leading byte.
    const uint32_t x = uint32_t(1) << 31;
    for (int i = 0; i <= 8 * 201; ++i) {
        const auto y = static_cast<uint32_t>(Real(x) * tanf128(Real(i) / 2048));
        for (uint32_t n = y - (i > 0 ? 2 : 0); n <= y + 2; ++n) expect_direction(n, x);
    }
}

// The digits of the angle then turn the direction beyond 0.
TEST(SideOfATie, OfDirectionsBelowAnAngleWithHardlyARest) {
    const uint32_t x = uint32_t(1) << 31;
    for (uint32_t i = 1; i <= 15; ++i) {
        const fixedpoint::portable::Word128 angle = wide_angle(Real(i) / 65536 + 1 / two_to_64);
        ASSERT_FALSE(fixedpoint::portable::direction_exceeds((i << 15) - 1, x, angle)) << i;
        ASSERT_TRUE(fixedpoint::portable::direction_exceeds((i << 15) + 1, x, angle)) << i;
    }
}

TEST(PreciseSine, HasTheRestOfTheQuarterTurnsWithin2Units) {
    std::mt19937 random(8);
    const Real half_pi = 2 * atanf128(1);
    for (int i = 0; i < 100'000; ++i) {
        const uint32_t a = (random() >> random() % 32) & 0x7fffffff;
        const auto turns = fixedpoint::kernel::nearest_quarter_turns(a);
        const Real beyond = Real(a) / 65536 - turns.quarters * half_pi;
        const Real rest = turns.is_beyond ? beyond : -beyond;
        ASSERT_LT(fabsf128(rest * two_to_64 / 2 - Real(turns.rest)), 2) << a;
        ASSERT_LT(rest, half_pi / 2 + Real(1) / 16384) << a;
    }
}

TEST(PreciseSine, ErrsByLessThan2ToTheMinus51) {
    std::mt19937_64 random(10);
    constexpr uint64_t largest = 7245000000000000000;  // pi/4 + 2^-14, in units of 2^-63
    for (int i = 0; i < 400'000; ++i) {
        const uint64_t rest = random() % largest;
        const Real angle = Real(rest) * 2 / two_to_64;
        for (const bool is_cosine : {false, true}) {
            const Real exact = (is_cosine ? cosf128(angle) : sinf128(angle)) * two_to_64;
            const uint64_t sine = fixedpoint::kernel::precise_sine_of_rest(rest, is_cosine);
            ASSERT_LT(fabsf128(exact - Real(sine)), 8192) << rest;
        }
    }
}

TEST(SideOfATie, OfPowersIsTheNearestNumbers) {
    std::mt19937 random(9);
    for (int i = 0; i < 100'000; ++i) {
        const uint32_t n = 1 + (random() >> (1 + random() % 31));
        const Real x = logf128(Real(n) / 65536) * Real(uint64_t(1) << 32);
        const Real nearest = floorf128(x + Real(0.5));
        ASSERT_EQ(fixedpoint::kernel::reaches_power(n, static_cast<int64_t>(nearest)), x >= nearest)
            << n;
    }
}

INSTANTIATE_TEST_SUITE_P(Functions, CorrectRounding,
                         testing::Range(std::size_t(0), functions().size()),
                         [](const auto& of) { return std::string(functions()[of.param].name); });

TEST(CorrectRoundingOfPairs, OfAngles) {
    for (const int32_t y : {-466434983, 1020649452, 1338799777}) {
        EXPECT_EQ((CorrectlyRounded::atan2<int32_t, 16>(y, 65536)),
                  rounded<int32_t>(atan2f128(y, 65536), 16));
    }
    // The pairs closest to a tie, by 2^-79.6 to 2^-75.8.
    constexpr int32_t closest[][2] = {{910339403, -1953906981}, {515435491, -1793836970},
                                      {516076007, 58132538},    {252695074, -1713085953},
                                      {460672751, 935870233},   {621376082, -669620561}};
    for (const auto& [y, x] : closest) {
        for (const int32_t sign : {1, -1})
            EXPECT_EQ((CorrectlyRounded::atan2<int32_t, 16>(sign * y, x)),
                      rounded<int32_t>(atan2f128(sign * y, x), 16))
                << sign * y << ", " << x;
    }
    std::mt19937 random(3);
    for (int i = 0; i < 50'000; ++i) {
        const int32_t y = static_cast<int32_t>(random()) >> random() % 32;
        const int32_t x = static_cast<int32_t>(random()) >> random() % 32;
        if (y == 0 && x == 0) continue;
        ASSERT_EQ((CorrectlyRounded::atan2<int32_t, 16>(y, x)),
                  rounded<int32_t>(atan2f128(y, x), 16))
            << y << ", " << x;
    }
}

TEST(CorrectRoundingOfPairs, OfPowers) {
    std::mt19937 random(4);
    for (int i = 0; i < 20'000; ++i) {
        const int32_t x = static_cast<int32_t>(1 + (random() >> (1 + random() % 31)));
        const int32_t y = static_cast<int32_t>(random()) >> random() % 32;
        ASSERT_EQ((CorrectlyRounded::pow<int32_t, 16>(x, y)),
                  rounded<int32_t>(powf128(Real(x) / 65536, Real(y) / 65536), 16))
            << x << ", " << y;
    }
}

// A power x^y in Q16.16 is a tie only if x is a power w^(2^s) and y is 17 / 2^s, with w = 1/2 or
// 3/2, or -17 / 2^s, with w = 2: others have too many or too few fraction bits.
TEST(CorrectRoundingOfPairs, OfPowersThatAreTies) {
    constexpr int32_t largest_power = 64570082;  // 1.5^17 = 985.2612...
    int32_t three_halves = 3 << 15, half = 1 << 15, two = 2 << 16;
    for (int s = 0; s < 4; ++s) {
        const int32_t y = 17 * (65536 >> s);
        EXPECT_EQ((CorrectlyRounded::pow<int32_t, 16>(three_halves, y)), largest_power) << s;
        EXPECT_EQ((CorrectlyRounded::pow<int32_t, 16>(half, y)), 1) << s;
        EXPECT_EQ((CorrectlyRounded::pow<int32_t, 16>(two, -y)), 1) << s;
        const auto square = [](int32_t a) { return static_cast<int32_t>(int64_t(a) * a >> 16); };
        three_halves = square(three_halves);
        half = square(half);
        two = square(two);
    }
    EXPECT_EQ((CorrectlyRounded::pow<int32_t, 16>(-(3 << 15), 17 << 16)), 1 - largest_power);
}

TEST(CorrectRoundingOfVectors, OfLengthsUnitVectorsAndSincos) {
    std::mt19937 random(5);
    for (int i = 0; i < 50'000; ++i) {
        int32_t v[3];
        for (int32_t& component : v) component = static_cast<int32_t>(random()) >> random() % 32;
        const Real two = Real(v[0]) * Real(v[0]) + Real(v[1]) * Real(v[1]);
        const Real three = two + Real(v[2]) * Real(v[2]);
        ASSERT_EQ((CorrectlyRounded::length2<int32_t, 16>(v)), rounded<int32_t>(sqrtf128(two), 0));
        ASSERT_EQ((CorrectlyRounded::length3<int32_t, 16>(v)),
                  rounded<int32_t>(sqrtf128(three), 0));
        int32_t unit[3];
        CorrectlyRounded::normalise3<int32_t, 16>(v, unit);
        for (int k = 0; k < 3 && three > 0; ++k)
            ASSERT_EQ(unit[k], rounded<int32_t>(Real(v[k]) / sqrtf128(three), 16)) << k;
        int32_t both[2];
        CorrectlyRounded::sincos<int32_t, 16>(v[0], both);
        ASSERT_EQ(both[0], (CorrectlyRounded::sin<int32_t, 16>(v[0])));
        ASSERT_EQ(both[1], (CorrectlyRounded::cos<int32_t, 16>(v[0])));
    }
}

}  // namespace
