// SPDX-License-Identifier: MIT
// Decimal constants and binary time steps, compared with exact integers.
#include <gtest/gtest.h>

#include <cmath>
#include <engine/decimal.hpp>
#include <engine/time_step.hpp>
#include <limits>
#include <random>
#include <utility>

#include "reference/fifty_digits.hpp"

using namespace engine::literals;
using engine::Fixed;
using Wide = __int128;

namespace {

Wide power_of_ten(int exponent) {
    return exponent == 0 ? Wide(1) : 10 * power_of_ten(exponent - 1);
}
Wide floor_divided(Wide a, Wide b) { return a / b - (a % b < 0); }

template <class Number>
void expect_rounded(Number x, Wide digits, int places) {
    const Wide scale = power_of_ten(places);
    const Wide doubled = (digits << (Number::fraction_bits + 1)) + scale;
    EXPECT_EQ(Wide(x.raw()), floor_divided(doubled, 2 * scale));
}

template <int64_t digits, unsigned char places>
void check(engine::Decimal<digits, places> decimal, const char* text) {
    expect_rounded<Fixed<16, 16>>(decimal, digits, places);
    expect_rounded<Fixed<8, 24>>(decimal, digits, places);
    expect_rounded<Fixed<32, 32>>(decimal, digits, places);
    const float single = decimal;
    const double wide = decimal;
    const reference::FiftyDigits fifty = decimal;
    EXPECT_EQ(single, std::strtof(text, nullptr)) << text;
    EXPECT_EQ(wide, std::strtod(text, nullptr)) << text;
    const reference::FiftyDigits off = fifty - reference::FiftyDigits(text);
    EXPECT_LE(std::abs(static_cast<double>(off)), 1e-48) << text;
}

// The integer floor(a / 2^K + 1/2), with a wide enough for every K.
template <int K, class Raw>
void check_shift(Raw a) {
    const Wide half = K == 0 ? Wide(0) : Wide(1) << (K - 1);
    using Number = Fixed<4 * sizeof(Raw), 4 * sizeof(Raw)>;
    const Number product = Number::from_raw(a) * engine::BinaryStep<K>();
    EXPECT_EQ(Wide(product.raw()), (Wide(a) + half) >> K)
        << "K = " << K << ", a = " << static_cast<long long>(a);
}

template <class Raw, int... K>
void check_shifts(std::integer_sequence<int, K...>) {
    using Limits = std::numeric_limits<Raw>;
    std::mt19937_64 random(1);
    for (Raw near : {Raw(0), Limits::min(), Limits::max()}) {
        for (int off = -3; off <= 3; ++off) {
            const auto a = static_cast<Raw>(static_cast<uint64_t>(near) + off);
            (check_shift<K>(a), ...);
        }
    }
    for (unsigned bit = 0; bit < 8 * sizeof(Raw); ++bit) {
        for (int off = -1; off <= 1; ++off) {
            const auto a = static_cast<Raw>((uint64_t(1) << bit) + off);
            (check_shift<K>(a), ...);
            (check_shift<K>(static_cast<Raw>(-static_cast<uint64_t>(a))), ...);
        }
    }
    for (int i = 0; i < 1000; ++i) {
        const auto a = static_cast<Raw>(random());
        (check_shift<K>(a), ...);
    }
}

}  // namespace

TEST(Decimal, IsRoundedOnceInEveryScalar) {
    check(0.38_d, "0.38");
    check(-0.38_d, "-0.38");
    check(9.81_d, "9.81");
    check(0.1_d, "0.1");
    check(12_d, "12");
    check(0_d, "0");
    check(0.000'01_d, "0.00001");
    check(127.999'999_d, "127.999999");
    check(-128_d, "-128");
    check(3.1415926535897932_d, "3.1415926535897932");
    check(engine::Decimal<-981, 2>(), "-9.81");
    // Half of a last bit of Q16.16, positive and negative: rounded half up.
    check(engine::Decimal<762939453125, 17>(), "0.00000762939453125");
    check(engine::Decimal<-762939453125, 17>(), "-0.00000762939453125");
    // More digits than a float holds: two roundings would give the wrong result.
    check(16.777217_d, "16.777217");
    check(83.886091_d, "83.886091");
    check(100.663297_d, "100.663297");
}

TEST(BinaryStep, ShiftsToTheNearestForEveryValueOfEightBits) {
    for (int a = -128; a < 128; ++a) {
        [&]<int... K>(std::integer_sequence<int, K...>) {
            (check_shift<K>(static_cast<int8_t>(a)), ...);
        }
        (std::make_integer_sequence<int, 20>());
    }
}
TEST(BinaryStep, ShiftsToTheNearest) {
    check_shifts<int16_t>(std::make_integer_sequence<int, 60>());
    check_shifts<int32_t>(std::make_integer_sequence<int, 60>());
    check_shifts<int64_t>(std::make_integer_sequence<int, 60>());
}

TEST(BinaryStep, InSeconds) {
    EXPECT_EQ(engine::seconds<double>(engine::BinaryStep<10>()), 1.0 / 1024);
    EXPECT_EQ((engine::seconds<Fixed<16, 16>>(engine::BinaryStep<10>()).raw()), 64);
    EXPECT_EQ((engine::seconds<Fixed<16, 16>>(engine::BinaryStep<17>()).raw()), 1);
    EXPECT_EQ((engine::seconds<Fixed<16, 16>>(engine::BinaryStep<18>()).raw()), 0);
    EXPECT_EQ(engine::half(0.25), 0.125);
    EXPECT_EQ(3.0 * engine::half(engine::BinaryStep<3>()), 3.0 / 16);
}
