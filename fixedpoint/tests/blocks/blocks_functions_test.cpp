// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <fixedpoint/blocks/interpolation.hpp>
#include <fixedpoint/blocks/polynomial.hpp>

#include "exact_sum.hpp"

using namespace fixedpoint;
using exact::Exact;
using exact::number;
using exact::value;

namespace {

template <class Number, class Coefficient, uint16_t N>
void rounds_nearly_once(const Table<Coefficient, N>& c) {
    constexpr int F = Number::fraction_bits;
    const long double bound = exact::ulp<Number>() / 2 + (N - 1) * exact::ulp<Coefficient>() / 2;
    for (long n = -(1l << F); n <= 1l << F; ++n) {
        const Number x = Number::from_raw(static_cast<typename Number::Raw>(n));
        long double exact = 0;
        for (int i = N - 1; i >= 0; --i) exact = exact * value(x) + value(c[uint16_t(i)]);
        ASSERT_LE(std::abs(value(polynomial(x, c)) - exact), bound + 1e-17L) << n;
    }
}
const Table<Q16_16, 6> of_q16_16 = {{number<Q16_16>(0.25L), number<Q16_16>(1.5704L),
                                     number<Q16_16>(-0.1L), number<Q16_16>(-0.6442L),
                                     number<Q16_16>(0.01L), number<Q16_16>(0.0737L)}};
const Table<Fixed<8, 24>, 6> of_q8_24 = {
    {number<Fixed<8, 24>>(0.25L), number<Fixed<8, 24>>(1.5704L), number<Fixed<8, 24>>(-0.1L),
     number<Fixed<8, 24>>(-0.6442L), number<Fixed<8, 24>>(0.01L), number<Fixed<8, 24>>(0.0737L)}};
const Table<Fixed<8, 24>, 10> of_degree_9 = {
    {number<Fixed<8, 24>>(1L), number<Fixed<8, 24>>(1L), number<Fixed<8, 24>>(1L),
     number<Fixed<8, 24>>(-1L), number<Fixed<8, 24>>(0.7L), number<Fixed<8, 24>>(-0.3L),
     number<Fixed<8, 24>>(0.3L), number<Fixed<8, 24>>(0.1L), number<Fixed<8, 24>>(-1.1L),
     number<Fixed<8, 24>>(0.9L)}};
// Exhaustive over -1..1.
TEST(Polynomial, RoundsNearlyOnceInAFinerFormat) {
    rounds_nearly_once<Q8_8>(of_q16_16);
    rounds_nearly_once<Q8_8>(of_q8_24);
    rounds_nearly_once<Q16_16>(of_q8_24);
    rounds_nearly_once<Q16_16>(of_degree_9);
}
TEST(Polynomial, MayBeConstant) {
    const Table<Q16_16, 1> constant = {{number<Q16_16>(2.5L)}};
    EXPECT_EQ(polynomial(Q8_8::max(), constant).raw(), 640);
}
TEST(Polynomial, IsThatOfItsOperatorsInDouble) {
    const Table<double, 3> c = {{1, -2, 0.5}};
    EXPECT_EQ(polynomial(3.0, c), 1 - 6 + 4.5);
}

// floor(y_i + (y_(i+1) - y_i) w + 1/2) in exact arithmetic.
template <int StepExponent, class Number, uint16_t N>
typename Number::Raw interpolated(const Table<Number, N>& table, Number begin, Number x) {
    constexpr int bits = Number::fraction_bits + StepExponent;
    const Exact distance = Exact(x.raw()) - begin.raw();
    if (distance <= 0) return table[0].raw();
    if (distance >= Exact(N - 1) << bits) return table[N - 1].raw();
    const auto i = static_cast<uint16_t>(distance >> bits);
    const Exact weight = distance - (Exact(i) << bits), left = table[i].raw();
    return static_cast<typename Number::Raw>(
        exact::rounded((left << bits) + (table[i + 1].raw() - left) * weight, bits));
}
template <int StepExponent, class Number, uint16_t N>
void is_exact(const Table<Number, N>& table, Number begin) {
    std::mt19937_64 random(1);
    for (long k = 0; k < 65536; ++k) {
        // All numbers of 8 and 16 bits; for wider formats, numbers near the table and random ones.
        const Number x =
            sizeof(Number) <= 2
                ? Number::from_raw(static_cast<typename Number::Raw>(k))
                : (k % 2 == 0 ? begin + exact::random_number<Number>(random, 20)
                              : Number::from_raw(static_cast<typename Number::Raw>(random())));
        ASSERT_EQ(interpolate<StepExponent>(table, begin, x).raw(),
                  (interpolated<StepExponent>(table, begin, x)))
            << x.raw();
    }
}
template <class Number>
Table<Number, 9> wavy() {
    Table<Number, 9> table;
    const int quarters[9] = {-20, 3, 7, -9, 0, 11, -1, 2, 8};
    for (int i = 0; i < 9; ++i)
        table.entry[i] = Number::from_raw(
            static_cast<typename Number::Raw>((Exact(quarters[i]) << Number::fraction_bits) / 4));
    return table;
}
template <class Number>
void is_exact_with_every_step() {
    is_exact<-2>(wavy<Number>(), Number::from_integer(-1));
    is_exact<0>(wavy<Number>(), Number::min());
    is_exact<-3>(wavy<Number>(), Number::max() - Number::from_raw(Number::max().raw() / 16));
}
TEST(Interpolation, IsRoundedOnce) {
    is_exact<-2>(wavy<Q4_4>(), Q4_4::from_integer(-1));
    is_exact<-4>(wavy<Q4_4>(), Q4_4::min());
    is_exact_with_every_step<Q8_8>();
    is_exact<3>(wavy<Q8_8>(), Q8_8::from_integer(-64));
    is_exact_with_every_step<Q16_16>();
    is_exact<11>(wavy<Q16_16>(), Q16_16::min());
    is_exact_with_every_step<Fixed<8, 24>>();
    is_exact_with_every_step<Q32_32>();
    is_exact_with_every_step<Fixed<16, 16, Saturating>>();
}
TEST(Interpolation, KeepsTheEndsOfATableOfOneEntry) {
    const Table<Q8_8, 1> table = {{Q8_8::from_integer(3)}};
    EXPECT_EQ(interpolate<0>(table, Q8_8(), Q8_8::max()).raw(), 768);
    EXPECT_EQ(interpolate<0>(table, Q8_8(), Q8_8::min()).raw(), 768);
}
TEST(Interpolation, IsLinearInDouble) {
    const Table<double, 3> table = {{1, 2, 4}};
    EXPECT_EQ(interpolate<1>(table, -1.0, 2.0), 3);
    EXPECT_EQ(interpolate<-1>(table, 0.0, 0.25), 1.5);
    EXPECT_EQ(interpolate<-1>(table, 0.0, 9.0), 4);
    EXPECT_EQ(interpolate<-1>(table, 0.0, -9.0), 1);
}

}  // namespace
