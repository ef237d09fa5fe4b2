// SPDX-License-Identifier: MIT
// Overlaps of spheres and their directions, compared with long double's root and quotient.
#include <gtest/gtest.h>

#include <cmath>
#include <engine/overlap.hpp>
#include <random>

using engine::Fixed;
using engine::SaturatingFixed;

namespace {

using Real = long double;

template <class Number, int N>
using Vector = engine::Vector<Number, N>;
template <class Number>
using LastReach = engine::LastReach<Number, true>;

template <int I, int F, class A>
Real value(Fixed<I, F, A> x) {
    return std::ldexp(static_cast<Real>(x.raw()), -F);
}

template <class Number, int N>
struct Found {
    Vector<Number, N> direction;
    Number depth;
};
template <class Number, int N>
Found<Number, N> overlap(const Vector<Number, N>& a, const Vector<Number, N>& b, Number reach,
                         LastReach<Number>& last) {
    Found<Number, N> found;
    found.direction = a - b;
    found.depth = engine::overlap(a, b, reach, last, found.direction);
    return found;
}

// Pairs whose differences along the axes are below the sum of the radii: from deep inside each
// other, where most fast particles are found, to corners where they are apart. The bounds are those
// of distance.hpp; in either arithmetic those of the plain format.
template <class Number, int N>
void expect_right(double least, double most) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponent(least, most), share(-1, 1);
    LastReach<Number> last;
    int apart = 0, deep = 0, light = 0;
    Number reach;
    for (int i = 0; i < 200'000; ++i) {
        if (i % 8 == 0) {
            const double length = std::exp2(exponent(random));
            reach = Number::from_raw(std::lround(std::ldexp(length, 16)));
        }
        const auto limit = static_cast<double>(reach.raw());
        double v[3], square = 0;
        for (int k = 0; k < N; ++k) {
            v[k] = share(random);
            square += v[k] * v[k];
        }
        const double near = i % 2 == 0 ? 1 : (1 + share(random) / 50) / std::sqrt(square);
        Vector<Number, N> a, b;
        Real distance = 0;
        bool in_the_box = true;
        for (unsigned char k = 0; k < N; ++k) {
            const auto raw = std::lround(v[k] * near * limit);
            in_the_box = in_the_box && std::labs(raw) < reach.raw();
            const auto middle = static_cast<int32_t>(random() % (1 << 24)) - (1 << 23);
            b[k] = Number::from_raw(static_cast<int32_t>(middle - raw / 2));
            a[k] = Number::from_raw(static_cast<int32_t>(b[k].raw() + raw));
            distance = std::hypot(distance, std::ldexp(static_cast<Real>(raw), -16));
        }
        if (!in_the_box) continue;
        const auto found = overlap(a, b, reach, last);
        const Real depth = value(reach) - distance;
        const Real far = Real(3.25) * distance + N / Real(2),
                   near_by = 3 * value(reach) + Real(0.5);
        const Real bound = value(reach) < 2 ? std::max(far, near_by) : far;
        if (!(found.depth > Number())) {
            ASSERT_LE(std::ldexp(depth, 16), bound) << "reach " << value(reach);
            ++apart;
            continue;
        }
        ASSERT_LE(std::ldexp(std::abs(value(found.depth) - depth), 16), bound) << value(reach);
        for (unsigned char k = 0; k < N; ++k) {
            const Real component = distance == 0 ? k == 0 : value(a[k] - b[k]) / distance;
            ASSERT_LE(std::ldexp(std::abs(value(found.direction[k]) - component), 16), 10.75);
        }
        ++(depth > value(reach) / 100 ? deep : light);
    }
    EXPECT_GT(apart, 10'000);
    EXPECT_GT(deep, 10'000);
    EXPECT_GT(light, 10'000);
}
TEST(Overlap, IsRight) {
    expect_right<Fixed<16, 16>, 2>(-14, 14.9);
    expect_right<Fixed<16, 16>, 3>(-14, 14.9);
    expect_right<SaturatingFixed<16, 16>, 2>(-14, 14.9);
    expect_right<SaturatingFixed<16, 16>, 3>(-14, 14.9);
}

// Spheres, the smallest of which have no 1 / reach in the format, in one place and one ulp apart.
template <class Number>
void expect_right_at_one_place() {
    LastReach<Number> last;
    for (const int32_t reach : {2, 3, 100, 1 << 14, 1 << 16, 3 << 20}) {
        const auto wide = Number::from_raw(reach);
        Vector<Number, 2> a, b;
        a[0] = b[0] = wide;
        auto found = overlap(a, b, wide, last);
        EXPECT_EQ(found.depth, wide);
        EXPECT_EQ(found.direction[0].raw(), 1 << 16);
        EXPECT_EQ(found.direction[1].raw(), 0);
        b[1] = Number::from_raw(1);
        found = overlap(a, b, wide, last);
        EXPECT_EQ(found.depth.raw(), reach - 1);
        EXPECT_NEAR(found.direction[0].raw(), 0, 10);
        EXPECT_NEAR(found.direction[1].raw(), -(1 << 16), 10);
    }
}
TEST(Overlap, IsRightAtOnePlace) {
    expect_right_at_one_place<Fixed<16, 16>>();
    expect_right_at_one_place<SaturatingFixed<16, 16>>();
}

// Up to 1 m, spheres that touch along an axis do not overlap, as in a cradle at rest.
TEST(Overlap, IsZeroWhereTheyTouch) {
    using Number = Fixed<16, 16>;
    LastReach<Number> last;
    for (int32_t raw = 1; raw <= 1 << 16; ++raw) {
        const auto reach = Number::from_raw(raw);
        const auto found = overlap<Number, 2>({reach, Number()}, {}, reach, last);
        ASSERT_LE(found.depth.raw(), 0) << raw;
    }
}

// Balls that lie on each other: a direction an ulp short would keep a stack from coming to rest.
TEST(Overlap, HasADirectionOfLengthOneWhereItIsLittle) {
    using Number = Fixed<16, 16>;
    LastReach<Number> last;
    const auto reach = Number::from_raw(1 << 15);
    for (int32_t depth = 1; depth <= 64; ++depth) {
        const auto distance = Number::from_raw(reach.raw() - depth);
        const auto found = overlap<Number, 2>({Number(), distance}, {}, reach, last);
        ASSERT_EQ(found.depth.raw(), depth);
        ASSERT_EQ(found.direction[0].raw(), 0) << depth;
        ASSERT_EQ(found.direction[1].raw(), 1 << 16) << depth;
    }
}

}  // namespace
