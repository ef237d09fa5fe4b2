// SPDX-License-Identifier: MIT
// Streams, fmt, std::hash and std::numeric_limits of fixed-point numbers.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fixedpoint/arithmetic/checked.hpp>
#include <fixedpoint/arithmetic/published.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/arithmetic/small.hpp>
#include <fixedpoint/conversion.hpp>
#include <fixedpoint/host/format.hpp>
#include <fixedpoint/host/hash.hpp>
#include <fixedpoint/host/limits.hpp>
#include <fixedpoint/host/stream.hpp>
#include <fixedpoint/literals.hpp>
#include <iomanip>
#include <sstream>
#include <unordered_set>

namespace {

using namespace fixedpoint;
using namespace fixedpoint::literals;

template <class... Parts>
std::string streamed(const Parts&... parts) {
    std::ostringstream stream;
    (stream << ... << parts);
    return stream.str();
}

TEST(OutputStream, WritesTheShortestTextOrThePrecision) {
    EXPECT_EQ(streamed(0.38_q16_16), "0.38");
    EXPECT_EQ(streamed(std::setprecision(2), 0.123_q16_16), "0.123");
    EXPECT_EQ(streamed(std::fixed, 0.38_q16_16), "0.380005");
    EXPECT_EQ(streamed(std::fixed, std::setprecision(0), 2.5_q16_16), "3");
    EXPECT_EQ(streamed(std::fixed, std::setprecision(3), -2.5_q16_16), "-2.500");
    EXPECT_EQ(streamed(std::fixed, std::setprecision(1), -0.01_q16_16), "0.0");
    EXPECT_EQ(streamed(std::fixed, std::setprecision(1000), 1_q8_8), "1." + std::string(255, '0'));
}

TEST(OutputStream, HonoursWidthFillAndSign) {
    EXPECT_EQ(streamed('[', std::setw(8), -1.5_q8_8, ']'), "[    -1.5]");
    EXPECT_EQ(streamed(std::setw(6), std::setfill('*'), std::left, 1.5_q8_8, '|'), "1.5***|");
    EXPECT_EQ(streamed(std::internal, std::setw(8), -1.5_q8_8, '|'), "-    1.5|");
    EXPECT_EQ(streamed(std::internal, std::setfill('0'), std::setw(6), 1.5_q8_8, '|'), "0001.5|");
    EXPECT_EQ(streamed(std::showpos, 1.5_q8_8, ' ', -1.5_q8_8, ' ', 0_q8_8), "+1.5 -1.5 +0");
}

// As for a double of the same value.
TEST(OutputStream, PadsAsOfDouble) {
    for (const auto adjust : {std::left, std::right, std::internal}) {
        for (const auto sign : {std::showpos, std::noshowpos}) {
            for (const int width : {0, 3, 4, 5, 9}) {
                const auto set = std::setw(width);
                EXPECT_EQ(streamed(std::setfill('*'), adjust, sign, set, -1.5_q8_8, set, 1.5_q8_8),
                          streamed(std::setfill('*'), adjust, sign, set, -1.5, set, 1.5));
            }
        }
    }
}

struct Extraction {
    const char* text;
    double number;
    bool fails;
    const char* rest;
};

TEST(InputStream, TakesWhatMayBeANumberAndSaysSo) {
    const Extraction table[] = {
        {"1.5", 1.5, false, ""},          // up to the end
        {"  -1.5 2", -1.5, false, " 2"},  // leading white space is skipped
        {"1.5abc", 1.5, false, "abc"},    // the rest stays in the stream
        {"1.5.5", 1.5, false, ".5"},      // one point
        {"1e1e1", 10, false, "e1"},       // one exponent
        {"1-2", 1, false, "-2"},          // a sign only at the start
        {"+.5e+1,", 5, false, ","},       // every part of a number
        {"200", 127.99609375, true, ""},  // out of range: the limit
        {"-200;", -128, true, ";"},       //
        {"abc", 0, true, "abc"},          // no number
        {"-x", 0, true, "x"},             // a sign alone
        {"1ex", 0, true, "x"},            // an exponent without digits
        {"", 0, true, ""},                // nothing
    };
    for (const Extraction& row : table) {
        std::istringstream stream(row.text);
        Q8_8 number = 0_q8_8;
        stream >> number;
        EXPECT_EQ(number.raw() / 256.0, row.number) << row.text;
        EXPECT_EQ(stream.fail(), row.fails) << row.text;
        stream.clear();
        std::string rest;
        std::getline(stream, rest);
        EXPECT_EQ(rest, row.rest) << row.text;
    }
}

RC_GTEST_PROP(StreamProperty, TextReadsBack, (int32_t a, int64_t b)) {
    std::stringstream stream;
    stream << Q16_16::from_raw(a) << ' ' << Q32_32::from_raw(b);
    Q16_16 x;
    Q32_32 y;
    RC_ASSERT(bool(stream >> x >> y));
    RC_ASSERT(x.raw() == a);
    RC_ASSERT(y.raw() == b);
}

TEST(Format, HonoursDecimalsWidthFillAndAlignment) {
    const Q16_16 x = -0.38_q16_16;
    EXPECT_EQ(fmt::format("{}", x), "-0.38");
    EXPECT_EQ(fmt::format("{:.3f}", x), "-0.380");
    EXPECT_EQ(fmt::format("{:.3}", x), "-0.380");
    EXPECT_EQ(fmt::format("{:f}", x), "-0.38");
    EXPECT_EQ(fmt::format("{:8}|", x), "   -0.38|");
    EXPECT_EQ(fmt::format("{:<8}|", x), "-0.38   |");
    EXPECT_EQ(fmt::format("{:^8}|", x), " -0.38  |");
    EXPECT_EQ(fmt::format("{:.>9.1f}", x), ".....-0.4");
    EXPECT_EQ(fmt::format("{:>>7}", x), ">>-0.38");
    EXPECT_EQ(fmt::format("{:2}", x), "-0.38");
    EXPECT_EQ(fmt::format("{:.0f} {}", x, 1), "0 1");
}

TEST(Format, PadsAsOfDouble) {
    for (const char* text :
         {"{:08}", "{:8}", "{:*<8}", "{:06.2f}", "{:02}", "{:0}", "{:*>9.2f}", "{:010.3f}"}) {
        for (const double x : {-1.5, 1.5, 0.25, -0.25}) {
            const auto number = from_float<Q8_8>(x);
            // Numbers are right-aligned by default.
            EXPECT_EQ(fmt::format(fmt::runtime(text), number), fmt::format(fmt::runtime(text), x))
                << text << " of " << x;
        }
    }
}

TEST(Format, RefusesWhatItDoesNotKnow) {
    for (const char* text :
         {"{:x}", "{:.}", "{:.3g}", "{:3.2.1}", "{:256}", "{:.256f}", "{:>>>5}"}) {
        EXPECT_THROW((void)fmt::format(fmt::runtime(text), 1_q16_16), fmt::format_error) << text;
    }
}

TEST(Hash, TellsNumbersApart) {
    const std::unordered_set<Q16_16> numbers = {1.5_q16_16, 1.5_q16_16, -1.5_q16_16};
    EXPECT_EQ(numbers.size(), 2u);
    EXPECT_TRUE(numbers.contains(1.5_q16_16));
    const std::unordered_set<Q8_16> of_24_bits = {1.5_q8_16, 1.5_q8_16, -1.5_q8_16};
    EXPECT_EQ(of_24_bits.size(), 2u);
}

TEST(Text, IsReadFromStrings) {
    EXPECT_EQ(parse<Q8_8>(std::string("-1.5")).number, -1.5_q8_8);
    EXPECT_EQ(parse<Q8_8>("1.5").number, 1.5_q8_8);
    EXPECT_EQ(parse<Q8_8>("1.5x").position, 3u);
    EXPECT_EQ(parse<Q8_8>("").status, TextStatus::empty);
}

// Whether max() + ulp() is min(), as is_modulo says.
template <class Arithmetic>
constexpr bool is_modulo_as_it_says() {
    using Number = Fixed<8, 8, Arithmetic>;
    const bool wraps = Number::max() + Number::ulp() == Number::min();
    return wraps == std::numeric_limits<Number>::is_modulo;
}
struct Silent {
    static constexpr void notify(Event, fixedpoint::Operation) {}
};
static_assert(is_modulo_as_it_says<Nearest>() && is_modulo_as_it_says<Small>(), "");
static_assert(is_modulo_as_it_says<Saturating>() && is_modulo_as_it_says<Published>(), "");
static_assert(is_modulo_as_it_says<Checked<Silent>>(), "");
static_assert(std::numeric_limits<Q8_16>::round_error() == 0.5_q8_16, "");
static_assert(std::numeric_limits<Q12_12>::lowest() == -2048, "");

using Limits = std::numeric_limits<Q16_16>;
static_assert(Limits::is_exact && Limits::is_bounded && Limits::radix == 2, "");
static_assert(Limits::round_style == std::round_to_nearest && Limits::max_digits10 == 0, "");
static_assert(Limits::denorm_min() == Q16_16::ulp() && Limits::infinity() == Q16_16(), "");
static_assert(Limits::is_specialized && Limits::is_signed && !Limits::is_integer, "");
static_assert(Limits::max() == Q16_16::max() && Limits::lowest() == Q16_16::min(), "");
static_assert(Limits::min() == Q16_16::ulp() && Limits::epsilon() == Q16_16::ulp(), "");
static_assert(Limits::round_error() == 0.5_q16_16, "");
static_assert(Limits::digits == 31 && Limits::digits10 == 8, "4 decimal digits on either side");
static_assert(std::numeric_limits<Fixed<1, 63>>::round_error().raw() == int64_t(1) << 62, "");
static_assert(std::numeric_limits<Fixed<32, 0>>::min().raw() == INT32_MIN, "as of an int");

}  // namespace
