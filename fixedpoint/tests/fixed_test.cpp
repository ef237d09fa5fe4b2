// SPDX-License-Identifier: MIT
// The operators of Fixed in every arithmetic, against exact integers: all pairs of Q4.4, boundary
// and random pairs of the others.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <fixedpoint/arithmetic/checked.hpp>
#include <fixedpoint/arithmetic/published.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/arithmetic/small.hpp>
#include <fixedpoint/math.hpp>
#include <fixedpoint/vector.hpp>
#include <random>
#include <vector>

namespace {

using namespace fixedpoint;
using boost::multiprecision::cpp_int;

// floor(numerator / denominator + 1/2), exact.
cpp_int nearest(cpp_int numerator, cpp_int denominator) {
    if (denominator < 0) {
        numerator = -numerator;
        denominator = -denominator;
    }
    const cpp_int twice = 2 * numerator + denominator;
    cpp_int quotient = twice / (2 * denominator);
    if (twice < 0 && quotient * 2 * denominator != twice) --quotient;
    return quotient;
}

template <class Number>
cpp_int clamped(const cpp_int& exact) {
    const cpp_int low = Number::min().raw(), high = Number::max().raw();
    return exact < low ? low : exact > high ? high : exact;
}

template <class Number>
cpp_int wrapped(const cpp_int& exact) {
    const cpp_int modulus = cpp_int(1) << RawLimits<typename Number::Raw>::width;
    cpp_int result = exact % modulus;
    if (result < 0) result += modulus;
    return result >= modulus / 2 ? cpp_int(result - modulus) : result;
}

template <class Number>
std::vector<typename Number::Raw> boundary() {
    using Raw = typename Number::Raw;
    constexpr int F = Number::fraction_bits;
    std::vector<Raw> values = {0,
                               1,
                               -1,
                               2,
                               -2,
                               3,
                               RawLimits<Raw>::max,
                               RawLimits<Raw>::min,
                               Raw(RawLimits<Raw>::max - 1),
                               Raw(RawLimits<Raw>::min + 1),
                               RawLimits<Raw>::max / 2};
    for (int bit = 1; bit<RawLimits<Raw>::width - 1; bit += RawLimits<Raw>::width> 16 ? 3 : 1) {
        const Raw power = static_cast<Raw>(Raw(1) << bit);
        for (const Raw value : {power, Raw(power - 1), Raw(power + 1)}) {
            values.push_back(value);
            values.push_back(static_cast<Raw>(-value));
        }
    }
    values.push_back(static_cast<Raw>(Unsigned<Raw>(1) << F));
    return values;
}

template <class Number, class Judge>
void for_each_pair(const Judge& judge) {
    using Raw = typename Number::Raw;
    if (sizeof(Raw) == 1) {
        for (int a = -128; a < 128; ++a) {
            for (int b = -128; b < 128; ++b) judge(Raw(a), Raw(b));
        }
        return;
    }
    for (const Raw a : boundary<Number>()) {
        for (const Raw b : boundary<Number>()) judge(a, b);
    }
    std::mt19937_64 random(20260);
    for (int i = 0; i < 20000; ++i) {
        // Log-uniform magnitudes: shifts by a random number of bits.
        const auto draw = [&] {
            return static_cast<Raw>(static_cast<Raw>(random()) >>
                                    (random() % RawLimits<Raw>::width));
        };
        judge(draw(), draw());
    }
}

template <class Number>
struct Operators : testing::Test {};

using Formats = testing::Types<Q4_4, Q8_8, Q16_16, Q32_32, Fixed<1, 7>, Fixed<8, 0>, Fixed<1, 15>,
                               Fixed<8, 24>, Fixed<24, 8>, Fixed<1, 31>, Fixed<32, 0>, Fixed<1, 63>,
                               Fixed<16, 48>, Fixed<64, 0>>;
TYPED_TEST_SUITE(Operators, Formats);

TYPED_TEST(Operators, DefaultRoundsToNearestAndWrapsOrClamps) {
    using Number = TypeParam;
    for_each_pair<Number>([](auto a, auto b) {
        const Number x = Number::from_raw(a), y = Number::from_raw(b);
        const cpp_int A = a, B = b, one = cpp_int(1) << Number::fraction_bits;
        ASSERT_EQ((x + y).raw(), wrapped<Number>(A + B)) << +a << " " << +b;
        ASSERT_EQ((x - y).raw(), wrapped<Number>(A - B)) << +a << " " << +b;
        ASSERT_EQ((-x).raw(), wrapped<Number>(-A)) << +a;
        ASSERT_EQ((x * y).raw(),
                  wrapped<Number>(nearest(A * B, cpp_int(1) << Number::fraction_bits)))
            << +a << " " << +b;
        const cpp_int quotient = b != 0  ? clamped<Number>(nearest(A * one, B))
                                 : a > 0 ? cpp_int(Number::max().raw())
                                 : a < 0 ? cpp_int(Number::min().raw())
                                         : cpp_int(0);
        ASSERT_EQ((x / y).raw(), quotient) << +a << " " << +b;
        ASSERT_EQ((x % y).raw(), b == 0 ? A : cpp_int(A % B)) << +a << " " << +b;
    });
}

TYPED_TEST(Operators, SmallDividesAsTheDefault) {
    using Number = TypeParam;
    using SmallNumber = Fixed<Number::integer_bits, Number::fraction_bits, Small>;
    for_each_pair<Number>([](auto a, auto b) {
        ASSERT_EQ((SmallNumber::from_raw(a) / SmallNumber::from_raw(b)).raw(),
                  (Number::from_raw(a) / Number::from_raw(b)).raw())
            << +a << " " << +b;
    });
}

TYPED_TEST(Operators, SaturatingClamps) {
    using Plain = TypeParam;
    using Number = Fixed<Plain::integer_bits, Plain::fraction_bits, Saturating>;
    for_each_pair<Number>([](auto a, auto b) {
        const Number x = Number::from_raw(a), y = Number::from_raw(b);
        const cpp_int A = a, B = b;
        ASSERT_EQ((x + y).raw(), clamped<Number>(A + B)) << +a << " " << +b;
        ASSERT_EQ((x - y).raw(), clamped<Number>(A - B)) << +a << " " << +b;
        ASSERT_EQ((-x).raw(), clamped<Number>(-A)) << +a;
        ASSERT_EQ(abs(x).raw(), clamped<Number>(A < 0 ? cpp_int(-A) : A)) << +a;
        ASSERT_EQ((x * y).raw(),
                  clamped<Number>(nearest(A * B, cpp_int(1) << Number::fraction_bits)))
            << +a << " " << +b;
    });
}

// Each product and each sum by itself, in exact arithmetic.
TYPED_TEST(Operators, SaturatingClampsProductsAndSumsOfSeveral) {
    using Number = Fixed<TypeParam::integer_bits, TypeParam::fraction_bits, Saturating>;
    const auto product = [](const cpp_int& a, const cpp_int& b) -> cpp_int {
        return clamped<Number>(nearest(a * b, cpp_int(1) << Number::fraction_bits));
    };
    for_each_pair<Number>([&](auto a, auto b) {
        const Number x = Number::from_raw(a), y = Number::from_raw(b);
        const cpp_int A = a, B = b, square = product(A, A), crossed = product(A, B);
        ASSERT_EQ(multiply_add(x, y, x).raw(), clamped<Number>(crossed + A)) << +a << " " << +b;
        const cpp_int both = clamped<Number>(square + crossed);
        const Number left[3] = {x, x, y}, right[3] = {x, y, y};
        ASSERT_EQ(dot2(left, right).raw(), both) << +a << " " << +b;
        ASSERT_EQ(dot3(left, right).raw(), clamped<Number>(both + product(B, B)))
            << +a << " " << +b;
    });
}

int overflows = 0, zero_divisors = 0, domain_errors = 0, underflows = 0;
struct Counter {
    static void notify(Event event, fixedpoint::Operation) {
        underflows += event == Event::underflow;
        overflows += event == Event::overflow;
        zero_divisors += event == Event::division_by_zero;
        domain_errors += event == Event::domain_error;
    }
};

TYPED_TEST(Operators, CheckedNotifiesExactlyWhereTheResultDoesNotFit) {
    using Plain = TypeParam;
    using Number = Fixed<Plain::integer_bits, Plain::fraction_bits, Checked<Counter>>;
    const auto count = [](const auto& operation) {
        overflows = zero_divisors = underflows = 0;
        operation();
        return overflows;
    };
    const auto exceeds = [](const cpp_int& exact) { return exact != clamped<Number>(exact); };
    for_each_pair<Number>([&](auto a, auto b) {
        const Number x = Number::from_raw(a), y = Number::from_raw(b);
        const Plain p = Plain::from_raw(a), q = Plain::from_raw(b);
        const cpp_int A = a, B = b, one = cpp_int(1) << Number::fraction_bits;
        ASSERT_EQ(count([&] { ASSERT_EQ((x + y).raw(), (p + q).raw()); }), exceeds(A + B));
        ASSERT_EQ(count([&] { ASSERT_EQ((x - y).raw(), (p - q).raw()); }), exceeds(A - B));
        ASSERT_EQ(count([&] { ASSERT_EQ((-x).raw(), (-p).raw()); }), exceeds(-A));
        ASSERT_EQ(count([&] { ASSERT_EQ((x * y).raw(), (p * q).raw()); }),
                  exceeds(nearest(A * B, one)))
            << +a << " " << +b;
        ASSERT_EQ(underflows, A * B != 0 && nearest(A * B, one) == 0) << +a << " " << +b;
        ASSERT_EQ(count([&] { ASSERT_EQ((x / y).raw(), (p / q).raw()); }),
                  b != 0 && exceeds(nearest(A * one, B)))
            << +a << " " << +b;
        ASSERT_EQ(zero_divisors, b == 0);
        ASSERT_EQ(count([&] { ASSERT_EQ((x % y).raw(), (p % q).raw()); }), 0);
        ASSERT_EQ(zero_divisors, b == 0);
    });
}

TYPED_TEST(Operators, CheckedNotifiesWhereACompoundDoesNotFit) {
    using Plain = TypeParam;
    using Number = Fixed<Plain::integer_bits, Plain::fraction_bits, Checked<Counter>>;
    const auto count = [](const auto& operation) {
        overflows = underflows = 0;
        operation();
        return overflows;
    };
    const auto exceeds = [](const cpp_int& exact) { return exact != clamped<Number>(exact); };
    for_each_pair<Number>([&](auto a, auto b) {
        const auto c = static_cast<decltype(a)>(a ^ static_cast<decltype(a)>(b << 1));
        const Number x[3] = {Number::from_raw(a), Number::from_raw(b), Number::from_raw(c)};
        const Number y[3] = {Number::from_raw(b), Number::from_raw(a), Number::from_raw(c)};
        const cpp_int A = a, B = b, C = c, one = cpp_int(1) << Number::fraction_bits;
        ASSERT_EQ(count([&] { (void)dot2(x, y); }), exceeds(nearest(2 * A * B, one)))
            << +a << " " << +b;
        ASSERT_EQ(count([&] { (void)dot3(x, y); }), exceeds(nearest(2 * A * B + C * C, one)))
            << +a << " " << +b;
        ASSERT_EQ(count([&] { (void)multiply_add(x[0], x[1], x[2]); }),
                  exceeds(nearest(A * B + C * one, one)))
            << +a << " " << +b;
        ASSERT_EQ(underflows, A * B != 0 && nearest(A * B, one) == 0);
        const cpp_int limit = 2 * cpp_int(Number::max().raw()) + 1;
        ASSERT_EQ(count([&] { (void)length2(x); }), 4 * (A * A + B * B) >= limit * limit);
        ASSERT_EQ(count([&] { (void)length3(x); }), 4 * (A * A + B * B + C * C) >= limit * limit);
        ASSERT_EQ(count([&] { ASSERT_EQ(scale_down<3>(x[0]).raw(), nearest(A, 8)); }), 0);
        ASSERT_EQ(underflows, A != 0 && nearest(A, 8) == 0);
        constexpr int width = 8 * sizeof(a);
        ASSERT_EQ(scale_down<1>(x[0]).raw(), nearest(A, 2));
        ASSERT_EQ(scale_down<width - 1>(x[0]).raw(), nearest(A, cpp_int(1) << (width - 1)));
        ASSERT_EQ(scale_down<width>(x[0]).raw(), nearest(A, cpp_int(1) << width));
    });
}

TEST(Checked, NotifiesOfDomainErrors) {
    using Number = Fixed<16, 16, Checked<Counter>>;
    const Number zero, negative = Number::from_raw(-1), positive = Number::from_integer(2);
    overflows = zero_divisors = domain_errors = 0;
    (void)sqrt(zero), (void)sqrt(positive), (void)log(positive), (void)reciprocal_sqrt(positive);
    EXPECT_EQ(overflows + zero_divisors + domain_errors, 0);
    EXPECT_EQ(sqrt(negative).raw(), 0);
    EXPECT_EQ(log(zero).raw(), RawLimits<int32_t>::min);
    EXPECT_EQ(reciprocal_sqrt(negative).raw(), 0);
    EXPECT_EQ(domain_errors, 3);
    EXPECT_EQ(reciprocal_sqrt(zero).raw(), RawLimits<int32_t>::max);
    EXPECT_EQ(zero_divisors, 1);
}

TYPED_TEST(Operators, ShiftsAreDefinedForEveryCount) {
    using Number = TypeParam;
    for (const auto a : boundary<Number>()) {
        for (int n = 0; n < 256; ++n) {
            const auto count = static_cast<unsigned char>(n);
            const Number x = Number::from_raw(a);
            ASSERT_EQ((x << count).raw(), wrapped<Number>(cpp_int(a) << n)) << +a << " << " << n;
            // Floor division: round toward minus infinity.
            const cpp_int power = cpp_int(1) << n;
            cpp_int floor = cpp_int(a) / power;
            if (a < 0 && floor * power != a) --floor;
            ASSERT_EQ((x >> count).raw(), floor) << +a << " >> " << n;
        }
    }
}

TYPED_TEST(Operators, ComparisonsFollowTheRaws) {
    using Number = TypeParam;
    for_each_pair<Number>([](auto a, auto b) {
        const Number x = Number::from_raw(a), y = Number::from_raw(b);
        ASSERT_EQ(x == y, a == b);
        ASSERT_EQ(x != y, a != b);
        ASSERT_EQ(x < y, a < b);
        ASSERT_EQ(x > y, a > b);
        ASSERT_EQ(x <= y, a <= b);
        ASSERT_EQ(x >= y, a >= b);
        ASSERT_EQ(min(x, y).raw(), std::min(a, b));
        ASSERT_EQ(max(x, y).raw(), std::max(a, b));
    });
}

TYPED_TEST(Operators, AssignmentsEqualTheirOperators) {
    using Number = TypeParam;
    for_each_pair<Number>([](auto a, auto b) {
        const Number x = Number::from_raw(a), y = Number::from_raw(b);
        Number sum = x, difference = x, product = x, quotient = x, rest = x;
        ASSERT_EQ(sum += y, x + y);
        ASSERT_EQ(difference -= y, x - y);
        ASSERT_EQ(product *= y, x * y);
        ASSERT_EQ(quotient /= y, x / y);
        ASSERT_EQ(rest %= y, x % y);
    });
}

TEST(Fixed, FromIntegerWrapsOrSaturates) {
    EXPECT_EQ(Q8_8::from_integer(3).raw(), 768);
    EXPECT_EQ(Q8_8::from_integer(128).raw(), -32768);
    using Clamping = Fixed<8, 8, Saturating>;
    EXPECT_EQ(Clamping::from_integer(128).raw(), 32767);
    EXPECT_EQ(Clamping::from_integer(-129).raw(), -32768);
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
