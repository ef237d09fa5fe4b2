// SPDX-License-Identifier: MIT
// Conversions against exact arithmetic: between formats, integers, float and double, and from
// integers with decimals.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstring>
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/conversion.hpp>
#include <limits>
#include <type_traits>

#include "subjects.hpp"

namespace {

using namespace fixedpoint;

// One pair of types: a format, or an integer type as the format without fraction bits.
struct Type {
    int width, fraction;
    bool is_signed;
};
struct Pair {
    Type to, from;
    void (*compute)(int64_t a, int64_t* wrapped, int64_t* saturated, bool* fits);
};
template <class Raw, int F>
constexpr Type type = {8 * static_cast<int>(sizeof(Raw)), F, Raw(-1) < Raw(1)};
template <class To, int ToF, class From, int FromF>
constexpr Pair pair = {type<To, ToF>, type<From, FromF>,
                       [](int64_t n, int64_t* wrapped, int64_t* saturated, bool* fits) {
                           const From a = static_cast<From>(n);
                           const auto result = portable::convert_saturated<To, ToF, From, FromF>(a);
                           *wrapped =
                               static_cast<int64_t>(portable::convert<To, ToF, From, FromF>(a));
                           *saturated = static_cast<int64_t>(result.number);
                           *fits = result.fits;
                       }};

// Between this and every format below.
template <class Raw, int F>
void add_pairs(std::vector<Pair>& pairs) {
    pairs.insert(pairs.end(), {pair<Raw, F, int8_t, 0>,
                               pair<Raw, F, int8_t, 4>,
                               pair<Raw, F, int8_t, 7>,
                               pair<Raw, F, int16_t, 8>,
                               pair<Raw, F, Int24, 16>,
                               pair<Raw, F, int32_t, 16>,
                               pair<Raw, F, int32_t, 31>,
                               pair<Raw, F, int64_t, 32>,
                               pair<Raw, F, int64_t, 63>,
                               pair<Raw, F, signed char, 0>,
                               pair<Raw, F, unsigned char, 0>,
                               pair<Raw, F, unsigned short, 0>,
                               pair<Raw, F, int, 0>,
                               pair<Raw, F, unsigned, 0>,
                               pair<Raw, F, long long, 0>,
                               pair<Raw, F, unsigned long long, 0>,
                               pair<unsigned char, 0, Raw, F>,
                               pair<short, 0, Raw, F>,
                               pair<unsigned short, 0, Raw, F>,
                               pair<int, 0, Raw, F>,
                               pair<unsigned, 0, Raw, F>,
                               pair<unsigned long long, 0, Raw, F>});
}

TEST(Conversion, BetweenFormatsAndIntegersIsTheNearestNumber) {
    std::vector<Pair> pairs;
    add_pairs<int8_t, 0>(pairs);
    add_pairs<int8_t, 4>(pairs);
    add_pairs<int8_t, 7>(pairs);
    add_pairs<int16_t, 8>(pairs);
    add_pairs<int16_t, 15>(pairs);
    add_pairs<Int24, 0>(pairs);
    add_pairs<Int24, 12>(pairs);
    add_pairs<Int24, 23>(pairs);
    add_pairs<UnsignedInt24, 0>(pairs);
    add_pairs<int32_t, 0>(pairs);
    add_pairs<int32_t, 16>(pairs);
    add_pairs<int32_t, 31>(pairs);
    add_pairs<int64_t, 0>(pairs);
    add_pairs<int64_t, 32>(pairs);
    add_pairs<int64_t, 63>(pairs);
    for (const Pair& pair : pairs) {
        SCOPED_TRACE(testing::Message()
                     << pair.from.width << " bits, F = " << pair.from.fraction << " to "
                     << pair.to.width << " bits, F = " << pair.to.fraction);
        std::vector<int64_t> operands = exact::raws(pair.from.width, 10);
        if (operands.size() > 60000) operands.erase(operands.begin() + 3000, operands.end() - 3000);
        for (const int64_t a : operands) {
            int64_t wrapped, saturated;
            bool fits;
            pair.compute(a, &wrapped, &saturated, &fits);
            const __int128 mask = (static_cast<__int128>(1) << pair.from.width) - 1;
            const exact::Rounded expected = exact::scale(
                pair.from.is_signed ? static_cast<__int128>(a) : a & mask,
                pair.to.fraction - pair.from.fraction, pair.to.width, pair.to.is_signed);
            ASSERT_EQ(wrapped, expected.wrapped) << a;
            ASSERT_EQ(saturated, expected.saturated) << a;
            ASSERT_EQ(fits, expected.fits) << a;
        }
    }
}

// x as mantissa and exponent.
template <class Float>
std::pair<int64_t, int> parts(Float x) {
    int exponent = 0;
    const Float mantissa = std::ldexp(std::frexp(x, &exponent), std::numeric_limits<Float>::digits);
    return {static_cast<int64_t>(mantissa), exponent - std::numeric_limits<Float>::digits};
}

template <class Raw, int F, class Float>
void check_from_float(Float x) {
    const auto [mantissa, exponent] = parts(x);
    const exact::Rounded expected = exact::binary(mantissa, exponent, {RawLimits<Raw>::width, F});
    const auto result = portable::from_float<Raw, F>(x);
    ASSERT_EQ(result.number, expected.saturated) << x;
    ASSERT_EQ(result.fits, expected.fits) << x;
}

template <class Raw, int F, class Float>
void check_floating_point() {
    SCOPED_TRACE(testing::Message() << RawLimits<Raw>::width << " bits, F = " << F);
    using Limits = std::numeric_limits<Float>;
    constexpr Float infinity = Limits::infinity();
    const std::vector<int64_t> operands = exact::raws(RawLimits<Raw>::width, 10);
    // Only a fifth of the 16-bit operands.
    for (std::size_t i = 0; i<operands.size(); i += operands.size()> 60000 ? 5 : 1) {
        const auto a = static_cast<Raw>(operands[i]);
        const Float x = portable::to_float<Float, Raw, F>(a);
        const auto [mantissa, exponent] = parts(x);
        ASSERT_TRUE(exact::is_nearest_float(a, mantissa, exponent, Limits::digits,
                                            {RawLimits<Raw>::width, F}))
            << +a;
        // Numbers halfway between two raw ones, if a Float can represent them, and their
        // neighbours.
        const Float ulp = std::ldexp(Float(1), -F);
        for (const Float offset : {Float(0), Float(0.25), Float(0.5), Float(0.75)}) {
            const Float y = x + offset * ulp;
            check_from_float<Raw, F>(y);
            check_from_float<Raw, F>(std::nextafter(y, infinity));
            check_from_float<Raw, F>(std::nextafter(y, -infinity));
        }
        if (testing::Test::HasFatalFailure()) return;
    }
    for (const Float x : {Float(0), -Float(0), Limits::max(), Limits::lowest(), Limits::min(),
                          Limits::denorm_min(), -Limits::denorm_min()}) {
        check_from_float<Raw, F>(x);
    }
    for (const bool negative : {false, true}) {
        const auto result = portable::from_float<Raw, F>(negative ? -infinity : infinity);
        EXPECT_EQ(result.number, negative ? RawLimits<Raw>::min : RawLimits<Raw>::max);
        EXPECT_FALSE(result.fits);
        const auto none =
            portable::from_float<Raw, F>(negative ? -Limits::signaling_NaN() : Limits::quiet_NaN());
        EXPECT_EQ(none.number, 0);
        EXPECT_FALSE(none.fits);
    }
}

template <class Float>
void check_floating_point_of_formats() {
    check_floating_point<int8_t, 0, Float>();
    check_floating_point<int8_t, 4, Float>();
    check_floating_point<int8_t, 7, Float>();
    check_floating_point<int16_t, 8, Float>();
    check_floating_point<int16_t, 15, Float>();
    check_floating_point<Int24, 0, Float>();
    check_floating_point<Int24, 16, Float>();
    check_floating_point<Int24, 23, Float>();
    check_floating_point<int32_t, 0, Float>();
    check_floating_point<int32_t, 16, Float>();
    check_floating_point<int32_t, 31, Float>();
    check_floating_point<int64_t, 0, Float>();
    check_floating_point<int64_t, 32, Float>();
    check_floating_point<int64_t, 63, Float>();
}
TEST(Conversion, FromAndToFloat) { check_floating_point_of_formats<float>(); }
TEST(Conversion, FromAndToDouble) { check_floating_point_of_formats<double>(); }

template <class Raw, int F, class Int>
void check_decimals(int stride) {
    const std::vector<int64_t> numbers = exact::raws(RawLimits<Int>::width, 5);
    for (std::size_t i = 0; i < numbers.size(); i += static_cast<std::size_t>(stride)) {
        for (const uint8_t decimals : {0, 1, 3, 9, 18, 19, 20, 255}) {
            const exact::Rounded expected =
                exact::decimal(numbers[i], decimals, {RawLimits<Raw>::width, F});
            const auto result =
                portable::from_decimal<Raw, F>(static_cast<Int>(numbers[i]), decimals);
            ASSERT_EQ(result.number, expected.saturated) << numbers[i] << " e-" << +decimals;
            ASSERT_EQ(result.fits, expected.fits) << numbers[i] << " e-" << +decimals;
        }
    }
}
TEST(Conversion, FromIntegersWithDecimals) {
    check_decimals<int8_t, 4, int16_t>(17);
    check_decimals<int16_t, 8, int16_t>(17);
    check_decimals<Int24, 16, int16_t>(17);
    check_decimals<Int24, 12, Int24>(1);
    check_decimals<Int24, 23, int64_t>(1);
    check_decimals<int32_t, 16, int16_t>(17);
    check_decimals<int32_t, 16, int64_t>(1);
    check_decimals<int32_t, 31, int32_t>(1);
    check_decimals<int64_t, 0, int64_t>(1);
    check_decimals<int64_t, 32, int32_t>(1);
    check_decimals<int64_t, 63, int64_t>(1);
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
    EXPECT_EQ(from_float<Q8_8>(1e9f), Q8_8::max());
    EXPECT_FALSE(from_float_checked<Q8_8>(1e9f).fits);
    EXPECT_EQ(from_decimal<Q4_4>(-1000, 1), Q4_4::min());
    EXPECT_FALSE(from_decimal_checked<Q4_4>(-1000, 1).fits);
}

// An integer does not have an arithmetic of its own.
TEST(PublicConversion, ToAnIntegerIsInTheArithmeticOfTheSource) {
    const auto raw = 300 << 16;
    EXPECT_EQ(convert<int8_t>(Q16_16::from_raw(raw)), 44);
    EXPECT_EQ(convert<int8_t>(Fixed<16, 16, Saturating>::from_raw(raw)), 127);
    EXPECT_EQ(convert<uint8_t>(Fixed<16, 16, Saturating>::from_raw(-raw)), 0);
}

static_assert(from_decimal<Q16_16>(38, 2).raw() == 24904, "0.38 2^16 = 24903.68");
static_assert(from_float<Q16_16>(0.38).raw() == 24904, "a constant on the host");
static_assert(to_float<float>(Q8_8::from_raw(0x180)) == 1.5f, "1.5 is exact");
static_assert(convert<Q4_4>(convert<Q32_32>(Q4_4::min())) == Q4_4::min(), "there and back");

}  // namespace
