// SPDX-License-Identifier: MIT
// Distances and directions by products, compared with long double's root and quotient.
#include <gtest/gtest.h>

#include <cmath>
#include <engine/distance.hpp>
#include <random>

using engine::Fixed;
using engine::SaturatingFixed;

namespace {

using Real = long double;

template <int I, int F, class A>
Real value(Fixed<I, F, A> x) {
    return std::ldexp(static_cast<Real>(x.raw()), -F);
}
template <class Number>
constexpr int fraction = 0;
template <int I, int F, class A>
constexpr int fraction<Fixed<I, F, A>> = F;

template <class Number, int N>
struct Measured {
    bool found;
    Real excess, distance;
    Real excess_error, direction_error;  // ulp
};

// For two points on either side of the origin.
template <class Number, int N, bool may_be_slack = false>
Measured<Number, N> measure(const engine::Vector<Number, N>& difference, Number length) {
    engine::Vector<Number, N> first, second, direction;
    for (unsigned char i = 0; i < N; ++i) {
        const auto raw = difference[i].raw();
        second[i] = Number::from_raw(static_cast<typename Number::Raw>(-(raw / 3)));
        first[i] = difference[i] + second[i];
    }
    Number excess = {};
    Measured<Number, N> result = {};
    result.found = engine::measure<may_be_slack>(first, second, length, engine::inverse_of(length),
                                                 direction, excess);
    for (unsigned char i = 0; i < N; ++i)
        result.distance = std::hypot(result.distance, value(difference[i]));
    result.excess = value(excess);
    const Real ulp = std::ldexp(Real(1), -fraction<Number>);
    result.excess_error = std::abs(result.excess - (result.distance - value(length))) / ulp;
    for (unsigned char i = 0; i < N; ++i) {
        const Real error = value(direction[i]) - value(difference[i]) / result.distance;
        result.direction_error = std::max(result.direction_error, std::abs(error) / ulp);
    }
    return result;
}

// A vector of that length in a random direction.
template <class Number, int N>
engine::Vector<Number, N> any_of_length(Real length, std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    Real v[N], square = 0;
    for (Real& x : v) {
        x = normal(random);
        square += x * x;
    }
    engine::Vector<Number, N> rounded;
    for (unsigned char i = 0; i < N; ++i) {
        const Real raw = std::ldexp(v[i] / std::sqrt(square) * length, fraction<Number>);
        rounded[i] = Number::from_raw(static_cast<typename Number::Raw>(std::llround(raw)));
    }
    return rounded;
}

template <class Number>
Number number(Real x) {
    return Number::from_raw(
        static_cast<typename Number::Raw>(std::llround(std::ldexp(x, fraction<Number>))));
}

// All factors of 16 bits: the nearest to 2^halvings / a in the format, or 0 if that does not fit.
// For 2^-k it is 1.
TEST(Inverse, IsTheNearestFactor) {
    using Number = Fixed<8, 8>;
    for (int a = -32768; a < 32768; ++a) {
        const auto inverse = engine::inverse_of(Number::from_raw(static_cast<int16_t>(a)));
        if (a == 4 || a == 8 || a == 16 || a == 32 || a == 64 || a == 128 || a == 256) {
            ASSERT_EQ(inverse.factor.raw(), 256) << a;
            ASSERT_EQ(256 >> (-1 - inverse.halvings), a);
            continue;
        }
        const Real exact = a > 0 ? std::ldexp(Real(65536) / a, inverse.halvings) : 0;
        const bool fits = a > 0 && std::floor(exact + Real(0.5)) <= 32767;
        ASSERT_EQ(inverse.factor.raw(), fits ? std::floor(exact + Real(0.5)) : 0) << a;
        if (a > 256)
            ASSERT_TRUE(exact > 128 && exact <= 256) << a;
        else
            ASSERT_EQ(inverse.halvings, 0) << a;
    }
    for (int a : {1, 2, 3, 77, 1 << 8, 1 << 14, 1 << 15, 1 << 16, 3 << 15}) {
        const auto inverse = engine::inverse_of(Fixed<16, 16>::from_raw(a));
        const auto eighth = Fixed<16, 16>::from_raw(1 << 13);
        const Real product = std::floor(std::ldexp(inverse.factor.raw(), 13 - 16) + Real(0.5));
        const int doublings = inverse.halvings < 0 ? -1 - inverse.halvings : 0;
        if (inverse.factor.raw() != 0) {
            EXPECT_EQ(engine::times(eighth, inverse).raw(), std::ldexp(product, doublings)) << a;
        }
    }
    EXPECT_EQ(engine::inverse_of(4.0).factor, 0.25);
    EXPECT_EQ(engine::inverse_of(4.0).halvings, 0);
    EXPECT_EQ(engine::times(3.0, engine::inverse_of(4.0)), 0.75);
}

// A length known at compile time has the same inverse as at run time.
template <class Number>
void expect_same_inverses() {
    using Raw = typename Number::Raw;
    std::mt19937 random(12);
    for (int i = 0; i < 100'000; ++i) {
        const unsigned unused = 33 - 8 * sizeof(Raw);
        const auto raw = static_cast<Raw>(random() >> (unused + random() % (32 - unused)));
        if (raw == 0) continue;
        const auto a = Number::from_raw(raw);
        const auto known = engine::inverse_by_quotient(a), found = engine::inverse_by_digits(a);
        ASSERT_EQ(known.factor.raw(), found.factor.raw()) << raw;
        ASSERT_EQ(known.halvings, found.halvings) << raw;
    }
}
TEST(Inverse, OfAKnownLengthIsTheSame) {
    expect_same_inverses<Fixed<16, 16>>();
    expect_same_inverses<Fixed<2, 30>>();
    expect_same_inverses<Fixed<5, 27>>();
    expect_same_inverses<Fixed<24, 8>>();
    expect_same_inverses<Fixed<8, 8>>();
}

// Doubling a difference and a chord equals the product with 2^k, for which the bounds are proven.
template <class Number, int N>
void expect_doublings_as_products() {
    std::mt19937_64 random(13);
    for (int i = 0; i < 20'000; ++i) {
        const int k = static_cast<int>(random() % 6);
        const auto one = std::int32_t(1) << fraction<Number>;
        const engine::Inverse<Number> product = {Number::from_raw(one << k), 0},
                                      doublings = {Number::from_raw(one),
                                                   static_cast<signed char>(-1 - k)};
        const auto length = Number::from_raw(one >> k);
        engine::Vector<Number, N> end, direction[2];
        for (auto& x : end.component) x = Number::from_raw(static_cast<std::int32_t>(random()));
        if (i % 4 != 0)
            end = any_of_length<Number, N>(value(length) * (1 + (i % 3 - 1) / Real(500)), random);
        Number excess[2] = {};
        ASSERT_EQ(engine::measure<false>(end, {}, length, product, direction[0], excess[0]),
                  engine::measure<false>(end, {}, length, doublings, direction[1], excess[1]));
        ASSERT_EQ(direction[0], direction[1]) << i;
        ASSERT_EQ(excess[0].raw(), excess[1].raw()) << i;
        ASSERT_EQ(engine::times(end[0], product).raw(), engine::times(end[0], doublings).raw());
    }
}
TEST(Inverse, DoublingsAreProducts) {
    expect_doublings_as_products<Fixed<16, 16>, 2>();
    expect_doublings_as_products<Fixed<16, 16>, 3>();
    expect_doublings_as_products<Fixed<8, 24>, 2>();
    expect_doublings_as_products<SaturatingFixed<16, 16>, 2>();
}

// Near a length L up to 2 m. A scaled component is off by (1 + L) / 2 ulp, so that e is by
// sqrt(N) (1 + L) / 2 + 3/4, and the excess by L times that and its own rounding; what mend_length
// leaves is below half an ulp. A direction may be too long by 4 ulp more.
template <class Number, int N>
void check_near() {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> relative(-1, 1), exponent(-5, 0.99);
    for (int i = 0; i < 20000; ++i) {
        const Number length = number<Number>(std::exp2(exponent(random)));
        const Real off = std::ldexp(relative(random), -9 - i % 12);
        const Real l = value(length);
        const auto difference = any_of_length<Number, N>(l * (1 + off), random);
        const auto seen = measure<Number, N>(difference, length);
        const Real e_error = std::sqrt(Real(N)) * (1 + l) / 2 + Real(1.25);
        ASSERT_TRUE(seen.found);
        ASSERT_LE(seen.excess_error, l * e_error + Real(0.5)) << "length " << l << ", " << off;
        ASSERT_LE(seen.direction_error, 4 + e_error + 1) << "length " << l << ", " << off;
    }
}
TEST(Distance, IsRightNearTheLength) {
    check_near<Fixed<16, 16>, 2>();
    check_near<Fixed<16, 16>, 3>();
    check_near<SaturatingFixed<16, 16>, 2>();
    check_near<Fixed<8, 24>, 2>();
    check_near<Fixed<32, 32>, 3>();
}

// Every distance that the format holds, for every length: relative to it within a few ulp, plus
// what the rounding of each product adds in an arithmetic that saturates.
template <class Number, int N>
void check_all(int most) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponent(4 - fraction<Number>, most);
    for (int i = 0; i < 20000; ++i) {
        const Real wanted = std::exp2(exponent(random));
        const Number length = number<Number>(std::exp2(exponent(random)));
        if (engine::inverse_of(length).factor == Number()) continue;
        const auto difference = any_of_length<Number, N>(wanted, random);
        if (difference == engine::Vector<Number, N>()) continue;
        const auto seen = measure<Number, N>(difference, length);
        ASSERT_TRUE(seen.found);
        ASSERT_LE(seen.direction_error, 8) << wanted << " of " << value(length);
        ASSERT_LE(seen.excess_error, 4 * std::max(seen.distance, value(length)) + 1.5)
            << wanted << " of " << value(length);
        if (seen.distance > value(length) * Real(1.02)) {
            const auto taut = measure<Number, N, true>(difference, length);
            ASSERT_TRUE(taut.found && taut.excess == seen.excess);
        }
        if (seen.distance < value(length) * Real(0.5)) {
            const bool taut = measure<Number, N, true>(difference, length).found;
            ASSERT_FALSE(taut) << wanted << " of " << value(length);
        }
    }
    EXPECT_FALSE((measure<Number, N>({}, number<Number>(0.75)).found));
}
TEST(Distance, IsRightFarFromTheLength) {
    check_all<SaturatingFixed<16, 16>, 2>(14);
    check_all<SaturatingFixed<16, 16>, 3>(14);
    check_all<SaturatingFixed<8, 24>, 2>(6);
    check_all<SaturatingFixed<2, 30>, 3>(0);
    check_all<SaturatingFixed<24, 8>, 2>(22);
    check_all<SaturatingFixed<8, 8>, 2>(6);
}

// At the ends of a saturating format: the distance stays at its end, the direction keeps its way.
TEST(Distance, SaturatesAtTheEnds) {
    using Number = SaturatingFixed<16, 16>;
    const Number end = Number::from_raw(INT32_MAX);
    engine::Vector<Number, 2> direction;
    Number excess = {};
    const Number length = number<Number>(0.25);
    engine::Vector<Number, 2> difference;
    difference[0] = end;
    difference[1] = -end;
    ASSERT_TRUE(engine::measure<false>(difference, {}, length, engine::inverse_of(length),
                                       direction, excess));
    EXPECT_EQ(excess.raw(), INT32_MAX - 16384);
    EXPECT_NEAR(value(direction[0]), std::sqrt(0.5), 1e-4);
    EXPECT_NEAR(value(direction[1]), -std::sqrt(0.5), 1e-4);
}

}  // namespace
