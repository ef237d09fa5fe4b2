// SPDX-License-Identifier: MIT
// Vectors of fixed-point numbers, compared with exact integers.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <engine/vector.hpp>
#include <fixedpoint/arithmetic/checked.hpp>

using engine::Fixed;
using Number = Fixed<16, 16>;
using Wide = __int128;

namespace {

template <int N>
engine::Vector<Number, N> any_vector() {
    engine::Vector<Number, N> v;
    for (unsigned char i = 0; i < N; ++i) v[i] = Number::from_raw(*rc::gen::arbitrary<int32_t>());
    return v;
}
// Components below 64, so that no product overflows the format.
template <int N>
engine::Vector<Number, N> small_vector() {
    engine::Vector<Number, N> v;
    for (unsigned char i = 0; i < N; ++i)
        v[i] = Number::from_raw(*rc::gen::inRange<int32_t>(-64 << 16, 64 << 16));
    return v;
}

// floor(x / 2^16 + 1/2) modulo 2^32.
int32_t rounded(Wide x) { return static_cast<int32_t>((x + 32768) >> 16); }
Wide raw(Number x) { return x.raw(); }

template <int N>
void check_ring_operations() {
    const auto a = any_vector<N>(), b = any_vector<N>();
    const Number factor = any_vector<2>()[0];
    auto scaled = a;
    scaled.add_scaled(b, factor);
    Wide sum = 0;
    for (unsigned char i = 0; i < N; ++i) {
        sum += raw(a[i]) * raw(b[i]);
        RC_ASSERT((a + b)[i].raw() == static_cast<int32_t>(raw(a[i]) + raw(b[i])));
        RC_ASSERT((a - b)[i].raw() == static_cast<int32_t>(raw(a[i]) - raw(b[i])));
        RC_ASSERT((-a)[i].raw() == static_cast<int32_t>(-raw(a[i])));
        RC_ASSERT((a * factor)[i].raw() == rounded(raw(a[i]) * raw(factor)));
        RC_ASSERT(component_product(a, b)[i].raw() == rounded(raw(a[i]) * raw(b[i])));
        RC_ASSERT(scaled[i].raw() == rounded((raw(a[i]) << 16) + raw(b[i]) * raw(factor)));
    }
    RC_ASSERT(dot(a, b).raw() == rounded(sum));
    RC_ASSERT((a == b) == (a.component[0] == b.component[0] && a.component[1] == b.component[1] &&
                           a.component[N - 1] == b.component[N - 1]));
    RC_ASSERT(a == a && !(a != a));
}

template <int N>
void check_length() {
    const auto v = any_vector<N>();
    Wide sum = 0;
    for (unsigned char i = 0; i < N; ++i) sum += raw(v[i]) * raw(v[i]);
    const long double exact = std::min(sqrtl(static_cast<long double>(sum)), 2147483647.0L);
    RC_ASSERT(fabsl(length(v).raw() - exact) <= 1);
    const auto unit = normalise(v);
    const long double whole = length(v).raw();
    // The rounding of the quotient, and one ulp of the length in proportion.
    for (unsigned char i = 0; i < N && whole > 0; ++i)
        RC_ASSERT(fabsl(unit[i].raw() - 65536.0L * v[i].raw() / whole) <= 0.5L);
}

struct Ignored {
    static void notify(fixedpoint::Event, fixedpoint::Operation) {}
};

// Twice a quarter of an ulp is rounded once in every arithmetic that rounds sums.
template <class A>
int square_of_two_halves() {
    engine::Vector<fixedpoint::Fixed<16, 16, A>, 2> v;
    v[0] = v[1] = fixedpoint::Fixed<16, 16, A>::from_raw(128);
    return squared_length(v).raw();
}
TEST(Vector, SquaredLengthIsRoundedOnce) {
    EXPECT_EQ(square_of_two_halves<fixedpoint::Nearest>(), 1);
    EXPECT_EQ(square_of_two_halves<fixedpoint::Checked<Ignored>>(), 1);
}

}  // namespace

RC_GTEST_PROP(Vector, RingOperationsInTwoDimensionsAreExactAndRoundOnce, ()) {
    check_ring_operations<2>();
}
RC_GTEST_PROP(Vector, RingOperationsInThreeDimensionsAreExactAndRoundOnce, ()) {
    check_ring_operations<3>();
}
RC_GTEST_PROP(Vector, LengthInTwoDimensionsIsWithinOneUlp, ()) { check_length<2>(); }
RC_GTEST_PROP(Vector, LengthInThreeDimensionsIsWithinOneUlp, ()) { check_length<3>(); }

// Each component is a difference of two products, each rounded.
RC_GTEST_PROP(Vector, CrossIsWithinOneUlp, ()) {
    const auto a = small_vector<3>(), b = small_vector<3>();
    const auto product = cross(a, b);
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const Wide exact = raw(a[j]) * raw(b[k]) - raw(a[k]) * raw(b[j]);
        const Wide off = (raw(product[i]) << 16) - exact;
        RC_ASSERT(off <= 65536 && off >= -65536);
    }
    const engine::Vector<Number, 2> c(a[0], a[1]), d(b[0], b[1]);
    RC_ASSERT(cross(c, d) == product[2]);
}

TEST(Vector, ZeroHasNoDirection) {
    const engine::Vector<Number, 3> zero;
    EXPECT_EQ(normalise(zero), zero);
    EXPECT_EQ(length(zero), Number());
    EXPECT_EQ(divided(engine::Vector<double, 2>(1.0, 2.0), 0.0), (engine::Vector<double, 2>()));
}

TEST(Vector, OfDoubles) {
    const engine::Vector<double, 2> v(3.0, -4.0);
    EXPECT_EQ(length(v), 5);
    EXPECT_EQ(squared_length(v), 25);
    EXPECT_EQ(normalise(v), (engine::Vector<double, 2>(0.6, -0.8)));
}
