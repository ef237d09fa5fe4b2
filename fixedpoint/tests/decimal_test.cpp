// SPDX-License-Identifier: MIT
// Decimal text against exact integers: every number of 8 and 16 bits and boundary numbers of wider
// formats, printed, read back, and read from text between two numbers; malformed text; buffers and
// texts without a spare byte.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <fixedpoint/text.hpp>
#include <random>
#include <string>
#include <utility>

#include "exact.hpp"
#include "exact_integer.hpp"

namespace {

using namespace fixedpoint;
using exact::Int;

// n / 10^decimals as text.
std::string decimal_text(const Int& n, unsigned decimals) {
    std::string digits = Int(abs(n)).str();
    if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
    if (decimals > 0) digits.insert(digits.size() - decimals, 1, '.');
    return (n < 0 ? "-" : "") + digits;
}

// The result of parse, independent of the format.
struct Read {
    int64_t number;
    TextStatus status;
    size_t position;
};

// From a copy on the heap that ends where the text ends, so that the sanitizer detects reads beyond
// it.
template <class Raw, int F>
Read parse_text(const std::string& text) {
    const std::vector<char> copy(text.begin(), text.end());
    const auto result = portable::parse_decimal<Raw, F>(copy.data(), copy.size());
    return {result.number, result.status, result.position};
}

// The functions of a format as plain functions, so that the checks are compiled once.
struct Format {
    int width, fraction;
    size_t capacity;
    Read (*parse)(const std::string& text);
    size_t (*print)(int64_t a, char* text, size_t capacity);
    size_t (*print_rounded)(int64_t a, uint8_t decimals, char* text, size_t capacity);
    size_t (*rounded_capacity)(uint8_t decimals);

