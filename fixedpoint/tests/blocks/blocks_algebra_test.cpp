// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <fixedpoint/blocks/complex.hpp>
#include <fixedpoint/blocks/matrix.hpp>
#include <fixedpoint/blocks/quaternion.hpp>

#include "../exact.hpp"
#include "exact_sum.hpp"

using namespace fixedpoint;
using exact::Exact;
using exact::product;
using exact::random_number;
using exact::ulp;
using exact::value;

namespace {

template <class Number>
class Algebra : public testing::Test {};
using Numbers = testing::Types<Q4_4, Q8_8, Q16_16, Fixed<8, 24>, Fixed<3, 29>>;
TYPED_TEST_SUITE(Algebra, Numbers);

// A sum of products, rounded once, modulo 2^W.
template <class Number>
typename Number::Raw ring(Exact sum) {
    return static_cast<typename Number::Raw>(exact::rounded(sum, Number::fraction_bits));
}
template <class Number>
Number any(std::mt19937_64& random) {
    const Number x = Number::from_raw(static_cast<typename Number::Raw>(random()));
    return x == Number::min() ? Number::max() : x;
}

TYPED_TEST(Algebra, ComplexProductsRoundOnce) {
    using Number = TypeParam;
    std::mt19937_64 random(1);
    for (int i = 0; i < 100000; ++i) {
        const Complex<Number> a{{any<Number>(random), any<Number>(random)}};
        const Complex<Number> b{{any<Number>(random), any<Number>(random)}};
        const Complex<Number> c = a * b;
        ASSERT_EQ(c.real().raw(),
                  ring<Number>(product(a.part[0], b.part[0]) - product(a.part[1], b.part[1])));
        ASSERT_EQ(c.imaginary().raw(),
                  ring<Number>(product(a.part[0], b.part[1]) + product(a.part[1], b.part[0])));
        ASSERT_EQ(squared_magnitude(a).raw(),
                  ring<Number>(product(a.part[0], a.part[0]) + product(a.part[1], a.part[1])));
        ASSERT_EQ((a + conjugate(a)).imaginary().raw(), 0);
        ASSERT_EQ((a - conjugate(a)).real().raw(), 0);
    }
}

// By the definition of the kernel: -INT32_MIN is out of range, but its products need not be.
TEST(Complex, ProductsInThirtyTwoBitsAreExactBesideTheSmallestNumber) {
    const Complex<Q16_16> a{{Q16_16::from_raw(3 << 15), Q16_16::from_raw(5 << 14)}};
    const Complex<Q16_16> b{{Q16_16::from_raw(1), Q16_16::min()}};
    EXPECT_EQ((a * b).real().raw(),
              ring<Q16_16>(product(a.part[0], b.part[0]) - product(a.part[1], b.part[1])));
}

template <class Number, uint8_t N>
Matrix<Number, N> random_matrix(std::mt19937_64& random, long double limit) {
    Matrix<Number, N> a;
    for (auto& row : a.element)
        for (auto& x : row) x = random_number<Number>(random, limit);
    return a;
}
template <class Number, uint8_t N>
void products_round_once() {
    std::mt19937_64 random(2);
    for (int k = 0; k < 5000; ++k) {
        const auto a = random_matrix<Number, N>(random, 1e9),
                   b = random_matrix<Number, N>(random, 1e9);
        const auto c = a * b;
        Number v[N], image[N];
        for (int i = 0; i < N; ++i) v[i] = b.element[i][0];
        multiply(a, v, image);
        for (int i = 0; i < N; ++i) {
            for (int j = 0; j < N; ++j) {
                Exact sum = 0;
                for (int l = 0; l < N; ++l) sum += product(a.element[i][l], b.element[l][j]);
                ASSERT_EQ(c.element[i][j].raw(), ring<Number>(sum));
            }
            ASSERT_EQ(image[i].raw(), c.element[i][0].raw());
        }
    }
}
TYPED_TEST(Algebra, MatrixProductsRoundOnce) {
    products_round_once<TypeParam, 2>();
    products_round_once<TypeParam, 3>();
}

// Cramer's rule in long double; the sign of cofactor (i, j) depends on its position.
template <class Number>
long double exact_determinant(const Matrix<Number, 2>& a) {
    return value(a.element[0][0]) * value(a.element[1][1]) -
           value(a.element[0][1]) * value(a.element[1][0]);
}
template <class Number>
long double exact_cofactor(const Matrix<Number, 3>& a, int i, int j) {
    Matrix<Number, 2> minor;
    for (int p = 0, r = 0; p < 3; ++p) {
        if (p == i) continue;
        for (int q = 0, s = 0; q < 3; ++q)
            if (q != j) minor.element[r][s++] = a.element[p][q];
        ++r;
    }
    return ((i + j) % 2 == 0 ? 1 : -1) * exact_determinant(minor);
}
template <class Number>
long double exact_cofactor(const Matrix<Number, 2>& a, int i, int j) {
    return ((i + j) % 2 == 0 ? 1 : -1) * value(a.element[1 - i][1 - j]);
}
template <class Number>
long double exact_determinant(const Matrix<Number, 3>& a) {
    long double sum = 0;
    for (int j = 0; j < 3; ++j) sum += value(a.element[0][j]) * exact_cofactor(a, 0, j);
    return sum;
}

template <class Number, uint8_t N>
void has_determinant_and_inverse(long double limit, long double diagonal) {
    std::mt19937_64 random(3);
    const long double m = limit + diagonal, e = ulp<Number>();
    for (int k = 0; k < 5000; ++k) {
        auto a = random_matrix<Number, N>(random, limit);
        for (int i = 0; i < N; ++i)
            a.element[i][i] = Number::from_raw(static_cast<typename Number::Raw>(
                a.element[i][i].raw() + std::ldexp(diagonal, Number::fraction_bits)));
        const long double d = exact_determinant(a), d_error = N == 2 ? e / 2 : (1 + 3 * m) / 2 * e;
        ASSERT_LE(std::abs(value(determinant(a)) - d), d_error);
        Matrix<Number, N> inverse;
        ASSERT_TRUE(invert(a, inverse));
        const long double least = std::abs(d) - d_error;
        for (int i = 0; i < N; ++i) {
            for (int j = 0; j < N; ++j) {
                const long double c = exact_cofactor(a, j, i);
                const long double bound =
                    e / 2 + (e / 2) / least + std::abs(c) / (std::abs(d) * least) * d_error;
                ASSERT_LE(std::abs(value(inverse.element[i][j]) - c / d), bound * (1 + 1e-9L));
            }
        }
        auto in_place = a;
        ASSERT_TRUE(invert(in_place, in_place));
        ASSERT_EQ(in_place.element[N - 1][0].raw(), inverse.element[N - 1][0].raw());
    }
}
TYPED_TEST(Algebra, MatricesHaveDeterminantAndInverse) {
    has_determinant_and_inverse<TypeParam, 2>(0.25, 1.25);
    has_determinant_and_inverse<TypeParam, 3>(0.25, 1.25);
}
TYPED_TEST(Algebra, SingularMatricesHaveNoInverse) {
    using Number = TypeParam;
    const Number one = BlockNumber<Number>::one();
    const Matrix<Number, 2> a = {{{one, one}, {one, one}}};
    const Matrix<Number, 3> b = {{{one, one, one}, {one, one, one}, {one, Number(), one}}};
    Matrix<Number, 2> untouched_2 = {{{one, one}, {one, Number()}}};
    Matrix<Number, 3> untouched_3 = {};
    EXPECT_FALSE(invert(a, untouched_2));
    EXPECT_FALSE(invert(b, untouched_3));
    EXPECT_EQ(untouched_2.element[0][0].raw(), one.raw());
    EXPECT_EQ(untouched_3.element[0][0].raw(), 0);
}

template <class Number>
Quaternion<Number> random_rotation(std::mt19937_64& random) {
    std::normal_distribution<long double> normal;
    long double part[4], square = 0;
    for (auto& p : part) p = normal(random), square += p * p;
    Quaternion<Number> q;
    for (int i = 0; i < 4; ++i)
        q.part[i] = Number::from_raw(static_cast<typename Number::Raw>(
            std::nearbyint(std::ldexp(part[i] / std::sqrt(square), Number::fraction_bits))));
    return q;
}
template <class Number>
long double length_of(const Quaternion<Number>& q) {
    long double square = 0;
    for (const Number p : q.part) square += value(p) * value(p);
    return std::sqrt(square);
}

TYPED_TEST(Algebra, QuaternionProductsAreWithinAnUlp) {
    using Number = TypeParam;
    std::mt19937_64 random(4);
    for (int k = 0; k < 50000; ++k) {
        const auto a = random_rotation<Number>(random), b = random_rotation<Number>(random);
        long double p[4], q[4];
        for (int i = 0; i < 4; ++i) p[i] = value(a.part[i]), q[i] = value(b.part[i]);
        const long double exact[4] = {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
                                      p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
                                      p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
                                      p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
        const auto c = a * b;
        for (int i = 0; i < 4; ++i)
            ASSERT_LE(std::abs(value(c.part[i]) - exact[i]),
                      ulp<Number>() * (sizeof(Number) == 4 ? 0.5L : 1) * (1 + 1e-6L));
    }
}
// A million products with small and large rotations.
TYPED_TEST(Algebra, QuaternionsStayNormalised) {
    using Number = TypeParam;
    std::mt19937_64 random(5);
    Quaternion<Number> turns[64], q = random_rotation<Number>(random);
    for (auto& turn : turns) turn = random_rotation<Number>(random);
    long double worst = 0;
    for (int k = 0; k < 1000000; k += exact::operand_step) {
        q = renormalised(turns[(k / 7) % 64] * q);
        if (k % 10 == 0 || k > 990000) worst = std::max(worst, std::abs(length_of(q) - 1));
    }
    EXPECT_LE(worst, 2 * ulp<Number>());
}
// Newton's method: the error of the length is squared.
TYPED_TEST(Algebra, RenormalisingSquaresTheErrorOfTheLength) {
    using Number = TypeParam;
    std::mt19937_64 random(6);
    for (int k = 0; k < 20000; ++k) {
        auto q = random_rotation<Number>(random);
        for (Number& p : q.part)
            p = Number::from_raw(static_cast<typename Number::Raw>(p.raw() - p.raw() / 16));
        const long double d = length_of(q) - 1;
        ASSERT_NEAR(static_cast<double>(length_of(renormalised(q))),
                    static_cast<double>(1 - 1.5L * d * d - d * d * d / 2),
                    static_cast<double>(3 * ulp<Number>()));
    }
}
TYPED_TEST(Algebra, RotatesVectors) {
    using Number = TypeParam;
    std::mt19937_64 random(7);
    for (int k = 0; k < 50000; ++k) {
        const auto q = random_rotation<Number>(random);
        const long double limit =
            std::min<long double>(8, std::ldexp(1.0L, Number::integer_bits - 1) / 8);
        Number v[3], image[3];
        for (Number& x : v) x = random_number<Number>(random, limit);
        rotate(q, v, image);
        // v + 2 w (u x v) + 2 u x (u x v), exact.
        long double w = value(q.part[0]), u[3], x[3], cross[3];
        for (int i = 0; i < 3; ++i) u[i] = value(q.part[i + 1]), x[i] = value(v[i]);
        for (int i = 0; i < 3; ++i)
            cross[i] = u[(i + 1) % 3] * x[(i + 2) % 3] - u[(i + 2) % 3] * x[(i + 1) % 3];
        for (int i = 0; i < 3; ++i) {
            const long double exact =
                x[i] + 2 * (w * cross[i] + u[(i + 1) % 3] * cross[(i + 2) % 3] -
                            u[(i + 2) % 3] * cross[(i + 1) % 3]);
            ASSERT_LE(std::abs(value(image[i]) - exact),
                      (sizeof(Number) == 4 ? 1.4L : 2.3L) * ulp<Number>());
        }
        rotate(q, v, v);
        ASSERT_EQ(v[1].raw(), image[1].raw());
    }
}

}  // namespace
