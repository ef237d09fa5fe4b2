// SPDX-License-Identifier: MIT
// normalise3 against exact arithmetic: u is within e ulp of a 2^F / length where
// (|u| - e)^2 n <= a^2 2^(2F) <= (|u| + e)^2 n, n the exact sum of squares. Rounding to nearest is
// e = 1/2.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fixedpoint/portable/normalise.hpp>
#include <limits>

#include "exact.hpp"

namespace {

template <class Raw>
using Vector = std::array<Raw, 3>;

// Hundredths of an ulp that a component of a format may be off.
template <class Raw, int F>
constexpr int allowed = fixedpoint::portable::normalises_by_length<Raw, F>() ? 97 : 50;

template <class Raw, int F, class Int>
void expect_within_bound(const Vector<Raw>& v) {
    SCOPED_TRACE(testing::Message() << +v[0] << " " << +v[1] << " " << +v[2]);
    Vector<Raw> unit;
    fixedpoint::portable::normalise3<Raw, F>(v.data(), unit.data());
    const Int n = Int(v[0]) * v[0] + Int(v[1]) * v[1] + Int(v[2]) * v[2];
    for (int i = 0; i < 3; ++i) {
        const Int u = unit[i] < 0 ? -Int(unit[i]) : Int(unit[i]);
        const Int target = (Int(v[i]) * v[i] * 10000) << (2 * F);
        ASSERT_TRUE(unit[i] == 0 || (unit[i] < 0) == (v[i] < 0));
        const Int below = 100 * u - allowed<Raw, F>, above = 100 * u + allowed<Raw, F>;
        if (u > 0) {
            ASSERT_LE(below * below * n, target);
        }
        if (u < Int(std::numeric_limits<Raw>::max())) {
            ASSERT_GE(above * above * n, target);
        }
    }
}

template <class Raw>
Vector<Raw> random_vector(std::mt19937_64& random) {
    Vector<Raw> v;
    const int shift = static_cast<int>(random() % (8 * sizeof(Raw)));
    for (Raw& component : v) {
        component = static_cast<Raw>(static_cast<Raw>(random()) >> shift >> random() % 3);
    }
    return v;
}

template <class Raw, int F, class Int>
void expect_bound_of_samples(int count) {
    std::mt19937_64 random(9);
    for (int i = 0; i < count; ++i) expect_within_bound<Raw, F, Int>(random_vector<Raw>(random));
    const Raw least = std::numeric_limits<Raw>::min(), most = std::numeric_limits<Raw>::max();
    for (const Raw x : {least, Raw(-1), Raw(0), Raw(1), most}) {
        for (const Raw y : {least, Raw(-1), Raw(0), Raw(1), most}) {
            for (const Raw z : {least, Raw(0), most}) expect_within_bound<Raw, F, Int>({x, y, z});
        }
    }
}

TEST(Normalise, RoundsToNearest8) {
    for (int x = -128; x < 128; ++x) {
        for (int y = -128; y < 128; ++y) {
            for (const int z : {-128, 0, 33}) {
                expect_within_bound<int8_t, 4, int64_t>({int8_t(x), int8_t(y), int8_t(z)});
                expect_within_bound<int8_t, 7, int64_t>({int8_t(x), int8_t(y), int8_t(z)});
            }
        }
    }
}
TEST(Normalise, RoundsToNearest16) {
    expect_bound_of_samples<int16_t, 8, __int128>(50000);
    expect_bound_of_samples<int16_t, 15, __int128>(50000);
}
TEST(Normalise, RoundsToNearestOrDividesByTheLength32) {
    expect_bound_of_samples<int32_t, 0, exact::Int>(5000);
    expect_bound_of_samples<int32_t, 10, exact::Int>(5000);
    expect_bound_of_samples<int32_t, 24, exact::Int>(20000);
    expect_bound_of_samples<int32_t, 27, exact::Int>(20000);
    expect_bound_of_samples<int32_t, 28, exact::Int>(5000);
    expect_bound_of_samples<int32_t, 31, exact::Int>(5000);
}
TEST(Normalise, RoundsToNearestOrDividesByTheLength64) {
    expect_bound_of_samples<int64_t, 0, exact::Int>(2000);
    expect_bound_of_samples<int64_t, 32, exact::Int>(10000);
    expect_bound_of_samples<int64_t, 59, exact::Int>(10000);
    expect_bound_of_samples<int64_t, 60, exact::Int>(2000);
    expect_bound_of_samples<int64_t, 63, exact::Int>(2000);
}

TEST(NormaliseQ16_16, StaysWithinItsBound) {
    std::mt19937_64 random(5);
    for (int i = 0; i < 500000; ++i) {
        const Vector<int32_t> v = random_vector<int32_t>(random);
        Vector<int32_t> unit;
        fixedpoint::portable::normalise3<int32_t, 16>(v.data(), unit.data());
        const long double x = v[0], y = v[1], z = v[2];
        const long double length = std::sqrt(x * x + y * y + z * z);
        for (int k = 0; k < 3 && length > 0; ++k) {
            ASSERT_LE(std::fabs(unit[k] - v[k] / length * 65536), 0.9L)
                << v[0] << " " << v[1] << " " << v[2];
        }
    }
}

TEST(NormaliseQ16_16, WorksInPlaceAndKeepsZero) {
    int32_t v[] = {3, 0, -4};
    fixedpoint::portable::normalise3<int32_t, 16>(v, v);
    EXPECT_NEAR(v[0], 0.6 * 65536, 0.9);
    EXPECT_EQ(v[1], 0);
    EXPECT_NEAR(v[2], -0.8 * 65536, 0.9);
    int32_t zero[] = {0, 0, 0};
    fixedpoint::portable::normalise3<int32_t, 16>(zero, zero);
    EXPECT_EQ(zero[0] | zero[1] | zero[2], 0);
}

}  // namespace
