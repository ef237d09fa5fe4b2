// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <deque>
#include <fixedpoint/blocks/biquad.hpp>
#include <fixedpoint/blocks/moving_average.hpp>
#include <fixedpoint/blocks/one_pole.hpp>

#include "../exact.hpp"
#include "exact_sum.hpp"

using namespace fixedpoint;
using exact::Exact;
using exact::random_number;
using exact::value;

namespace {

template <class Number>
class OfNumber : public testing::Test {};
using Numbers = testing::Types<Q4_4, Q8_8, Q16_16, Fixed<8, 24>, Q32_32, Fixed<1, 15>, Fixed<3, 5>,
                               Fixed<16, 0>, Fixed<3, 29>, Fixed<4, 60>, Fixed<16, 16, Saturating>,
                               Fixed<8, 8, Saturating>>;
TYPED_TEST_SUITE(OfNumber, Numbers);

// The next sum recovers what one sum has lost: the state never departs from the exact one.
TYPED_TEST(OfNumber, LosesNothingOfAnIntegral) {
    using Number = TypeParam;
    constexpr int F = Number::fraction_bits;
    std::mt19937_64 random(1);
    CarriedError<Number> error;
    Number sum;
    Exact exact_sum = 0;
    for (int i = 0; i < 20000; ++i) {
        Number a = random_number<Number>(random, 0.9), b = random_number<Number>(random, 0.9);
        if ((exact_sum > 0) == (exact::product(a, b) > 0)) a = Number::from_raw(-a.raw());
        sum = error.multiply_add(a, b, sum);
        exact_sum += exact::product(a, b);
        ASSERT_EQ(Exact(sum.raw()), exact::rounded(exact_sum, F)) << i;
    }
}
// Every output and input.
TEST(OnePole, ArrivesAtItsInputWithoutOvershoot) {
    for (const int k : {1, 2, 3, 5, 8, 13, 16}) {
        const int limit = 2 + 8 * 16 / k;
        for (int y = -128; y <= 127; ++y) {
            for (int x = -128; x <= 127; x += exact::operand_step) {
                OnePole<Q4_4> filter(Q4_4::from_raw(int8_t(k)), Q4_4::from_raw(int8_t(y)));
                int last = y, steps = 0;
                while (last != x && steps < limit) {
                    const int next = filter.update(Q4_4::from_raw(int8_t(x))).raw();
                    ASSERT_TRUE(x > y ? last <= next && next <= x : last >= next && next >= x)
                        << k << ' ' << y << ' ' << x;
                    last = next;
                    ++steps;
                }
                ASSERT_EQ(last, x) << k << ' ' << y;
                ASSERT_EQ(filter.update(Q4_4::from_raw(int8_t(x))).raw(), x);
            }
        }
    }
}
// Even if k x is far below an ulp, the filter moves.
TEST(OnePole, ArrivesWithTheSmallestCoefficient) {
    OnePole<Q8_8> filter(Q8_8::ulp());
    for (int i = 0; i < 3000; ++i) filter.update(Q8_8::max());
    EXPECT_EQ(filter.output().raw(), Q8_8::max().raw());
    for (int i = 0; i < 4000; ++i) filter.update(Q8_8::min());
    EXPECT_EQ(filter.output().raw(), Q8_8::min().raw());
}
TEST(OnePole, LimitsItsCoefficient) {
    OnePole<Q8_8> above(Q8_8::max()), below(Q8_8::min());
    EXPECT_EQ(above.update(Q8_8::from_integer(3)).raw(), 3 << 8);
    EXPECT_EQ(below.update(Q8_8::from_integer(3)).raw(), 0);
}
TYPED_TEST(OfNumber, FollowsTheExactOnePoleWithinAnUlp) {
    using Number = TypeParam;
    std::mt19937_64 random(3);
    for (const long double coefficient : {0.0625L, 0.4L, 0.9L}) {
        const Number k = Number::from_raw(
            static_cast<typename Number::Raw>(std::ldexp(coefficient, Number::fraction_bits)));
        OnePole<Number> filter(k);
        long double exact = 0;
        for (int i = 0; i < 20000; ++i) {
            const Number x = random_number<Number>(random, value(Number::max()) / 2);
            exact += value(k) * (value(x) - exact);
            const long double error = std::abs(value(filter.update(x)) - exact);
            ASSERT_LE(error, exact::ulp<Number>() * (1 + 1e-3L) + 1e-15L * std::abs(exact)) << i;
        }
    }
}

struct Coefficients {
    double b0, b1, b2, a1, a2;
};
// Low-pass filters with poles closer and closer to 1, a resonator, and a high-pass filter; all
// coefficients are multiples of 1/16, then of 1/256.
const Coefficients coarse[] = {
    {.0625, 0, 0, -1.75, .8125}, {1, 0, 0, -1.5, .625}, {1, 0, 0, 0, .9375}, {1, -2, 1, 1.25, .5}};
const Coefficients fine[] = {
    {5. / 256, 10. / 256, 5. / 256, -450. / 256, 214. / 256},
    {1. / 256, 0, 0, -500. / 256, 245. / 256},
    {1, 0, 0, -1.5, 250. / 256},
};

template <class Number>
BiquadCoefficients<Number> of(const Coefficients& c) {
    const auto number = [](double x) {
        return Number::from_raw(
            static_cast<typename Number::Raw>(std::ldexp(x, Number::fraction_bits)));
    };
    return {number(c.b0), number(c.b1), number(c.b2), number(c.a1), number(c.a2)};
}

// 1/2 sum |g_n|, where g is the impulse response of (1 + k1 z^-1 + k2 z^-2) / (1 + a1 z^-1 + a2
// z^-2), and k1 and k2 are the integers nearest to a1 and a2; ties are rounded half up for -a.
long double dead_band(const Coefficients& c) {
    const long double k1 = -std::floor(-c.a1 + .5), k2 = -std::floor(-c.a2 + .5);
    long double sum = 0, y1 = 0, y2 = 0;
    for (int n = 0; n < 20000; ++n) {
        const long double y = (n == 0) + k1 * (n == 1) + k2 * (n == 2) - c.a1 * y1 - c.a2 * y2;
        sum += std::abs(y);
        y2 = y1;
        y1 = y;
    }
    return sum / 2;
}

template <class Number>
void follows_the_exact_filter(const Coefficients& c, long double amplitude) {
    Biquad<Number> filter(of<Number>(c));
    const long double bound = exact::ulp<Number>() * dead_band(c) * (1 + 1e-6L) + 1e-14L;
    std::mt19937_64 random(4);
    long double x1 = 0, x2 = 0, y1 = 0, y2 = 0;
    for (int i = 0; i < 20000; ++i) {
        const Number input = random_number<Number>(random, amplitude);
        const long double x = value(input);
        const long double y = c.b0 * x + c.b1 * x1 + c.b2 * x2 - c.a1 * y1 - c.a2 * y2;
        x2 = x1, x1 = x, y2 = y1, y1 = y;
        ASSERT_LE(std::abs(value(filter.update(input)) - y), bound) << i;
    }
}
TEST(Biquad, FollowsTheExactFilterWithinItsDeadBand) {
    for (const Coefficients& c : coarse) follows_the_exact_filter<Q4_4>(c, 0.25);
    for (const Coefficients& c : fine) {
        follows_the_exact_filter<Q8_8>(c, 0.5);
        follows_the_exact_filter<Q16_16>(c, 4);
        follows_the_exact_filter<Fixed<8, 24>>(c, 0.5);
        follows_the_exact_filter<Q32_32>(c, 4);
        follows_the_exact_filter<Fixed<16, 16, Saturating>>(c, 4);
    }
}

// Starting from many pairs of previous outputs y1 and y2: the remaining output without input is
// within the dead band. The same filter without error feedback stays further out.
TEST(Biquad, EndsInItsDeadBandFromEveryState) {
    int largest_of_all = 0, naive_of_all = 0;
    for (Coefficients c : coarse) {
        c = {1, 0, 0, c.a1, c.a2};  // an input sets any output
        const int band = static_cast<int>(dead_band(c)), settled = 160, watched = 96;
        int largest = 0, naive_largest = 0;
        for (int start = 0; start < 8 * 32 * 32; start += exact::operand_step) {
            Biquad<Q4_4> filter(of<Q4_4>(c));
            // Small enough for the outputs to stay in range.
            const int y1 = start % 32 - 16, y2 = start / 32 % 32 - 16, y3 = start / 1024;
            const int a1 = int(16 * c.a1), a2 = int(16 * c.a2);
            for (const int input : {y3, y2, y1}) filter.update(Q4_4::from_raw(int8_t(input)));
            int p = y1, q = y2;
            for (int i = 0; i < settled + watched; ++i) {
                const int y = filter.update(Q4_4()).raw();
                const int naive = (-a1 * p - a2 * q + 8) >> 4;
                q = p, p = naive;
                if (i < settled) continue;
                largest = std::max(largest, std::abs(y));
                naive_largest = std::max(naive_largest, std::abs(naive));
            }
        }
        EXPECT_LE(largest, band) << c.a1;

        largest_of_all = std::max(largest_of_all, largest);
        naive_of_all = std::max(naive_of_all, naive_largest);
    }
    EXPECT_LT(largest_of_all, naive_of_all);
}
// No offset remains at low frequencies, where rounding alone would leave many ulp.
TEST(Biquad, HasTheGainOfItsCoefficients) {
    Biquad<Q8_8> filter(of<Q8_8>(fine[0]));
    long sum = 0;
    const Q8_8 input = Q8_8::from_raw(100);
    for (int i = 0; i < 1000; ++i) filter.update(input);
    for (int i = 0; i < 4096; ++i) sum += filter.update(input).raw();
    EXPECT_NEAR(static_cast<double>(sum) / 4096, 100, 0.05);
}
TEST(Biquad, StaysAtTheEndOfTheRangeWhereItSaturates) {
    using Number = Fixed<8, 8, Saturating>;
    Biquad<Number> filter(of<Number>({1, 0, 0, -1.5, 250. / 256}));
    Number y;
    for (int i = 0; i < 2; ++i) y = filter.update(Number::max());
    EXPECT_EQ(y.raw(), Number::max().raw());
}

template <class Number, uint16_t N>
void is_the_exact_mean() {
    std::mt19937_64 random(5);
    MovingAverage<Number, N> filter;
    std::deque<Exact> window(N, 0);
    Exact sum = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto bits = random();
        const Number x = bits % 8 == 0 ? Number::max()
                         : bits % 8 == 1
                             ? Number::min()
                             : Number::from_raw(static_cast<typename Number::Raw>(random()));
        window.push_back(x.raw());
        sum += x.raw() - window.front();
        window.pop_front();
        const Exact mean = (2 * sum + N + (Exact(1) << 70) * 2 * N) / (2 * N) - (Exact(1) << 70);
        ASSERT_EQ(Exact(filter.update(x).raw()), mean) << i;
    }
}
TYPED_TEST(OfNumber, AveragesExactly) {
    is_the_exact_mean<TypeParam, 2>();
    is_the_exact_mean<TypeParam, 16>();
    is_the_exact_mean<TypeParam, 256>();
}
TEST(MovingAverage, BeginsWithWhatItIsGiven) {
    MovingAverage<Q8_8, 4> filter(Q8_8::from_integer(-8));
    EXPECT_EQ(filter.update(Q8_8::from_integer(0)).raw(), -6 * 256);
}

}  // namespace
