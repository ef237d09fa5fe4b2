// SPDX-License-Identifier: MIT
// length2 and length3 against the integer residual of their root: r is nearest to sqrt(n) where
// (r - 1/2)^2 < n < (r + 1/2)^2, n the exact sum of squares.
#include <gtest/gtest.h>

#include <array>
#include <fixedpoint/portable/length.hpp>
#include <limits>

#include "exact.hpp"

namespace {

template <class Raw, class Int>
void expect_nearest(Raw length, const Int& squares) {
    const Int twice = 2 * Int(length);
    ASSERT_GE(length, 0);
    if (length > 0) {
        ASSERT_GT(4 * squares, (twice - 1) * (twice - 1));
    }
    if (length < std::numeric_limits<Raw>::max()) {
        ASSERT_LT(4 * squares, (twice + 1) * (twice + 1));
    }
}

template <class Raw, class Int>
void expect_lengths(const std::array<Raw, 3>& v) {
    constexpr int F = 4 * sizeof(Raw);
    SCOPED_TRACE(testing::Message() << +v[0] << " " << +v[1] << " " << +v[2]);
    const Int two = Int(v[0]) * v[0] + Int(v[1]) * v[1];
    expect_nearest<Raw, Int>(fixedpoint::portable::length2<Raw, F>(v.data()), two);
    expect_nearest<Raw, Int>(fixedpoint::portable::length3<Raw, F>(v.data()),
                             two + Int(v[2]) * v[2]);
}

template <class Raw, class Int>
void expect_lengths_of_samples(int count) {
    std::mt19937_64 random(3);
    constexpr int width = 8 * sizeof(Raw);
    for (int i = 0; i < count; ++i) {
        std::array<Raw, 3> v;
        for (Raw& component : v)
            component = static_cast<Raw>(static_cast<Raw>(random()) >> random() % width);
        expect_lengths<Raw, Int>(v);
    }
    const Raw least = std::numeric_limits<Raw>::min(), most = std::numeric_limits<Raw>::max();
    const std::vector<Raw> edges = {least, Raw(least + 1), Raw(-1), 0, 1, Raw(most / 2), most};
    for (const Raw x : edges) {
        for (const Raw y : edges) {
            for (const Raw z : edges) expect_lengths<Raw, Int>({x, y, z});
        }
    }
}

TEST(Length, RoundsToNearest8) {
    for (int x = -128; x < 128; ++x) {
        for (int y = -128; y < 128; ++y) {
            for (const int z : {-128, -7, 0, 1, 90, 127}) {
                expect_lengths<int8_t, int32_t>({int8_t(x), int8_t(y), int8_t(z)});
            }
        }
    }
}
TEST(Length, RoundsToNearest16) { expect_lengths_of_samples<int16_t, int64_t>(200000); }
TEST(Length, RoundsToNearest32) { expect_lengths_of_samples<int32_t, __int128>(200000); }
TEST(Length, RoundsToNearest64) { expect_lengths_of_samples<int64_t, exact::Int>(20000); }

TEST(Length, IsExactForPythagoreanTriples) {
    constexpr int32_t v[] = {-3 * 65536, 4 * 65536, 12 * 65536};
    static_assert(fixedpoint::portable::length2<int32_t, 16>(v) == 5 * 65536, "3, 4, 5");
    static_assert(fixedpoint::portable::length3<int32_t, 16>(v) == 13 * 65536, "3, 4, 12, 13");
}

}  // namespace
