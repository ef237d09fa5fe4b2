// SPDX-License-Identifier: MIT
// Conversions against exact integers: formats, integers, float and double, integers with decimals.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstring>
#include <fixedpoint/conversion.hpp>
#include <limits>

#include "exact.hpp"

namespace {

using namespace fixedpoint;
using exact::Format;
using exact::Int;
using Rational = boost::multiprecision::cpp_rational;

template <class To, class From>
void check_format_conversion() {
    using ToRaw = typename To::Raw;
    using FromRaw = typename From::Raw;
    for (const FromRaw a : exact::raws<FromRaw>()) {
        const Int expected = exact::nearest(Int(a) << To::F, Int(1) << From::F);
        ASSERT_EQ((portable::convert<ToRaw, To::F, FromRaw, From::F>(a)),
                  exact::wrapped<ToRaw>(expected))
            << +a << " / 2^" << From::F << " to " << sizeof(ToRaw) << " bytes, F = " << To::F;
        const auto result = portable::convert_clamped<ToRaw, To::F, FromRaw, From::F>(a);
        ASSERT_EQ(result.number, exact::clamped<ToRaw>(expected)) << +a;
        ASSERT_EQ(result.fits, exact::fits<ToRaw>(expected)) << +a;
    }
}

template <class Raw, int F, class Integer>
void check_integer_conversion() {
    std::vector<Integer> integers;
    for (const auto n : exact::raws<Unsigned<Integer>>())
        integers.push_back(static_cast<Integer>(n));
    for (const Integer n : integers) {
        const Int expected = Int(n) << F;
        ASSERT_EQ((portable::convert<Raw, F, Integer, 0>(n)), exact::wrapped<Raw>(expected)) << +n;
        const auto result = portable::convert_clamped<Raw, F, Integer, 0>(n);
        ASSERT_EQ(result.number, exact::clamped<Raw>(expected)) << +n;
        ASSERT_EQ(result.fits, exact::fits<Raw>(expected)) << +n;
    }
    for (const Raw a : exact::raws<Raw>()) {
        const Int expected = exact::nearest(a, Int(1) << F);
        ASSERT_EQ((portable::convert<Integer, 0, Raw, F>(a)), exact::wrapped<Integer>(expected))
            << +a;
        const auto result = portable::convert_clamped<Integer, 0, Raw, F>(a);
        ASSERT_EQ(result.number, exact::clamped<Integer>(expected)) << +a;
        ASSERT_EQ(result.fits, exact::fits<Integer>(expected)) << +a;
    }
}

template <class F>
class Conversion : public testing::Test {};
using Formats = testing::Types<Format<int8_t, 0>, Format<int8_t, 4>, Format<int8_t, 7>,
                               Format<int16_t, 0>, Format<int16_t, 8>, Format<int16_t, 15>,
                               Format<int32_t, 0>, Format<int32_t, 16>, Format<int32_t, 31>,
                               Format<int64_t, 0>, Format<int64_t, 32>, Format<int64_t, 63>>;
TYPED_TEST_SUITE(Conversion, Formats);

TYPED_TEST(Conversion, FromEveryFormat) {
    check_format_conversion<TypeParam, Format<int8_t, 0>>();
    check_format_conversion<TypeParam, Format<int8_t, 4>>();
    check_format_conversion<TypeParam, Format<int8_t, 7>>();
    check_format_conversion<TypeParam, Format<int16_t, 8>>();
    check_format_conversion<TypeParam, Format<int16_t, 15>>();
    check_format_conversion<TypeParam, Format<int32_t, 16>>();
    check_format_conversion<TypeParam, Format<int32_t, 31>>();
    check_format_conversion<TypeParam, Format<int64_t, 0>>();
    check_format_conversion<TypeParam, Format<int64_t, 32>>();
    check_format_conversion<TypeParam, Format<int64_t, 63>>();
}

TYPED_TEST(Conversion, FromAndToIntegers) {
    using Raw = typename TypeParam::Raw;
    constexpr int F = TypeParam::F;
    check_integer_conversion<Raw, F, signed char>();
    check_integer_conversion<Raw, F, unsigned char>();
    check_integer_conversion<Raw, F, short>();
    check_integer_conversion<Raw, F, unsigned short>();
    check_integer_conversion<Raw, F, int>();
    check_integer_conversion<Raw, F, unsigned>();
    check_integer_conversion<Raw, F, long long>();
    check_integer_conversion<Raw, F, unsigned long long>();
}

// x 2^F exactly, as numerator and denominator.
template <class Float>
std::pair<Int, Int> scaled(Float x, int f) {
    int exponent = 0;
    const Float mantissa = std::ldexp(std::frexp(x, &exponent), std::numeric_limits<Float>::digits);
    exponent += f - std::numeric_limits<Float>::digits;
    const Int numerator = static_cast<int64_t>(mantissa);
    return exponent >= 0 ? std::pair(Int(numerator << exponent), Int(1))
                         : std::pair(numerator, Int(Int(1) << -exponent));
}

template <class Raw, int F, class Float>
void check_from_float(Float x) {
    const auto [numerator, denominator] = scaled(x, F);
    const Int expected = exact::nearest(numerator, denominator);
    const auto result = portable::from_float<Raw, F>(x);
    ASSERT_EQ(result.number, exact::clamped<Raw>(expected)) << x;
    ASSERT_EQ(result.fits, exact::fits<Raw>(expected)) << x;
}

template <class Raw, int F, class Float>
void check_floating_point() {
    constexpr Float infinity = std::numeric_limits<Float>::infinity();
    for (const Raw a : exact::raws<Raw>()) {
        const Float x = portable::to_float<Float, Raw, F>(a);
        // The nearest Float: neither neighbour is closer, and a tie has an even last bit.
        const auto distance = [&](Float y) {
            const auto [numerator, denominator] = scaled(y, F);
            return Rational(abs(Int(numerator - a * denominator)), denominator);
        };
        for (const Float neighbour : {std::nextafter(x, infinity), std::nextafter(x, -infinity)}) {
            const Rational here = distance(x), there = distance(neighbour);
            const bool even = (portable::bits_of(x) & 1) == 0;
            ASSERT_TRUE(here < there || (here == there && even)) << +a;
            if (neighbour != 0) check_from_float<Raw, F>(neighbour);
        }
        // Numbers midway between two raw ones, where a Float holds them.
        check_from_float<Raw, F>(x);
        const Float ulp = std::ldexp(Float(1), -F);
        for (const Float offset : {Float(0.25), Float(0.5), Float(0.75)}) {
            check_from_float<Raw, F>(x + offset * ulp);
            check_from_float<Raw, F>(std::nextafter(x + offset * ulp, infinity));
            check_from_float<Raw, F>(std::nextafter(x + offset * ulp, -infinity));
        }
    }
    for (const Float x :
         {Float(0), -Float(0), std::numeric_limits<Float>::max(),
          std::numeric_limits<Float>::lowest(), std::numeric_limits<Float>::min(),
          std::numeric_limits<Float>::denorm_min(), -std::numeric_limits<Float>::denorm_min()}) {
        check_from_float<Raw, F>(x);
    }
    const auto positive = portable::from_float<Raw, F>(infinity);
    EXPECT_EQ(positive.number, std::numeric_limits<Raw>::max());
    EXPECT_FALSE(positive.fits);
    const auto negative = portable::from_float<Raw, F>(-infinity);
    EXPECT_EQ(negative.number, std::numeric_limits<Raw>::min());
    EXPECT_FALSE(negative.fits);
    for (const Float nan :
         {std::numeric_limits<Float>::quiet_NaN(), -std::numeric_limits<Float>::signaling_NaN()}) {
        EXPECT_EQ((portable::from_float<Raw, F>(nan).number), 0);
        EXPECT_FALSE((portable::from_float<Raw, F>(nan).fits));
    }
}

TYPED_TEST(Conversion, FromAndToFloat) {
    check_floating_point<typename TypeParam::Raw, TypeParam::F, float>();
}
TYPED_TEST(Conversion, FromAndToDouble) {
    check_floating_point<typename TypeParam::Raw, TypeParam::F, double>();
}

TYPED_TEST(Conversion, FromIntegersWithDecimals) {
    using Raw = typename TypeParam::Raw;
    constexpr int F = TypeParam::F;
    const auto check = [&](auto n, uint8_t decimals) {
        const Int expected = exact::nearest(Int(n) << F, exact::power(10, decimals));
        const auto result = portable::from_decimal<Raw, F>(n, decimals);
        ASSERT_EQ(result.number, exact::clamped<Raw>(expected)) << +n << " e-" << +decimals;
        ASSERT_EQ(result.fits, exact::fits<Raw>(expected)) << +n << " e-" << +decimals;
    };
    for (const int16_t n : exact::raws<int16_t>()) check(n, static_cast<uint8_t>(n & 7));
    for (const int64_t n : exact::raws<int64_t>()) {
        for (const uint8_t decimals : {0, 1, 9, 18, 19, 20, 255}) check(n, decimals);
    }
}

RC_GTEST_PROP(ConversionProperty, RandomFloats, (uint32_t bits)) {
    float x = 0;
    std::memcpy(&x, &bits, sizeof x);
    RC_PRE(std::isfinite(x));
    check_from_float<int16_t, 8>(x);
    check_from_float<int32_t, 16>(x);
    check_from_float<int64_t, 32>(x);
    RC_ASSERT(!testing::Test::HasFatalFailure());
}

TEST(PublicConversion, NamesWhatItConvertsTo) {
    const Q16_16 x = Q16_16::from_raw(-0x28000);  // -2.5
    EXPECT_EQ(convert<Q8_8>(x).raw(), -0x280);
    EXPECT_EQ(convert<int>(x), -2);
    EXPECT_EQ(convert<Q16_16>(-3).raw(), -0x30000);
    EXPECT_EQ(convert_checked<Q4_4>(Q16_16::max()).number, Q4_4::max());
    EXPECT_FALSE(convert_checked<uint8_t>(x).fits);
    EXPECT_EQ(convert_checked<uint8_t>(x).number, 0);
    EXPECT_EQ(from_float<Q16_16>(-2.5f), x);
    EXPECT_EQ(to_float<double>(x), -2.5);
    EXPECT_EQ(from_decimal<Q16_16>(-25, 1), x);
}

static_assert(from_decimal<Q16_16>(38, 2).raw() == 24904, "0.38 2^16 = 24903.68");
static_assert(from_float<Q16_16>(0.38).raw() == 24904, "a constant on the host");
static_assert(to_float<float>(Q8_8::from_raw(0x180)) == 1.5f, "1.5 is exact");
static_assert(convert<Q4_4>(convert<Q32_32>(Q4_4::min())) == Q4_4::min(), "there and back");

}  // namespace
