// SPDX-License-Identifier: MIT
// Literals are constants with the exact value. literal() is used here as the operators use it;
// compile_test.py checks that literals that are out of range or malformed do not compile.
#include <gtest/gtest.h>

#include <fixedpoint/literals.hpp>
#include <fixedpoint/text.hpp>
#include <random>
#include <string>

namespace {

using namespace fixedpoint;
using namespace fixedpoint::literals;

static_assert((0.38_q16_16).raw() == 24904, "0.38 2^16 = 24903.68");
static_assert((-0.38_q16_16).raw() == -24904, "the negative of the literal");
static_assert((32767.99999_q16_16).raw() == 0x7fffffff, "rounds to the largest number");
static_assert((7.9375_q4_4).raw() == 127, "the largest number");
static_assert((0.03125_q4_4).raw() == 1, "a tie rounds half up");
static_assert((0.031249999999999999999999_q4_4).raw() == 0,
              "which a double cannot tell from the tie");
static_assert((12_q8_8).raw() == 0xc00, "an integer");
static_assert((017_q8_8).raw() == 0x1100, "always decimal");
static_assert((1'000.5_q16_16).raw() == 0x3e88000, "digit separators");
static_assert((1e-3_q16_16).raw() == 66, "an exponent");
static_assert((127.99999_q8_16).raw() == 0x7fffff, "the largest number of 24 bits");
static_assert((-0.38_q12_12).raw() == -1556, "0.38 2^12 = 1556.48");
static_assert((.5_q8_8).raw() == 0x80, "no digit in front of the point");
static_assert((2147483647.9999999998_q32_32).raw() == INT64_MAX, "20 digits");
static_assert((3.14159265358979323846_q32_32).raw() == 13493037705, "pi 2^32 = 13493037704.52");

template <char... Text>
constexpr Fixed<1, 63> operator""_q1_63() {
    return literal<Fixed<1, 63>, Text...>();
}
static_assert((0.1_q1_63).raw() == 922337203685477581, "2^63 / 10 = 922337203685477580.8");

// What the operators reject, checked before they do.
constexpr bool is_decimal(const char* text, int length) {
    return portable::is_decimal_literal(text, text + length);
}
static_assert(is_decimal("1'000.5e-3", 10) && is_decimal("7.", 2) && is_decimal("1E+2", 4), "");
static_assert(!is_decimal("0x1", 3), "hexadecimal");
static_assert(!is_decimal("0b1", 3), "binary");
static_assert(!is_decimal("1.2.3", 5) && !is_decimal("1e", 2) && !is_decimal("1e+", 3), "");

// The constant of a literal is the number that the text parser reads, and is out of range exactly
// when the parser says so.
template <int I, int F>
void expect_as_parsed(const std::string& text) {
    using Number = Fixed<I, F>;
    const auto parsed = parse<Number>(text.data(), text.size());
    const auto literal =
        portable::parse_literal<typename Number::Raw, F>(text.data(), text.data() + text.size());
    ASSERT_EQ(literal.fits, parsed.status == TextStatus::ok) << text;
    ASSERT_TRUE(!literal.fits || literal.number == parsed.number.raw()) << text;
}

TEST(Literals, AreWhatTheParserReads) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 100000; ++i) {
        std::string text = std::to_string(random() >> random() % 64);
        if (random() % 2) text.insert(random() % (text.size() + 1), ".");
        if (text == ".") continue;
        if (random() % 2) text += "e" + std::to_string(static_cast<int>(random() % 40) - 25);
        expect_as_parsed<4, 4>(text);
        expect_as_parsed<8, 24>(text);
        expect_as_parsed<16, 16>(text);
        expect_as_parsed<32, 32>(text);
        expect_as_parsed<1, 63>(text);
    }
}

TEST(Literals, AreTheNumbersThatTheTextSays) {
    EXPECT_EQ(1.5_q16_16, parse<Q16_16>("1.5", 3).number);
    EXPECT_EQ(0.1_q32_32, parse<Q32_32>("0.1", 3).number);
}

}  // namespace
