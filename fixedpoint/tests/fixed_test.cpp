// SPDX-License-Identifier: MIT
// The operators of Fixed in every arithmetic, against exact arithmetic: all pairs of Q4.4, boundary
// and random pairs of the others. checked_test.cpp covers what Checked reports.
#include <algorithm>
#include <fixedpoint/arithmetic/checked.hpp>
#include <fixedpoint/arithmetic/published.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/arithmetic/small.hpp>
#include <fixedpoint/conversion.hpp>
#include <fixedpoint/math.hpp>
#include <fixedpoint/vector.hpp>

#include "subjects.hpp"

namespace {

using namespace fixedpoint;

// The results computed from two operands in one format, one row per operation.
constexpr int max_results = 24;
struct Results {
    int count = 0;
    int64_t values[max_results];
    void add(int64_t value) { values[count++] = value; }
};
struct Operators {
    exact::Format format;
    void (*compute)(int64_t a, int64_t b, Results& results);
};

template <class Number>
typename Number::Raw cast(int64_t a) {
    return static_cast<typename Number::Raw>(a);
}

template <class Wrap, class... Numbers>
std::vector<Operators> operators_of(Wrap) {
    return {Operators{{RawLimits<typename Numbers::Raw>::width, Numbers::fraction_bits},
                      [](int64_t a, int64_t b, Results& results) {
                          Wrap().template operator()<Numbers>(Numbers::from_raw(cast<Numbers>(a)),
                                                              Numbers::from_raw(cast<Numbers>(b)),
                                                              results);
                      }}...};
}
template <class Arithmetic, class Wrap>
std::vector<Operators> operators_in(Wrap wrap) {
    return operators_of<
        Wrap, Fixed<4, 4, Arithmetic>, Fixed<1, 7, Arithmetic>, Fixed<8, 8, Arithmetic>,
        Fixed<8, 16, Arithmetic>, Fixed<12, 12, Arithmetic>, Fixed<1, 23, Arithmetic>,
        Fixed<24, 0, Arithmetic>, Fixed<16, 16, Arithmetic>, Fixed<8, 24, Arithmetic>,
        Fixed<32, 32, Arithmetic>, Fixed<1, 63, Arithmetic>, Fixed<64, 0, Arithmetic>>(wrap);
}

template <class Expected>
void check(const std::vector<Operators>& all, Expected expect) {
    for (const Operators& subject : all) {
        SCOPED_TRACE(testing::Message()
                     << subject.format.width << " bits, F = " << subject.format.fraction);
        for_each_pair(subject.format.width, [&](int64_t a, int64_t b) {
            Results results, expected;
            subject.compute(a, b, results);
            expect(a, b, subject.format, expected);
            ASSERT_EQ(results.count, expected.count);
            for (int i = 0; i < results.count; ++i) {
                ASSERT_EQ(results.values[i], expected.values[i])
                    << "result " << i << " of " << a << " and " << b;
            }
        });
        if (testing::Test::HasFatalFailure()) return;
    }
}

constexpr auto arithmetic_operators = []<class Number>(Number x, Number y, Results& results) {
    Number sum = x, difference = x, product = x, quotient = x, rest = x;
    for (const Number number : {x + y, x - y, -x, +x, x * y, x / y, x % y, abs(x), sum += y,
                                difference -= y, product *= y, quotient /= y, rest %= y}) {
        results.add(number.raw());
    }
    for (const Number number : {min(x, y), max(x, y)}) results.add(number.raw());
    for (const bool answer : {x == y, x != y, x<y, x> y, x <= y, x >= y}) results.add(answer);
};

// The results by definition; pick selects the wrapped or the saturated result of the ring
// operations.
template <class Pick>
auto defined(Pick pick) {
    return [pick](int64_t a, int64_t b, exact::Format format, Results& results) {
        const int64_t sum = pick(exact::add(a, b, format));
        const int64_t difference = pick(exact::subtract(a, b, format));
        const int64_t negated = pick(exact::subtract(0, a, format));
        const int64_t product = pick(exact::multiply_add(a, b, 0, format));
        const int64_t quotient = b != 0  ? exact::divide(a, b, format).saturated
                                 : a > 0 ? exact::largest(format.width)
                                 : a < 0 ? exact::smallest(format.width)
                                         : 0;
        const int64_t rest = b == 0 ? a : b == -1 ? 0 : a % b;
        for (const int64_t value :
             {sum, difference, negated, a, product, quotient, rest, a < 0 ? negated : a, sum,
              difference, product, quotient, rest, std::min(a, b), std::max(a, b)}) {
            results.add(value);
        }
        for (const bool answer : {a == b, a != b, a<b, a> b, a <= b, a >= b}) {
            results.add(answer);
        }
    };
}
constexpr auto wrapped = [](const exact::Rounded& result) { return result.wrapped; };
constexpr auto saturated = [](const exact::Rounded& result) { return result.saturated; };

struct Silent {
    static void notify(Event, fixedpoint::Operation) {}
};

TEST(Operators, DefaultRoundsToNearestAndWrapsOrSaturates) {
    check(operators_in<Nearest>(arithmetic_operators), defined(wrapped));
}
TEST(Operators, SmallHasTheSameResults) {
    check(operators_in<Small>(arithmetic_operators), defined(wrapped));
}
TEST(Operators, CheckedHasTheSameResults) {
    check(operators_in<Checked<Silent>>(arithmetic_operators), defined(wrapped));
}
TEST(Operators, SaturatingSaturates) {
    check(operators_in<Saturating>(arithmetic_operators), defined(saturated));
}

// Each product and each sum separately.
TEST(Operators, SaturatingSaturatesProductsAndSumsOfSeveral) {
    check(operators_in<Saturating>([]<class Number>(Number x, Number y, Results& results) {
              using Raw = typename Number::Raw;
              const Number z = Number::from_raw(static_cast<Raw>(x.raw() ^ y.raw()));
              const Number left[3] = {x, y, z}, right[3] = {y, z, x};
              results.add(multiply_add(x, y, x).raw());
              results.add(dot2(left, right).raw());
              results.add(dot3(left, right).raw());
          }),
          [](int64_t a, int64_t b, exact::Format format, Results& results) {
              const auto product = [&](int64_t x, int64_t y) {
                  return exact::multiply_add(x, y, 0, format).saturated;
              };
              const auto sum = [&](int64_t x, int64_t y) {
                  return exact::add(x, y, format).saturated;
              };
              const int64_t c = a ^ b, both = sum(product(a, b), product(b, c));
              results.add(sum(product(a, b), a));
              results.add(both);
              results.add(sum(both, product(c, a)));
          });
}

// A product, quotient or part that is rounded to 0 is reported, and nothing else.
int underflows = 0;
struct Underflow {
    static void notify(Event event, fixedpoint::Operation) {
        underflows += event == Event::underflow;
    }
};
TEST(Checked, TellsWhatVanishes) {
    check(operators_in<Checked<Underflow>>([]<class Number>(Number x, Number y, Results& results) {
              const auto count = [&](const auto& operation) {
                  underflows = 0;
                  operation();
                  results.add(underflows);
              };
              count([&] { (void)(x + y), (void)(x - y), (void)(x << 1), (void)(x % y); });
              count([&] { (void)(x * y); });
              count([&] { (void)(x / y); });
              count([&] { (void)multiply_add(x, y, x); });
              count([&] { (void)scale_down<3>(x); });
          }),
          [](int64_t a, int64_t b, exact::Format format, Results& results) {
              const bool product =
                  a != 0 && b != 0 && exact::multiply_add(a, b, 0, format).saturated == 0;
              results.add(0);
              results.add(product);
              results.add(a != 0 && b != 0 && exact::divide(a, b, format).saturated == 0);
              results.add(product);
              results.add(a != 0 && exact::scale(a, -3, format.width).saturated == 0);
          });
}

TEST(Operators, ScaleDownRoundsForEveryPower) {
    check(operators_in<Nearest>([]<class Number>(Number x, Number, Results& results) {
              constexpr int width = RawLimits<typename Number::Raw>::width;
              for (const Number number :
                   {scale_down<0>(x), scale_down<1>(x), scale_down<3>(x), scale_down<width - 1>(x),
                    scale_down<width>(x), scale_down<width + 9>(x)}) {
                  results.add(number.raw());
              }
          }),
          [](int64_t a, int64_t, exact::Format format, Results& results) {
              for (const int power : {0, 1, 3, format.width - 1, format.width, format.width + 9}) {
                  results.add(exact::scale(a, -power, format.width).wrapped);
              }
          });
}

// Counts of every type, including those that an unsigned char cannot represent.
template <class Number, class Count>
void check_shift(int64_t a, Count count, int meaning) {
    using SaturatingNumber = Fixed<Number::integer_bits, Number::fraction_bits, Saturating>;
    const int width = RawLimits<typename Number::Raw>::width;
    const Number x = Number::from_raw(cast<Number>(a));
    const exact::Rounded left = exact::scale(a, std::min(meaning, 200), width);
    Number shifted = x;
    ASSERT_EQ((x << count).raw(), left.wrapped) << a << " << " << meaning;
    ASSERT_EQ((shifted <<= count).raw(), left.wrapped) << a << " << " << meaning;
    ASSERT_EQ((SaturatingNumber::from_raw(cast<Number>(a)) << count).raw(), left.saturated);
    shifted = x;
    ASSERT_EQ((x >> count).raw(), a >> std::min(meaning, 63)) << a << " >> " << meaning;
    ASSERT_EQ((shifted >>= count).raw(), (x >> count).raw());
}
template <class Number>
void check_shifts() {
    const int width = RawLimits<typename Number::Raw>::width;
    std::vector<int64_t> operands = {
        0, 1, -1, -3, 5, exact::smallest(width), exact::largest(width)};
    for (int bit = 1; bit < width - 1; ++bit) {
        for (const int64_t a : {int64_t(1) << bit, (int64_t(1) << bit) - 1}) {
            operands.insert(operands.end(), {a, -a});
        }
    }
    for (const int64_t a : operands) {
        for (int count = 0; count < 256; ++count) {
            check_shift<Number>(a, static_cast<unsigned char>(count), count);
        }
        for (const int count : {0, 1, width - 1, width, 255, 256, 257, 65536, 65537}) {
            check_shift<Number>(a, count, count);
            check_shift<Number>(a, static_cast<int64_t>(count) << 32 | 1, count == 0 ? 1 : 1000);
            check_shift<Number>(a, static_cast<unsigned>(count), count);
        }
        check_shift<Number>(a, -1, 1000);
        check_shift<Number>(a, static_cast<signed char>(-128), 1000);
    }
}
TEST(Operators, ShiftsAreDefinedForEveryCount) {
    check_shifts<Q4_4>();
    check_shifts<Q8_8>();
    check_shifts<Q16_16>();
    check_shifts<Q32_32>();
}

// Every integer type, before anything narrows it.
template <class Number, class Integral>
void check_from_integer() {
    using SaturatingNumber = Fixed<Number::integer_bits, Number::fraction_bits, Saturating>;
    const int width = RawLimits<typename Number::Raw>::width, F = Number::fraction_bits;
    for (const int64_t bits : exact::raws(64, 3)) {
        const auto n = static_cast<Integral>(bits);
        const exact::Rounded expected = exact::scale(n, F, width);
        ASSERT_EQ(Number::from_integer(n).raw(), expected.wrapped) << n;
        ASSERT_EQ(SaturatingNumber::from_integer(n).raw(), expected.saturated) << n;
    }
}
template <class Integral>
void check_from_integer_type() {
    check_from_integer<Q4_4, Integral>();
    check_from_integer<Q8_8, Integral>();
    check_from_integer<Q16_16, Integral>();
    check_from_integer<Fixed<64, 0>, Integral>();
    check_from_integer<Fixed<1, 63>, Integral>();
}
TEST(Fixed, FromIntegerWrapsOrSaturatesTheWholeInteger) {
    EXPECT_EQ(Q8_8::from_integer(65537).raw(), 256);
    EXPECT_EQ((Fixed<8, 8, Saturating>::from_integer(65537).raw()), 32767);
    check_from_integer_type<signed char>();
    check_from_integer_type<unsigned short>();
    check_from_integer_type<int>();
    check_from_integer_type<unsigned>();
    check_from_integer_type<long long>();
    check_from_integer_type<unsigned long long>();
    EXPECT_EQ(Q8_8::from_integer(true).raw(), 256);
    EXPECT_EQ(Q8_8::from_integer('0').raw(), 48 * 256);
}

TEST(Fixed, ClampPrefersTheLowerBoundOfAContradiction) {
    const auto n = [](int i) { return Q8_8::from_integer(static_cast<int16_t>(i)); };
    EXPECT_EQ(clamp(n(5), n(0), n(3)), n(3));
    EXPECT_EQ(clamp(n(-5), n(0), n(3)), n(0));
    EXPECT_EQ(clamp(n(2), n(0), n(3)), n(2));
    EXPECT_EQ(clamp(n(2), n(3), n(0)), n(3));
}

TEST(Vector, OperationsTakeNumbersInARow) {
    const auto n = [](int i) { return Q16_16::from_integer(i); };
    const Q16_16 a[3] = {n(2), n(-3), n(6)}, b[3] = {n(5), n(7), n(-1)};
    EXPECT_EQ(dot2(a, b), n(-11));
    EXPECT_EQ(dot3(a, b), n(-17));
    EXPECT_EQ(length2(b + 1).raw(), 463410);  // 5 sqrt(2) 2^16 = 463409.5..
    EXPECT_EQ(length3(a), n(7));
    Q16_16 unit[3];
    normalise3(a, unit);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(unit[i].raw(), a[i].raw() / 7.0, 1) << i;
}

TEST(Math, SincosIsSineAndCosine) {
    const Q16_16 angle = Q16_16::from_raw(123456);
    EXPECT_EQ(sincos(angle).sine, sin(angle));
    EXPECT_EQ(sincos(angle).cosine, cos(angle));
}

TEST(Published, TruncatesTowardZero) {
    using Number = Fixed<16, 16, Published>;
    const Number third = Number::from_integer(1) / Number::from_integer(3);
    EXPECT_EQ(third.raw(), 21845);
    EXPECT_EQ((-third).raw() * 3 / 3, -21845);
    EXPECT_EQ((Number::from_raw(1) * Number::from_raw(-65535)).raw(), 0);
    EXPECT_EQ(sqrt(Number::from_integer(2)).raw(), 92681);
}

static_assert((Q16_16::from_integer(3) * Q16_16::from_integer(5)).raw() == 15 << 16,
              "Products of constants are constants.");
static_assert((Q32_32::from_integer(1) / Q32_32::from_integer(3)).raw() == 0x55555555,
              "Quotients of constants are constants.");

}  // namespace
