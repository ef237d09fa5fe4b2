// SPDX-License-Identifier: MIT
// Numbers without a sign, in every arithmetic, against exact integers: every operand of every split
// of 8 bits, boundary and random operands of wider ones; conversions between all formats; text.
#include <gtest/gtest.h>

#include <fixedpoint/arithmetic/checked.hpp>
#include <fixedpoint/constants.hpp>
#include <fixedpoint/host/hash.hpp>
#include <fixedpoint/host/limits.hpp>
#include <fixedpoint/host/stream.hpp>
#include <fixedpoint/math.hpp>
#include <fixedpoint/text.hpp>
#include <fixedpoint/unsigned.hpp>
#include <fixedpoint/widening.hpp>
#include <random>
#include <sstream>
#include <utility>

#include "exact_integer.hpp"

namespace {

using namespace fixedpoint;
using namespace fixedpoint::literals;
using exact::Int;

int events = 0;
Event event;
struct Hook {
    static void notify(Event what, fixedpoint::Operation) {
        event = what;
        ++events;
    }
};

struct Format {
    int width, fraction;
    Int turn() const { return Int(1) << static_cast<unsigned>(width); }
    Int one() const { return Int(1) << static_cast<unsigned>(fraction); }
    Int max() const { return turn() - 1; }
    bool fits(const Int& n) const { return n >= 0 && n <= max(); }
    uint64_t wrapped(const Int& n) const {
        return static_cast<uint64_t>(n) << (64 - width) >> (64 - width);
    }
    uint64_t saturated(const Int& n) const {
        return static_cast<uint64_t>(n < 0 ? Int(0) : n > max() ? max() : n);
    }
};

// An operation on three numbers in each arithmetic, and the events that Checked reports.
struct Results {
    uint64_t nearest, saturating, checked;
    int events;
    Event event;
};
enum {
    add,
    subtract,
    negate,
    multiply,
    multiply_and_add,
    interpolate,
    difference,
    left_shift,
    divide,
    remain,
    root,
    middle,
    right_shift,
    up,
    near,
    down,
    count
};
template <class Number>
Number apply(int operation, Number a, Number b, Number c) {
    switch (operation) {
        case add:
            return a + b;
        case subtract:
            return a - b;
        case negate:
            return -a;
        case multiply:
            return a * b;
        case multiply_and_add:
            return multiply_add(a, b, c);
        case interpolate:
            return lerp(a, b, c);
        case difference:
            return abs_diff(a, b);
        case left_shift:
            return a << (c.raw() % 80);
        case divide:
            return a / b;
        case remain:
            return a % b;
        case root:
            return sqrt(a);
        case middle:
            return midpoint(a, b);
        case right_shift:
            return a >> (c.raw() % 80);
        case up:
            return ceil(a);
        case near:
            return round(a);
        default:
            return floor(a);
    }
}
template <int I, int F>
Results compute(int operation, uint64_t a, uint64_t b, uint64_t c) {
    const auto in = [&]<class Number>(Number) -> uint64_t {
        using Raw = typename Number::Raw;
        return apply(operation, Number::from_raw(Raw(a)), Number::from_raw(Raw(b)),
                     Number::from_raw(Raw(c)))
            .raw();
    };
    events = 0;
    const uint64_t checked = in(UFixed<I, F, Checked<Hook>>());
    return {in(UFixed<I, F>()), in(UFixed<I, F, Saturating>()), checked, events, event};
}
struct Quotient {
    uint64_t truncated, floored, remainder, rest;
};
template <int I, int F>
Quotient quotients(uint64_t a, uint64_t b) {
    using Raw = typename UFixed<I, F>::Raw;
    const auto x = UFixed<I, F>::from_raw(Raw(a)), y = UFixed<I, F>::from_raw(Raw(b));
    const auto truncated = divrem(x, y), floored = divmod(x, y);
    return {truncated.quotient, floored.quotient, truncated.remainder.raw(),
            floored.remainder.raw()};
}

struct Subject {
    Format format;
    Results (*compute)(int operation, uint64_t a, uint64_t b, uint64_t c);
    Quotient (*quotients)(uint64_t a, uint64_t b);
};
template <int Width, int... F>
void add_splits(std::vector<Subject>& all, std::integer_sequence<int, F...>) {
    (all.push_back({{Width, F}, compute<Width - F, F>, quotients<Width - F, F>}), ...);
}

// The exact result in ulp, rounded half up.
Int exact_result(int operation, Format format, const Int& a, const Int& b, const Int& c) {
    const Int one = format.one();
    const auto shift = static_cast<unsigned>(static_cast<uint64_t>(c % 80));
    switch (operation) {
        case add:
            return a + b;
        case subtract:
            return a - b;
        case negate:
            return -a;
        case multiply:
            return exact::nearest(a * b, one);
        case multiply_and_add:
            return exact::nearest(a * b, one) + c;
        case interpolate:
            return a + exact::nearest(c * (b - a), one);
        case difference:
            return abs(a - b);
        case left_shift:
            return a << shift;
        case divide:
            return b == 0 ? (a == 0 ? Int(0) : format.max()) : exact::nearest(a * one, b);
        case remain:
            return b == 0 ? a : a % b;
        case root: {
            // The integer r with (r - 1/2)^2 < a 2^F <= (r + 1/2)^2, by bisection.
            Int low = 0, high = format.turn();
            while (low < high) {
                const Int r = (low + high) / 2;
                if (a * one <= r * r + r) {
                    high = r;
                } else {
                    low = r + 1;
                }
            }
            return low;
        }
        case middle:
            return exact::nearest(a + b, 2);
        case right_shift:
            return exact::floor_of(a, Int(1) << shift);
        case up:
            return -exact::floor_of(-a, one) * one;
        case near:
            return exact::nearest(a, one) * one;
        default:
            return exact::floor_of(a, one) * one;
    }
}

void check(const Subject& subject, int operation, uint64_t a, uint64_t b, uint64_t c) {
    const Format format = subject.format;
    const Int exact = exact_result(operation, format, a, b, c);
    const Results results = subject.compute(operation, a, b, c);
    const bool ring = operation < divide, fits = format.fits(exact);
    Int saturated = exact;
    if (operation == multiply_and_add) {
        saturated = Int(format.saturated(exact - c)) + c;
    }
    const uint64_t expected = ring ? format.wrapped(exact) : format.saturated(exact);
    const bool vanishes = operation == divide             ? a != 0 && b != 0 && exact == 0
                          : operation == multiply         ? a != 0 && b != 0 && exact == 0
                          : operation == multiply_and_add ? a != 0 && b != 0 && exact == c
                                                          : false;
    const bool undefined = (operation == divide || operation == remain) && b == 0;
    const int told = (fits ? 0 : 1) + (vanishes ? 1 : 0) + (undefined ? 1 : 0);
    ASSERT_TRUE(results.nearest == expected && results.checked == expected &&
                results.saturating == format.saturated(saturated) && results.events == told &&
                (told != 1 || results.event == (!fits      ? Event::overflow
                                                : vanishes ? Event::underflow
                                                           : Event::division_by_zero)))
        << "operation " << operation << " of " << a << ", " << b << ", " << c
        << " with F = " << format.fraction << ": " << results.nearest << ", " << results.saturating
        << ", " << results.events << " events for " << expected << ", " << told;
}

void check_quotients(const Subject& subject, uint64_t a, uint64_t b) {
    const Quotient result = subject.quotients(a, b);
    const uint64_t quotient =
        b == 0 ? (a == 0 ? 0 : static_cast<uint64_t>(subject.format.max())) : a / b;
    const uint64_t rest = b == 0 ? a : a % b;
    ASSERT_TRUE(result.truncated == quotient && result.floored == quotient &&
                result.remainder == rest && result.rest == rest)
        << a << " and " << b;
}

// The numbers next to powers of two and to the limits, and random ones of every magnitude.
std::vector<uint64_t> operands(int width, size_t random_ones, std::mt19937_64& random) {
    std::vector<uint64_t> numbers;
    const uint64_t mask = ~uint64_t(0) >> (64 - width);
    for (int bit = 0; bit < width; ++bit) {
        for (uint64_t offset = 0; offset < 5; ++offset)
            numbers.push_back(((uint64_t(1) << bit) + offset - 2) & mask);
    }
    for (size_t i = 0; i < random_ones; ++i) numbers.push_back((random() & mask) >> random() % 64);
    return numbers;
}

TEST(Unsigned, EveryPairOfEverySplitOf8Bits) {
    std::vector<Subject> all;
    add_splits<8>(all, std::make_integer_sequence<int, 9>());
    std::mt19937_64 random(1);
    for (const Subject& subject : all) {
        for (uint64_t a = 0; a < 256; ++a) {
            for (uint64_t b = 0; b < 256; b += exact::operand_step) {
                const uint64_t c = random() & 255;
                for (int operation = 0; operation < count; ++operation)
                    check(subject, operation, a, b, c);
                check_quotients(subject, a, b);
                if (HasFatalFailure()) return;
            }
        }
    }
}

TEST(Unsigned, BoundariesAndRandomNumbersOfWiderSplits) {
    std::vector<Subject> all;
    add_splits<16>(all, std::integer_sequence<int, 0, 1, 8, 15, 16>());
    add_splits<32>(all, std::integer_sequence<int, 0, 1, 16, 31, 32>());
    add_splits<64>(all, std::integer_sequence<int, 1, 32, 62, 63>());
    std::mt19937_64 random(2);
    for (const Subject& subject : all) {
        const std::vector<uint64_t> numbers = operands(subject.format.width, 60, random);
        for (const uint64_t a : numbers) {
            for (size_t i = 0; i < 40; i += exact::operand_step) {
                const uint64_t b = numbers[random() % numbers.size()];
                const uint64_t c = numbers[random() % numbers.size()];
                for (int operation = 0; operation < count; ++operation)
                    check(subject, operation, a, b, c);
                check_quotients(subject, a, b);
                if (HasFatalFailure()) return;
            }
        }
    }
}

// Conversions: every pair of these formats, with and without a sign.
struct Conversion {
    int from_width, from_fraction, to_width, to_fraction;
    bool from_signed, to_signed;
    // The bits of the source to those of the target.
    uint64_t (*nearest)(uint64_t);
    uint64_t (*saturating)(uint64_t);
    Converted<uint64_t> (*checked)(uint64_t);
};
template <class From, class To>
To of_bits(uint64_t bits) {
    return convert<To>(From::from_raw(static_cast<typename From::Raw>(bits)));
}
template <class To>
uint64_t bits_of(To number) {
    return static_cast<UnsignedInteger<RawLimits<typename To::Raw>::width>>(number.raw());
}
template <class From, template <class> class To>
Conversion conversion() {
    using Target = To<Nearest>;
    using Raw = typename Target::Raw;
    return {RawLimits<typename From::Raw>::width,
            From::fraction_bits,
            RawLimits<Raw>::width,
            Target::fraction_bits,
            RawLimits<typename From::Raw>::is_signed,
            RawLimits<Raw>::is_signed,
            [](uint64_t bits) { return bits_of(of_bits<From, Target>(bits)); },
            [](uint64_t bits) { return bits_of(of_bits<From, To<Saturating>>(bits)); },
            [](uint64_t bits) {
                const auto result =
                    convert_checked<Target>(From::from_raw(static_cast<typename From::Raw>(bits)));
                return Converted<uint64_t>{bits_of(result.number), result.fits};
            }};
}
template <int I, int F>
struct With {
    template <class A>
    using Sign = Fixed<I, F, A>;
    template <class A>
    using NoSign = UFixed<I, F, A>;
};
template <class From>
void add_targets(std::vector<Conversion>& all) {
    const auto with = [&]<int... I, int... F>(std::integer_sequence<int, I...>,
                                              std::integer_sequence<int, F...>) {
        (all.push_back(conversion<From, With<I, F>::template NoSign>()), ...);
        (all.push_back(conversion<From, With<I == 0 ? 1 : I, I == 0 ? F - 1 : F>::template Sign>()),
         ...);
    };
    with(std::integer_sequence<int, 4, 0, 8, 8, 0, 16, 16, 0, 32, 32, 1>(),
         std::integer_sequence<int, 4, 8, 0, 8, 16, 0, 16, 32, 0, 32, 63>());
}
TEST(Unsigned, ConversionsBetweenAllFormats) {
    std::vector<Conversion> all;
    add_targets<UFixed<4, 4>>(all);
    add_targets<UFixed<0, 8>>(all);
    add_targets<UFixed<8, 8>>(all);
    add_targets<UFixed<0, 16>>(all);
    add_targets<UFixed<0, 32>>(all);
    add_targets<UFixed<32, 0>>(all);
    add_targets<UFixed<32, 32>>(all);
    add_targets<Fixed<4, 4>>(all);
    add_targets<Fixed<8, 8>>(all);
    add_targets<Fixed<16, 16>>(all);
    add_targets<Fixed<1, 63>>(all);
    std::mt19937_64 random(3);
    for (const Conversion& each : all) {
        const auto wrapped = [](const Int& n, int width) {
            return static_cast<uint64_t>(n) << (64 - width) >> (64 - width);
        };
        for (const uint64_t bits : operands(each.from_width, 100, random)) {
            const Int a =
                each.from_signed ? Int(exact::wrapped(Int(bits), each.from_width)) : Int(bits);
            const Int exact = exact::nearest(a << static_cast<unsigned>(each.to_fraction),
                                             Int(1) << static_cast<unsigned>(each.from_fraction));
            const Int largest =
                (Int(1) << static_cast<unsigned>(each.to_width - each.to_signed)) - 1;
            const Int smallest = each.to_signed ? -largest - 1 : Int(0);
            const uint64_t saturated = wrapped(exact < smallest  ? smallest
                                               : exact > largest ? largest
                                                                 : exact,
                                               each.to_width);
            const Converted<uint64_t> checked = each.checked(bits);
            ASSERT_TRUE(each.nearest(bits) == wrapped(exact, each.to_width) &&
                        each.saturating(bits) == saturated && checked.number == saturated &&
                        checked.fits == (exact >= smallest && exact <= largest))
                << a << " with " << each.from_fraction << " fraction bits to " << each.to_fraction
                << " of " << each.to_width;
        }
    }
}

template <class Number>
void check_floats(std::mt19937_64& random) {
    const Format format = {RawLimits<typename Number::Raw>::width, Number::fraction_bits};
    for (int i = 0; i < 3000; ++i) {
        // m 2^exponent around the range and half an ulp, of either sign.
        const auto mantissa = static_cast<int64_t>(random() >> (40 + random() % 20)) -
                              static_cast<int64_t>(random() % 3);
        const int exponent = static_cast<int>(random() % 80) - Number::fraction_bits - 24;
        const double x = std::ldexp(static_cast<double>(mantissa), exponent);
        const int shift = exponent + Number::fraction_bits;
        const Int exact =
            exact::nearest(Int(mantissa) << static_cast<unsigned>(shift > 0 ? shift : 0),
                           Int(1) << static_cast<unsigned>(shift < 0 ? -shift : 0));
        const auto result = from_float_checked<Number>(x);
        ASSERT_TRUE(result.number.raw() == format.saturated(exact) &&
                    result.fits == format.fits(exact))
            << x;
        if (static_cast<double>(static_cast<float>(x)) == x) {
            ASSERT_EQ(from_float<Number>(static_cast<float>(x)).raw(), result.number.raw()) << x;
        }
        ASSERT_EQ(to_float<double>(result.number),
                  std::ldexp(static_cast<double>(result.number.raw()), -Number::fraction_bits));
    }
    ASSERT_EQ(from_float<Number>(1e30).raw(), Number::max().raw());
    ASSERT_EQ(from_float<Number>(-1e30).raw(), 0u);
}

// Text of a number: what Int says are its decimals, and what is read back.
template <class Number>
void check_text(std::mt19937_64& random) {
    const Format format = {RawLimits<typename Number::Raw>::width, Number::fraction_bits};
    for (const uint64_t raw : operands(format.width, 300, random)) {
        const auto x = Number::from_raw(static_cast<typename Number::Raw>(raw));
        char buffer[text_capacity<Number>()];
        const size_t length = print(x, buffer, sizeof buffer);
        ASSERT_NE(length, 0u) << raw;
        const std::string text(buffer, length);
        ASSERT_EQ(parse<Number>(buffer, length).number, x) << text;
        // With 0..F decimals, rounded half up.
        for (uint8_t decimals = 0; decimals <= Number::fraction_bits; ++decimals) {
            const Int ten = exact::power(10, decimals);
            const std::string digits = exact::nearest(Int(raw) * ten, format.one()).str();
            std::string expected = digits.size() > decimals
                                       ? digits
                                       : std::string(decimals + 1 - digits.size(), '0') + digits;
            if (decimals > 0) expected.insert(expected.size() - decimals, ".");
            ASSERT_EQ(to_string(x, decimals), expected);
        }
    }
    // Any decimal, out of range and of either sign too.
    for (int i = 0; i < 3000; ++i) {
        const auto decimals = static_cast<unsigned>(random() % 24);
        std::string digits;
        for (uint64_t n = 1 + random() % (decimals + 20); n > 0; --n)
            digits += static_cast<char>('0' + random() % 10);
        Int n = 0;
        for (const char c : digits) n = 10 * n + (c - '0');
        const bool negative = random() % 8 == 0;
        const Int exact =
            exact::nearest((negative ? -n : n) * format.one(), exact::power(10, decimals));
        const std::string text = (negative ? "-" : "") + digits + "e-" + std::to_string(decimals);
        const auto result = parse<Number>(text.data(), text.size());
        ASSERT_EQ(result.number.raw(), format.saturated(exact)) << text;
        ASSERT_EQ(result.status == TextStatus::ok, format.fits(exact)) << text;
        if (negative) continue;
        const auto literal = portable::parse_literal<typename Number::Raw, Number::fraction_bits>(
            text.data(), text.data() + text.size());
        ASSERT_EQ(literal.fits, format.fits(exact)) << text;
        ASSERT_TRUE(!literal.fits || literal.number == result.number.raw()) << text;
    }
}
template <class... Numbers>
void for_each(std::mt19937_64& random) {
    (check_floats<Numbers>(random), ...);
    (check_text<Numbers>(random), ...);
}
TEST(Unsigned, FloatsAndText) {
    std::mt19937_64 random(4);
    for_each<UFixed<8, 0>, UFixed<4, 4>, UFixed<0, 8>, UFixed<8, 8>, UFixed<0, 16>, UFixed<32, 0>,
             UFixed<16, 16>, UFixed<1, 31>, UFixed<0, 32>, UFixed<63, 1>, UFixed<32, 32>,
             UFixed<1, 63>>(random);
}

TEST(Unsigned, WideningIsExactAndNarrowSaturates) {
    std::mt19937_64 random(5);
    for (int i = 0; i < 100000; i += exact::operand_step) {
        const auto a = U8_8::from_raw(static_cast<uint16_t>(random()));
        const auto b = UFixed<0, 16>::from_raw(static_cast<uint16_t>(random()));
        const auto c = U16_16::from_raw(static_cast<uint32_t>(random()));
        const auto d = U16_16::from_raw(static_cast<uint32_t>(random()));
        const UFixed<8, 24> product = widening_multiply(a, b);
        ASSERT_EQ(product.raw(), uint32_t{a.raw()} * b.raw());
        const UFixed<0, 32> square = widening_multiply(b, b);
        ASSERT_EQ(square.raw(), uint32_t{b.raw()} * b.raw());
        const U32_32 wide = widening_multiply(c, d);
        ASSERT_EQ(wide.raw(), uint64_t{c.raw()} * d.raw());
        const UFixed<48, 16> sum = widening_add(c, d);
        ASSERT_EQ(sum.raw(), uint64_t{c.raw()} + d.raw());
        const uint64_t rounded = (wide.raw() + (uint64_t(1) << 23)) >> 24;
        ASSERT_EQ(narrow<U8_8>(wide).raw(), rounded > 65535 ? 65535 : rounded);
        ASSERT_EQ(narrow<Q8_8>(wide).raw(), rounded > 32767 ? 32767 : rounded);
        ASSERT_EQ(narrow<U8_8>(-Q16_16::max()).raw(), 0);
    }
}

// The same as constants, in the standard library, and in text.
static_assert(U8_8::max().raw() == 65535 && U8_8::min().raw() == 0, "the range");
static_assert((255.99609375_u8_8).raw() == 65535 && (0.5_u4_4).raw() == 8, "literals");
static_assert(literal<UFixed<0, 16>, '0', '.', '9', '9', '9', '9', '9'>().raw() == 65535, "");
static_assert((4294967295.9999999998_u32_32).raw() == U32_32::max().raw(), "20 digits");
static_assert(ufixed<0, 16>(0.75).raw() == 0xc000 && ufixed<32, 32>(4294967295u).raw() != 0, "");
static_assert(ufixed<1, 63>(1.9999999).raw() > uint64_t(1) << 63, "beyond 63 bits");
static_assert(constants::pi<UFixed<2, 14>>().raw() == 51472, "pi 2^14");
TEST(Unsigned, IsANumberOfTheStandardLibrary) {
    using Limits = std::numeric_limits<U8_8>;
    EXPECT_FALSE(Limits::is_signed);
    EXPECT_EQ(Limits::digits, 16);
    EXPECT_EQ(Limits::lowest().raw(), 0);
    EXPECT_EQ(Limits::max().raw(), 65535);
    EXPECT_EQ(std::hash<U8_8>()(U8_8::from_raw(7)), std::hash<uint16_t>()(7));
    std::ostringstream out;
    out << 255.5_u8_8;
    EXPECT_EQ(out.str(), "255.5");
    std::istringstream in("200.25 -1");
    U8_8 x, y;
    in >> x >> y;
    EXPECT_EQ(x, 200.25_u8_8);
    EXPECT_TRUE(in.fail());
    EXPECT_EQ(y.raw(), 0);
}

}  // namespace