    std::string text(int64_t a) const {
        std::vector<char> buffer(capacity);
        return {buffer.data(), print(a, buffer.data(), buffer.size())};
    }
    std::string text(int64_t a, uint8_t decimals) const {
        std::vector<char> buffer(rounded_capacity(decimals));
        return {buffer.data(), print_rounded(a, decimals, buffer.data(), buffer.size())};
    }
};
template <class Raw, int F>
Format format() {
    return {
        RawLimits<Raw>::width,
        F,
        portable::decimal_capacity<Raw, F>(),
        parse_text<Raw, F>,
        [](int64_t a, char* text, size_t capacity) -> size_t {
            return portable::print_decimal<Raw, F>(static_cast<Raw>(a), text, capacity);
        },
        [](int64_t a, uint8_t decimals, char* text, size_t capacity) -> size_t {
            return portable::print_decimal<Raw, F>(static_cast<Raw>(a), decimals, text, capacity);
        },
        [](uint8_t decimals) -> size_t { return portable::decimal_capacity<Raw, F>(decimals); }};
}

// Checks that the text is read as n / 10^decimals must be.
void check_parse(const Format& format, const std::string& text, const Int& n, unsigned decimals) {
    const Int expected = exact::nearest(n << format.fraction, exact::power(10, decimals));
    const Read result = format.parse(text);
    ASSERT_EQ(result.number, exact::saturated(expected, format.width)) << text;
    ASSERT_EQ(result.status,
              exact::fits(expected, format.width) ? TextStatus::ok : TextStatus::out_of_range)
        << text;
    ASSERT_EQ(result.position, text.size()) << text;
}

class Decimal : public testing::TestWithParam<Format> {
  protected:
    const Format format = GetParam();
    const int F = format.fraction;
};
INSTANTIATE_TEST_SUITE_P(
    Formats, Decimal,
    testing::Values(format<int8_t, 0>(), format<int8_t, 1>(), format<int8_t, 2>(),
                    format<int8_t, 4>(), format<int8_t, 7>(), format<int16_t, 0>(),
                    format<int16_t, 1>(), format<int16_t, 8>(), format<int16_t, 15>(),
                    format<Int24, 0>(), format<Int24, 12>(), format<Int24, 16>(),
                    format<Int24, 23>(), format<int32_t, 0>(), format<int32_t, 16>(),
                    format<int32_t, 24>(), format<int32_t, 31>(), format<int64_t, 0>(),
                    format<int64_t, 32>(), format<int64_t, 62>(), format<int64_t, 63>()),
    [](const auto& info) {
        return "Of" + std::to_string(info.param.width) + "BitsWithFraction" +
               std::to_string(info.param.fraction);
    });

TEST_P(Decimal, PrintsTheShortestAndClosestThatReadsBack) {
    for (const int64_t a : exact::raws(format.width)) {
        // The smallest number of decimals at which the closest decimal is read as a.
        Int closest;
        unsigned decimals = 0;
        for (Int power = 1;; ++decimals, power = 10 * power) {
            closest = exact::nearest(a * power, Int(1) << F);
            if (exact::nearest(closest << F, power) == a) break;
        }
        const std::string text = format.text(a);
        ASSERT_EQ(text, decimal_text(closest, decimals)) << a;
        const Read result = format.parse(text);
        ASSERT_EQ(result.number, a) << text;
        ASSERT_EQ(result.status, TextStatus::ok) << text;
    }
}

TEST_P(Decimal, PrintsDecimalsRounded) {
    for (const int decimals : {0, 1, 2, 5, F, F + 2}) {
        const Int power = exact::power(10, decimals);
        for (const int64_t a : exact::raws(format.width)) {
            const Int closest = exact::nearest(a * power, Int(1) << F);
            ASSERT_EQ(format.text(a, static_cast<uint8_t>(decimals)),
                      decimal_text(closest, decimals))
                << a;
        }
    }
}

TEST_P(Decimal, ReadsNumbersBetweenTwoOthers) {
    const std::vector<int64_t> numbers = exact::raws(format.width);
    const Int scale = exact::power(10, 90), half = exact::power(5, F + 1);
    // Every number of 8 bits and some of the others, since each has three long texts.
    const int step = exact::operand_step * (format.width == 8 ? 1 : 7);
    for (size_t i = 0; i < numbers.size(); i += step) {
        // The tie above it, (a + 1/2) / 2^F, which has F + 1 decimals, and then its close
        // neighbours.
        const Int tie = (2 * Int(numbers[i]) + 1) * half;
        check_parse(format, decimal_text(tie, F + 1), tie, F + 1);
        for (const Int& n : {tie * scale - 1, tie * scale, tie * scale + 1})
            check_parse(format, decimal_text(n, F + 91), n, F + 91);
        if (HasFatalFailure()) return;
    }
}

TEST_P(Decimal, ReadsExponents) {
    for (const int n : {0, 1, -1, 5, -25, 127, -128, 32767, -12345678}) {
        for (int exponent = -40; exponent <= 40; ++exponent) {
            const std::string digits = std::to_string(n);
            const Int up = exact::power(10, std::max(exponent, 0));
            check_parse(format, digits + "e" + std::to_string(exponent), Int(n) * up,
                        std::max(-exponent, 0));
            check_parse(format,
                        digits + ".250E" + (exponent < 0 ? "" : "+") + std::to_string(exponent),
                        (Int(n) * 1000 + (n < 0 ? -250 : 250)) * up, std::max(-exponent, 0) + 3);
        }
    }
}

TEST_P(Decimal, ReportsABufferThatIsTooSmall) {
    for (const int64_t a :
         {exact::smallest(format.width), exact::largest(format.width), int64_t(-3)}) {
        const size_t shortest = format.text(a).size(), rounded = format.text(a, 9).size();
        for (size_t capacity = 0; capacity <= rounded + shortest; ++capacity) {
            std::vector<char> buffer(capacity);
            ASSERT_EQ(format.print(a, buffer.data(), capacity), capacity < shortest ? 0 : shortest);
            ASSERT_EQ(format.print_rounded(a, 9, buffer.data(), capacity),
                      capacity < rounded ? 0 : rounded);
        }
    }
}

TEST_P(Decimal, CapacityIsReached) {
    EXPECT_EQ(format.text(exact::smallest(format.width), static_cast<uint8_t>(F)).size(),
              format.capacity - (F == 0 ? 1 : 0));
}

template <class Word>
void check_digit_steps() {
    const Int one = Int(1) << 8 * sizeof(Word);
    for (int digit = 0; digit <= 9; ++digit) {
        // The smallest fraction that begins with this digit, and its neighbours.
        const Int first = -exact::floor_of(-digit * one, 10);
        for (int offset = -1; offset <= 1; ++offset) {
            const Int bits = std::clamp(first + offset, Int(0), one - 1);
            const auto word = static_cast<Word>(static_cast<uint64_t>(bits));
            portable::DecimalFraction<Word> fraction = {word, false};
            ASSERT_EQ(fraction.take(), exact::floor_of(10 * bits, one)) << bits;
            ASSERT_EQ(fraction.bits, 10 * bits % one) << bits;

            fraction = {word, false};
            fraction.prepend(static_cast<uint8_t>(digit));
            ASSERT_EQ(fraction.bits, (digit * one + bits) / 10) << bits;
            ASSERT_EQ(fraction.inexact, (digit * one + bits) % 10 != 0) << bits;
        }
    }
}

TEST(DecimalFraction, GivesAndTakesDigitsExactly) {
    check_digit_steps<uint32_t>();
    check_digit_steps<uint64_t>();
}

TEST(DecimalText, DoesNotWrapAroundTheWord) {
    for (int offset = -10; offset <= 20; ++offset) {
        for (const int bits : {32, 64}) {
            const Int n = (Int(1) << bits) + offset;
            check_parse(format<int8_t, 0>(), n.str(), n, 0);
            check_parse(format<int32_t, 0>(), n.str(), n, 0);
            check_parse(format<int64_t, 0>(), n.str(), n, 0);
            check_parse(format<int64_t, 0>(), "-" + n.str(), -n, 0);
        }
    }
}

struct Malformed {
    const char* text;
    TextStatus status;
    size_t position;
};

TEST(DecimalText, SaysWhereItIsMalformed) {
    const Malformed table[] = {
        {"", TextStatus::empty, 0},           // nothing
        {" ", TextStatus::malformed, 0},      // no leading white space
        {" 1", TextStatus::malformed, 0},     //
        {"1 ", TextStatus::malformed, 1},     // no trailing white space
        {"+", TextStatus::malformed, 1},      // a sign alone
        {"-", TextStatus::malformed, 1},      //
        {"--1", TextStatus::malformed, 1},    // one sign
        {"+-1", TextStatus::malformed, 1},    //
        {".", TextStatus::malformed, 1},      // a point alone
        {"-.", TextStatus::malformed, 2},     //
        {"..1", TextStatus::malformed, 1},    // one point
        {"1.2.3", TextStatus::malformed, 3},  //
        {"1,5", TextStatus::malformed, 1},    // a comma is not a point
        {"e5", TextStatus::malformed, 0},     // an exponent alone
        {".e5", TextStatus::malformed, 1},    //
        {"1e", TextStatus::malformed, 2},     // an exponent without digits
        {"1e+", TextStatus::malformed, 3},    //
        {"1e-x", TextStatus::malformed, 3},   //
        {"1e1.5", TextStatus::malformed, 3},  // an exponent is an integer
        {"1e5e5", TextStatus::malformed, 3},  //
        {"0x1p3", TextStatus::malformed, 1},  // decimal only
        {"inf", TextStatus::malformed, 0},    // no infinities
        {"nan", TextStatus::malformed, 0},    //
        {"12a", TextStatus::malformed, 2},    // the first bad character
        {"1\xff", TextStatus::malformed, 1},  // beyond ASCII
        {"\x2f", TextStatus::malformed, 0},   // the character before 0
        {"\x3a", TextStatus::malformed, 0},   // the character after 9
    };
    for (const Malformed& row : table) {
        const auto result = parse_text<int32_t, 16>(row.text);
        EXPECT_EQ(result.status, row.status) << row.text;
        EXPECT_EQ(result.position, row.position) << row.text;
        EXPECT_EQ(result.number, 0) << row.text;
    }
    const auto zero_byte = parse_text<int32_t, 16>(std::string("1\0", 2));
    EXPECT_EQ(zero_byte.status, TextStatus::malformed);
    EXPECT_EQ(zero_byte.position, 1u);
}

TEST(DecimalText, ReadsEveryWellFormedShape) {
    for (const char* text : {"1.5", "+1.5", "1.50", "01.5", "15e-1", "15E-1", "0.15e1", ".15e+1",
                             "150.e-2", "1.5e0", "1.5e-0", "1.5e00000000000000000000000000"}) {
        EXPECT_EQ((parse_text<int16_t, 8>(text).number), 0x180) << text;
        EXPECT_EQ((parse_text<int16_t, 8>(text).status), TextStatus::ok) << text;
    }
    EXPECT_EQ((parse_text<int16_t, 8>("-0").number), 0);
    EXPECT_EQ((parse_text<int16_t, 8>("2.").number), 0x200);
}

TEST(DecimalText, TakesExponentsAndDigitsOfAnyLength) {
    const std::string nines(40, '9');
    EXPECT_EQ((parse_text<int64_t, 32>("1e" + nines).status), TextStatus::out_of_range);
    EXPECT_EQ((parse_text<int64_t, 32>("-1e" + nines).number), std::numeric_limits<int64_t>::min());
    EXPECT_EQ((parse_text<int64_t, 32>("1e-" + nines).number), 0);
    EXPECT_EQ((parse_text<int64_t, 32>("0e" + nines).status), TextStatus::ok);
    EXPECT_EQ((parse_text<int32_t, 0>(nines).number), std::numeric_limits<int32_t>::max());
    const std::string zeros(1000000, '0');
    EXPECT_EQ((parse_text<int16_t, 8>("0." + zeros + "15e1000001").number), 0x180);
    EXPECT_EQ((parse_text<int16_t, 8>("15" + zeros + "e-1000001").number), 0x180);
    // The last of many digits decides the tie of a negative number.
    EXPECT_EQ((parse_text<int16_t, 8>("-0.001953125" + zeros).number), 0);
    EXPECT_EQ((parse_text<int16_t, 8>("-0.001953125" + zeros + "1").number), -1);
}

void random_text(const Format& format, bool negative, const std::vector<uint8_t>& digits,
                 size_t point, int exponent) {
    Int n = 0;
    std::string text = negative ? "-" : "";
    point = std::min(point, digits.size());
    for (size_t i = 0; i < digits.size(); ++i) {
        if (i == point) text += '.';
        text += static_cast<char>('0' + digits[i]);
        n = n * 10 + digits[i];
    }
    if (negative) n = -n;
    const int decimals = static_cast<int>(digits.size() - point) - exponent;
    check_parse(format, text + "e" + std::to_string(exponent),
                n * exact::power(10, std::max(-decimals, 0)), std::max(decimals, 0));
}

RC_GTEST_PROP(DecimalProperty, RandomText, (bool negative)) {
    const auto digits = *rc::gen::nonEmpty(
        rc::gen::container<std::vector<uint8_t>>(rc::gen::inRange<uint8_t>(0, 10)));
    const auto point = *rc::gen::inRange<size_t>(0, 12);
    const auto exponent = *rc::gen::inRange(-12, 12);
    for (const Format& each : {format<int8_t, 4>(), format<int16_t, 15>(), format<int32_t, 16>(),
                               format<int64_t, 32>(), format<int64_t, 63>()})
        random_text(each, negative, digits, point, exponent);
}

RC_GTEST_PROP(DecimalProperty, AnyBytesAreReadOrRefused, (const std::string& text)) {
    const auto result = parse_text<int32_t, 16>(text);
    RC_ASSERT(result.position <= text.size());
    RC_ASSERT((result.status == TextStatus::empty) == text.empty());
    if (result.status == TextStatus::ok) RC_ASSERT(result.position == text.size());
}

RC_GTEST_PROP(DecimalProperty, TextReadsBack, (int64_t raw)) {
    const Q32_32 x = Q32_32::from_raw(raw);
    char buffer[text_capacity<Q32_32>()];
    RC_ASSERT(parse<Q32_32>(buffer, print(x, buffer, sizeof buffer)).number == x);
    RC_ASSERT(parse<Q32_32>(buffer, print(x, 32, buffer, sizeof buffer)).number == x);
}

static_assert(parse<Q16_16>("0.38", 4).number.raw() == 24904, "0.38 2^16 = 24903.68");
static_assert(parse<Q8_8>("-128", 4).number == Q8_8::min(), "the smallest number has a text");
static_assert(parse<Q8_8>("128", 3).status == TextStatus::out_of_range,
              "and its negative has none");
static_assert(parse<Q8_8>("127.998", 7).status == TextStatus::ok, "rounds to the largest number");
static_assert(parse<Q8_8>("127.9981", 8).status == TextStatus::out_of_range, "rounds to 128");

template <int Bits, int... F, class Check>
void for_each_value(std::integer_sequence<int, F...>, Check check) {
    const auto of_split = [&]<int Fraction>() {
        using Number = Fixed<Bits - Fraction, Fraction>;
        for (int raw = RawLimits<Integer<Bits>>::min; raw <= RawLimits<Integer<Bits>>::max; ++raw)
            check(Number::from_raw(static_cast<Integer<Bits>>(raw)));
    };
    (of_split.template operator()<F>(), ...);
}

// Each text alone, with following text, and in a buffer one character too small.
TEST(CharsText, EveryValueOf8And16BitsReadsBackToTheLastBit) {
    int failures = 0;
    const auto check = [&](auto x) {
        char text[40];
        const ToCharsResult written = to_chars(text, text + sizeof text, x);
        *written.ptr = 'e';
        auto back = decltype(x)::from_raw(77);
        const FromCharsResult read = from_chars(text, written.ptr + 1, back);
        failures += written.ec != TextError::none || read.ec != TextError::none || back != x ||
                    read.ptr != written.ptr;
        failures += to_chars(text, written.ptr - 1, x).ec != TextError::value_too_large;
        const size_t length = print_raw(x, text, sizeof text);
        const auto raw = parse_raw<decltype(x)>(text, length);
        failures +=
            raw.status != TextStatus::ok || raw.number != x ||
            std::stoul(std::string(text, length), nullptr, 16) !=
                static_cast<unsigned long>(static_cast<Unsigned<decltype(x.raw())>>(x.raw()));
    };
    for_each_value<8>(std::make_integer_sequence<int, 8>(), check);
    for_each_value<16>(std::integer_sequence<int, 0, 3, 8, 13, 15>(), check);
    EXPECT_EQ(failures, 0);
}

TEST(CharsText, ReadsTheLongestNumberAsTheStandardDoes) {
    const struct {
        const char* text;
        std::ptrdiff_t length;
        TextError ec;
        double value;
    } cases[] = {{"1.5", 3, TextError::none, 1.5},
                 {"1.5kg", 3, TextError::none, 1.5},
                 {"-1.5e1 ", 6, TextError::none, -15},
                 {"15e", 2, TextError::none, 15},
                 {"15e+", 2, TextError::none, 15},
                 {"15E-1.5", 5, TextError::none, 1.5},
                 {"1.", 2, TextError::none, 1},
                 {".5.5", 2, TextError::none, 0.5},
                 {"1e9", 3, TextError::result_out_of_range, 7},
                 {"-99999999x", 9, TextError::result_out_of_range, 7},
                 {"", 0, TextError::invalid_argument, 7},
                 {"-", 0, TextError::invalid_argument, 7},
                 {".", 0, TextError::invalid_argument, 7},
                 {"-.e5", 0, TextError::invalid_argument, 7},
                 {"+1", 0, TextError::invalid_argument, 7},
                 {" 1", 0, TextError::invalid_argument, 7},
                 {"e5", 0, TextError::invalid_argument, 7}};
    for (const auto& expected : cases) {
        Q16_16 x = Q16_16::from_integer(7);
        const FromCharsResult read =
            from_chars(expected.text, expected.text + std::strlen(expected.text), x);
        EXPECT_EQ(read.ptr - expected.text, expected.length) << expected.text;
        EXPECT_EQ(static_cast<int>(read.ec), static_cast<int>(expected.ec)) << expected.text;
        EXPECT_EQ(x.raw(), expected.value * 65536) << expected.text;
        // Agrees with GCC's from_chars for double, except for the limits of a double.
        double standard = 7;
        const auto of_double =
            std::from_chars(expected.text, expected.text + std::strlen(expected.text), standard);
        EXPECT_EQ(of_double.ptr, read.ptr) << expected.text;
    }
}

TEST(LaidOutText, IsThatOfPrintf) {
    std::mt19937 random(3);
    for (int i = 0; i < 20000; ++i) {
        const Q16_16 x = Q16_16::from_raw(static_cast<int32_t>(random()) >> (random() % 31));
        const double value = x.raw() / 65536.0;
        const uint8_t width = static_cast<uint8_t>(random() % 25),
                      decimals = static_cast<uint8_t>(16 + random() % 3);
        const struct {
            Sign sign;
            char fill;
            const char* format;
        } layouts[] = {{Sign::minus_only, ' ', "%*.*f"}, {Sign::always, ' ', "%+*.*f"},
                       {Sign::space, ' ', "% *.*f"},     {Sign::minus_only, '0', "%0*.*f"},
                       {Sign::always, '0', "%+0*.*f"},   {Sign::space, '0', "% 0*.*f"}};
        for (const auto& each : layouts) {
            char expected[60], text[60];
            const int length =
                std::snprintf(expected, sizeof expected, each.format, width, decimals, value);
            const Layout layout(width, decimals, each.sign, each.fill);
            ASSERT_EQ(print(x, layout, text, sizeof text), static_cast<size_t>(length));
            ASSERT_EQ(std::string(text, static_cast<size_t>(length)), expected);
            ASSERT_EQ(print(x, layout, text, static_cast<size_t>(length) - 1), 0u);
        }
    }
    char text[8] = {};
    EXPECT_EQ(
        print(Q16_16::from_integer(-2), Layout(5, Layout::shortest, Sign::always, '*'), text, 8),
        5u);
    EXPECT_EQ(std::string(text, 5), "***-2");
    EXPECT_EQ(print(Q16_16(), Layout(0, 0, Sign::always), text, 0), 0u);
}

TEST(RawText, SaysWhereItIsMalformed) {
    const auto read = [](const char* text) { return parse_raw<Q8_8>(text, std::strlen(text)); };
    EXPECT_EQ(read("0x0180").number.raw(), 0x180);
    EXPECT_EQ(read("0XfF80").number.raw(), -128);
    EXPECT_EQ(read("0x00000180").number.raw(), 0x180);
    EXPECT_EQ(read("0x1").number.raw(), 1);
    const struct {
        const char* text;
        TextStatus status;
        size_t position;
    } cases[] = {{"", TextStatus::empty, 0},          {"180", TextStatus::malformed, 0},
                 {"0", TextStatus::malformed, 1},     {"0x", TextStatus::malformed, 2},
                 {"0x18g", TextStatus::malformed, 4}, {"0x10000", TextStatus::out_of_range, 7}};
    for (const auto& expected : cases) {
        EXPECT_EQ(read(expected.text).status, expected.status) << expected.text;
        EXPECT_EQ(read(expected.text).position, expected.position) << expected.text;
        EXPECT_EQ(read(expected.text).number.raw(), 0) << expected.text;
    }
}

}  // namespace
