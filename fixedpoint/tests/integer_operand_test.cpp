// SPDX-License-Identifier: MIT
// Operators on a number, with or without a sign, and an integer of any type, in every arithmetic,
// against exact integers:
// all pairs of 8 bits, boundary and random pairs of wider ones; widening products and sums; and
// narrow.
#include <gtest/gtest.h>

#include <fixedpoint/arithmetic/checked.hpp>
#include <fixedpoint/arithmetic/published.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/constants.hpp>
#include <fixedpoint/unsigned.hpp>
#include <fixedpoint/widening.hpp>
#include <utility>

#include "exact_integer.hpp"
#include "subjects.hpp"

namespace {

using namespace fixedpoint;
using exact::Int;

// The last event reported to the hook.
Event event;
int events = 0;
struct Hook {
    static void notify(Event what, fixedpoint::Operation) {
        event = what;
        ++events;
    }
};

enum { sum, difference, difference_from, product, quotient, operations };
struct Results {
    int64_t nearest[operations], saturating[operations], checked[operations];
    // From Checked: whether it reported overflow, and whether it reported anything else.
    bool overflow[operations], other[operations];
    bool equal, less, greater;
    // Whether assignment, exchanged operands and the other comparisons agree. Collected here and
    // expected once: in a template with some hundred instances, each EXPECT would be compiled every
    // time.
    bool consistent;
};

template <class Number, class Integral>
Number apply(int operation, Number x, Integral n, bool& consistent) {
    Number assigned = x;
    const Number result = operation == sum               ? (assigned += n, x + n)
                          : operation == difference      ? (assigned -= n, x - n)
                          : operation == difference_from ? (assigned = n - x)
                          : operation == product         ? (assigned *= n, x * n)
                                                         : (assigned /= n, x / n);
    const Number exchanged = operation == sum ? n + x : operation == product ? n * x : result;
    consistent = consistent && assigned.raw() == result.raw() && exchanged.raw() == result.raw();
    return result;
}

template <class Raw, int F, class Arithmetic>
using NumberOf = Fixed<
    RawLimits<Raw>::width - F, F,
    std::conditional_t<RawLimits<Raw>::is_signed, Arithmetic, UnsignedArithmetic<Arithmetic>>>;

// Raws without a sign are passed and returned as the numbers with a sign of the same bits.
template <class Raw, int F, class Integral>
Results compute(int64_t a, uint64_t bits) {
    const auto n = static_cast<Integral>(bits);
    const auto raw = static_cast<Raw>(a);
    const auto x = NumberOf<Raw, F, Nearest>::from_raw(raw);
    Results results = {};
    bool& consistent = results.consistent = true;
    for (int i = 0; i < operations; ++i) {
        const auto bits_of = [&]<class Number>(Number number) {
            return fixedpoint::Integer<RawLimits<Raw>::width>(
                apply(i, number, n, consistent).raw());
        };
        results.nearest[i] = bits_of(x);
        results.saturating[i] = bits_of(NumberOf<Raw, F, Saturating>::from_raw(raw));
        events = 0;
        results.checked[i] = bits_of(NumberOf<Raw, F, Checked<Hook>>::from_raw(raw));
        results.overflow[i] = events != 0 && event == Event::overflow;
        results.other[i] = events != 0 && event != Event::overflow;
    }
    results.equal = x == n;
    results.less = x < n;
    results.greater = x > n;
    consistent = consistent && (n == x) == results.equal && (x != n) != results.equal &&
                 (n != x) != results.equal && (n > x) == results.less && (x >= n) != results.less &&
                 (n <= x) != results.less && (n < x) == results.greater &&
                 (x <= n) != results.greater && (n >= x) != results.greater;
    return results;
}

struct MixedSubject {
    int width, fraction, integer_width;
    bool is_signed, raw_is_signed;
    Results (*compute)(int64_t a, uint64_t n);
};
template <class Raw, int F, class... Integrals>
void add_integrals(std::vector<MixedSubject>& all) {
    (all.push_back({RawLimits<Raw>::width, F, RawLimits<Integrals>::width,
                    std::is_signed_v<Integrals>, RawLimits<Raw>::is_signed,
                    compute<Raw, F, Integrals>}),
     ...);
}
template <class Raw, int... F>
std::vector<MixedSubject> mixed_subjects(std::integer_sequence<int, F...>) {
    std::vector<MixedSubject> all;
    (add_integrals<Raw, F, signed char, unsigned char, short, unsigned short, int, unsigned,
                   long long, unsigned long long>(all),
     ...);
    return all;
}

void check(const MixedSubject& subject, int64_t raw, uint64_t bits) {
    const Int n = subject.is_signed ? Int(static_cast<int64_t>(bits)) : Int(bits);
    const Int turn = Int(1) << static_cast<unsigned>(subject.width);
    const Int a = raw < 0 && !subject.raw_is_signed ? raw + turn : Int(raw);
    const Int largest = subject.raw_is_signed ? Int(exact::largest(subject.width)) : turn - 1;
    const Int smallest = subject.raw_is_signed ? Int(exact::smallest(subject.width)) : Int(0);
    const Int scaled = n << subject.fraction;
    const Results results = subject.compute(raw, bits);
    ASSERT_TRUE(results.consistent) << a << " and " << n;
    const Int exact[] = {a + scaled, a - scaled, scaled - a, a * n,
                         n == 0 ? a == 0  ? Int(0)
                                  : a < 0 ? smallest
                                          : largest
                                : exact::nearest(n < 0 ? -a : a, abs(n))};
    for (int i = 0; i < operations; ++i) {
        const bool fits = exact[i] >= smallest && exact[i] <= largest;
        const int64_t saturated = exact::wrapped(exact[i] < smallest  ? smallest
                                                 : exact[i] > largest ? largest
                                                                      : exact[i],
                                                 subject.width);
        const int64_t expected =
            i == quotient ? saturated : exact::wrapped(exact[i], subject.width);
        const bool untold = i == quotient && (n == 0 || (exact[i] == 0 && a != 0));
        ASSERT_TRUE(results.nearest[i] == expected && results.checked[i] == results.nearest[i] &&
                    results.saturating[i] == saturated && results.overflow[i] == !fits &&
                    results.other[i] == untold)
            << "operation " << i << " of " << a << " and " << n << ": " << results.nearest[i]
            << ", " << results.saturating[i] << " for " << expected << ", " << saturated;
    }
    ASSERT_TRUE(results.equal == (a == scaled) && results.less == (a < scaled) &&
                results.greater == (a > scaled))
        << a << " and " << n;
}

// Integers of a type: those at which something changes for the format, and random ones.
std::vector<uint64_t> integers(const MixedSubject& subject, std::mt19937_64& random) {
    std::vector<uint64_t> numbers;
    const auto add = [&](uint64_t n) {
        const int unused = 64 - subject.integer_width;
        numbers.push_back(subject.is_signed
                              ? static_cast<uint64_t>(static_cast<int64_t>(n << unused) >> unused)
                              : n << unused >> unused);
    };
    if (subject.integer_width == 8) {
        for (uint64_t n = 0; n < 256; ++n) add(n);
        return numbers;
    }
    const int whole = subject.width - subject.fraction;
    for (const int bit : {0, 1, whole - 2, whole - 1, whole, whole + 1, subject.width - 1,
                          subject.width, subject.integer_width - 1}) {
        for (uint64_t offset = 0; offset < 5; ++offset) {
            const uint64_t n = (bit < 0 || bit > 63 ? 0 : uint64_t(1) << bit) + offset - 2;
            add(n);
            add(0 - n);
        }
    }
    for (int i = 0; i < 12; ++i) add(random() >> (random() % 64));
    return numbers;
}

void check_all(const std::vector<MixedSubject>& all) {
    std::mt19937_64 random(15);
    for (const MixedSubject& subject : all) {
        SCOPED_TRACE(testing::Message()
                     << subject.width << " bits, F = " << subject.fraction << ", integer of "
                     << subject.integer_width << " bits, signed " << subject.is_signed);
        const std::vector<uint64_t> numbers = integers(subject, random);
        std::vector<int64_t> raws = exact::raws(subject.width, 1);
        if (subject.width > 8) {
            std::shuffle(raws.begin(), raws.end(), random);
            raws.resize(80);
            for (const int64_t n : {0, 1, -1}) raws.push_back(n);
            for (int64_t offset = 0; offset < 3; ++offset) {
                raws.push_back(exact::smallest(subject.width) + offset);
                raws.push_back(exact::largest(subject.width) - offset);
            }
        }
        for (size_t i = 0; i < raws.size(); i += exact::operand_step) {
            const int64_t a = raws[i];
            for (const uint64_t n : numbers) {
                check(subject, a, n);
                if (testing::Test::HasFatalFailure()) return;
            }
            // Quotients that are ties, and their neighbours.
            const uint64_t twice = 2 * static_cast<uint64_t>(a);
            for (const uint64_t n : {twice - 1, twice, twice + 1}) {
                if (subject.integer_width == 64) check(subject, a, n);
            }
        }
    }
}

TEST(IntegerOperand, EverySplitOf8Bits) {
    check_all(mixed_subjects<int8_t>(std::make_integer_sequence<int, 8>()));
}
TEST(IntegerOperand, Of16Bits) {
    check_all(mixed_subjects<int16_t>(std::integer_sequence<int, 0, 8, 15>()));
}
TEST(IntegerOperand, Of24Bits) {
    check_all(mixed_subjects<Int24>(std::integer_sequence<int, 0, 12, 16, 23>()));
}
TEST(IntegerOperand, Of32Bits) {
    check_all(mixed_subjects<int32_t>(std::integer_sequence<int, 0, 1, 16, 31>()));
}
TEST(IntegerOperand, Of64Bits) {
    check_all(mixed_subjects<int64_t>(std::integer_sequence<int, 0, 32, 63>()));
}

TEST(IntegerOperand, WithoutSign) {
    check_all(mixed_subjects<uint8_t>(std::make_integer_sequence<int, 9>()));
    check_all(mixed_subjects<uint16_t>(std::integer_sequence<int, 0, 8, 16>()));
    check_all(mixed_subjects<uint32_t>(std::integer_sequence<int, 0, 16, 32>()));
    check_all(mixed_subjects<uint64_t>(std::integer_sequence<int, 1, 32, 63>()));
}

TEST(IntegerOperand, PublishedDividesTowardZero) {
    using Number = Fixed<4, 4, Published>;
    for (int a = -128; a < 128; ++a) {
        for (int n = -300; n <= 300; ++n) {
            if (n == 0) continue;
            const int expected = a == -128 && n == -1 ? -128 : a / n;
            ASSERT_EQ((Number::from_raw(static_cast<int8_t>(a)) / n).raw(), expected)
                << a << " / " << n;
        }
    }
}

// Every pair of 8 bits, in splits with different fraction bits; the value of the result is exact.
TEST(Widening, ProductsAndSumsAreExact) {
    const auto check = []<int I1, int F1, int I2, int F2>(
                           std::integer_sequence<int, I1, F1, I2, F2>) {
        const std::vector<int64_t> left = exact::raws(I1 + F1, 2), right = exact::raws(I2 + F2, 2);
        for (size_t i = 0; i < left.size(); i += left.size() / 200) {
            for (size_t j = 0; j < right.size(); j += right.size() / 200) {
                const auto a = Fixed<I1, F1>::from_raw(static_cast<Integer<I1 + F1>>(left[i]));
                const auto b = Fixed<I2, F2>::from_raw(static_cast<Integer<I2 + F2>>(right[j]));
                const auto c = Fixed<I1, F1>::from_raw(static_cast<Integer<I1 + F1>>(right[j]));
                const auto product = widening_multiply(a, b);
                ASSERT_EQ(product.raw(), __int128{a.raw()} * b.raw());
                static_assert(decltype(product)::fraction_bits == F1 + F2);
                const auto sum = widening_add(a, c);
                ASSERT_EQ(sum.raw(), __int128{a.raw()} + c.raw());
                static_assert(decltype(sum)::fraction_bits == F1);
            }
        }
    };
    check(std::integer_sequence<int, 4, 4, 4, 4>());
    check(std::integer_sequence<int, 1, 7, 8, 0>());
    check(std::integer_sequence<int, 8, 8, 1, 7>());
    check(std::integer_sequence<int, 8, 8, 1, 15>());
    check(std::integer_sequence<int, 16, 16, 1, 31>());
    check(std::integer_sequence<int, 16, 16, 4, 4>());
}
TEST(Widening, NarrowRoundsAndSaturates) {
    for (int32_t raw = -40000; raw < 40000; ++raw) {
        const auto x = Fixed<20, 12>::from_raw(raw);
        ASSERT_EQ(narrow<Q4_4>(x).raw(), exact::saturated(exact::nearest(raw, 256), 8));
        ASSERT_EQ(narrow<unsigned char>(x), raw < 0 ? 0 : (raw + 2048) / 4096);
    }
    EXPECT_EQ(narrow<int16_t>(Q32_32::max()), 32767);
}

// The float or integer rounded to nearest, half up, as by from_float and from_integer.
static_assert(fixed<16, 16>(0.38).raw() == 24904);
static_assert(fixed<16, 16>(-0.38F).raw() == -24904);
static_assert(fixed<16, 16, Saturating>(32767.999992).raw() == RawLimits<int32_t>::max);
static_assert(fixed<16, 16>(-32768).raw() == RawLimits<int32_t>::min);
static_assert(fixed<4, 4>(-8.03125).raw() == -128, "a tie rounds half up, into the range");
static_assert(fixed<4, 4>(0.03125).raw() == 1 && fixed<4, 4>(-0.03125).raw() == 0);
static_assert(fixed<4, 4>(-0.04).raw() == -1 && fixed<4, 4>(7.96).raw() == 127);
static_assert(fixed<64, 0>(-9223372036854775808.0).raw() == RawLimits<int64_t>::min);
static_assert(fixed<1, 63>(0.75).raw() == int64_t(3) << 61);
static_assert(fixed<64, 0>(9007199254740993LL).raw() == 9007199254740993, "no detour by a double");

// The constants in every split that can represent them, against a library with constants of its
// own.
struct ConstantOfSplit {
    exact::Constant constant;
    exact::Format format;
    int64_t raw;
};
// What a constant needs from a number. Fixed provides that, but also some hundred operators, which
// would be instantiated for every split.
template <int I, int F>
struct Split {
    using Raw = Integer<I + F>;
    static constexpr int fraction_bits = F;
    static constexpr Split from_raw(Raw raw) { return {raw}; }
    Raw raw;
};
template <int I, int F>
void add_constants(std::vector<ConstantOfSplit>& all) {
    using exact::Constant;
    using Number = Split<I, F>;
    const auto add = [&](Constant constant, Number x) {
        all.push_back({constant, {I + F, F}, x.raw});
    };
    if constexpr (I >= 1) add(Constant::ln2, constants::ln2<Number>());
    if constexpr (I >= 2) {
        add(Constant::sqrt2, constants::sqrt2<Number>());
        add(Constant::golden_ratio, constants::golden_ratio<Number>());
    }
    if constexpr (I >= 3) {
        add(Constant::pi, constants::pi<Number>());
        add(Constant::e, constants::e<Number>());
        add(Constant::ln10, constants::ln10<Number>());
    }
    if constexpr (I >= 4) add(Constant::tau, constants::tau<Number>());
    if constexpr (I >= 7)
        add(Constant::degrees_per_radian, constants::degrees_per_radian<Number>());
}
template <int W, int... F>
void expect_constants(std::integer_sequence<int, F...>) {
    std::vector<ConstantOfSplit> all;
    (add_constants<W - F, F>(all), ...);
    for (const ConstantOfSplit& each : all) {
        const exact::Rounded expected = exact::constant(each.constant, each.format);
        ASSERT_TRUE(expected.fits && each.raw == expected.wrapped)
            << static_cast<int>(each.constant) << ", " << W << " bits, F = " << each.format.fraction
            << ": " << each.raw << " for " << expected.wrapped;
    }
}
static_assert(constants::pi<Q16_16>().raw() == constants::pi<Split<16, 16>>().raw);
TEST(Constants, AreTheNearestNumbersInEverySplit) {
    expect_constants<8>(std::make_integer_sequence<int, 8>());
    expect_constants<16>(std::make_integer_sequence<int, 16>());
    expect_constants<32>(std::make_integer_sequence<int, 32>());
    expect_constants<64>(std::make_integer_sequence<int, 64>());
}

}  // namespace
