// SPDX-License-Identifier: MIT
// Square roots, lengths, unit vectors and roundings to an integer against exact arithmetic, and the
// reciprocal square roots that are rounded to nearest.
#include <algorithm>
#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/portable/reciprocal_sqrt.hpp>
#include <fixedpoint/portable/round.hpp>

#include "subjects.hpp"

namespace {

using namespace fixedpoint;

std::string name(exact::Format format) {
    return std::to_string(format.width) + " bits, F = " + std::to_string(format.fraction);
}

// Operands, including those whose exact result is close to a tie: (r + 1/2)^2 / 2^F.
std::vector<int64_t> radicands(exact::Format format) {
    std::vector<int64_t> numbers = exact::raws(format.width);
    std::mt19937_64 random(16);
    const int root_bits = (format.width + format.fraction) / 2;
    for (int i = 0; i < 5000; ++i) {
        const __int128 root = static_cast<__int128>(random() >> (64 - root_bits)) >> random() % 8;
        const auto half = static_cast<int64_t>((root * root + root) >> format.fraction);
        for (const int64_t a : {half, half + 1}) {
            if (a <= exact::largest(format.width)) numbers.push_back(a);
        }
    }
    return numbers;
}

TEST(Sqrt, RoundsToNearest) {
    for (const Subject& subject : subjects([]<class Raw, int F>(const int64_t* v) -> int64_t {
             const Raw root = kernel::sqrt<Raw, F>(Raw(*v));
             return kernel::sqrt_small<Raw, F>(Raw(*v)) == root ? int64_t(root) : -1;
         })) {
        SCOPED_TRACE(name(subject.format));
        for (const int64_t a : radicands(subject.format)) {
            // r is the root if (r - 1/2)^2 < a 2^F < (r + 1/2)^2.
            const __int128 root = subject.compute(&a);
            if (a <= 0) {
                ASSERT_EQ(int64_t(root), 0) << a;
                continue;
            }
            const __int128 n = static_cast<__int128>(a) << subject.format.fraction;
            ASSERT_GE(int64_t(root), 0) << a;
            ASSERT_TRUE(n > root * root - root) << a << " " << int64_t(root);
            ASSERT_TRUE(n <= root * root + root) << a << " " << int64_t(root);
        }
    }
}

TEST(ReciprocalSqrt, RoundsToNearest) {
    for (const Subject& subject : subjects([]<class Raw, int F>(const int64_t* v) -> int64_t {
             return portable::nearest_reciprocal_sqrt<Raw, F>(Raw(*v));
         })) {
        SCOPED_TRACE(name(subject.format));
        for (const int64_t a : exact::raws(subject.format.width)) {
            const int64_t expected = a < 0    ? 0
                                     : a == 0 ? exact::largest(subject.format.width)
                                              : exact::reciprocal_sqrt(a, subject.format).saturated;
            ASSERT_EQ(subject.compute(&a), expected) << a;
        }
    }
}

std::vector<std::array<int64_t, 3>> vectors(int width) {
    std::vector<std::array<int64_t, 3>> all;
    std::mt19937_64 random(9);
    for (int i = 0; i < 3000; i += exact::operand_step) {
        std::array<int64_t, 3> v;
        const auto shift = 64 - width + random() % width;
        for (int64_t& component : v) {
            component =
                static_cast<int64_t>(random()) >> std::min<uint64_t>(63, shift + random() % 3);
        }
        if (i % 3 == 0) v[random() % 3] >>= random() % width;
        all.push_back(v);
    }
    const int64_t least = exact::smallest(width), most = exact::largest(width);
    const std::vector<int64_t> edges = {least, least + 1, least / 2, -1, 0, 1, most / 2, most};
    for (const int64_t x : edges) {
        for (const int64_t y : edges) {
            for (const int64_t z : edges) all.push_back({x, y, z});
        }
    }
    // One long component and short ones: a unit vector near an axis.
    for (int64_t short_one = 0; short_one < 40; ++short_one) {
        for (const int64_t x : {least, least + 1, most})
            all.push_back({short_one, x, -short_one / 2});
    }
    return all;
}

// Narrow formats of up to 13 fraction bits round the length of Q16.16 once more.
template <class Raw, int F>
int64_t checked_length(Raw nearest, Raw dispatched) {
    const bool twice = sizeof(Raw) <= 2 && F <= 13;
    return dispatched == nearest || (twice && std::abs(dispatched - nearest) == 1)
               ? int64_t{nearest}
               : -1;
}

TEST(Length, RoundsToNearestSaturated) {
    const auto lengths2 = subjects([]<class Raw, int F>(const int64_t* v) -> int64_t {
        const Raw raw[2] = {Raw(v[0]), Raw(v[1])};
        return checked_length<Raw, F>(portable::length2<Raw, F>(raw), kernel::length2<Raw, F>(raw));
    });
    const auto lengths3 = subjects([]<class Raw, int F>(const int64_t* v) -> int64_t {
        const Raw raw[3] = {Raw(v[0]), Raw(v[1]), Raw(v[2])};
        return checked_length<Raw, F>(portable::length3<Raw, F>(raw), kernel::length3<Raw, F>(raw));
    });
    for (std::size_t i = 0; i < lengths2.size(); ++i) {
        const exact::Format format = lengths2[i].format;
        SCOPED_TRACE(name(format));
        for (const auto& v : vectors(format.width)) {
            ASSERT_EQ(lengths2[i].compute(v.data()), exact::length(v.data(), 2, format).saturated)
                << v[0] << " " << v[1];
            ASSERT_EQ(lengths3[i].compute(v.data()), exact::length(v.data(), 3, format).saturated)
                << v[0] << " " << v[1] << " " << v[2];
        }
    }
}

// The component that is in v[3].
template <class Raw, int F>
int64_t component(const int64_t* v) {
    Raw raw[3] = {Raw(v[0]), Raw(v[1]), Raw(v[2])};
    kernel::normalise3<Raw, F>(raw, raw);
    return raw[v[3]];
}

TEST(Normalise, RoundsToNearestOrStaysWithinItsBound) {
    for (const Subject& subject : subjects(
             []<class Raw, int F>(const int64_t* v) -> int64_t { return component<Raw, F>(v); })) {
        // Those of 24 bits go through 32 bits, Q16.16 if it holds them with three bits more.
        const int F = subject.format.fraction;
        const bool through_q16_16 =
            subject.format.width < 24 ? F <= 13 : subject.format.width == 24 && F >= 8 && F <= 13;
        const int width = subject.format.width == 24 ? 32 : subject.format.width;
        SCOPED_TRACE(name(subject.format));
        const bool is_nearest = width >= 32 ? F > width - 5 : F > 13;
        const bool is_q8_8 = width == 16 && F == 8;
        // 0.9 ulp of Q16.16 in addition to half an ulp of a narrow format.
        const double bound = is_nearest               ? 0.5
                             : is_q8_8                ? 0.75
                             : through_q16_16         ? 0.5 + std::ldexp(0.9, F - 16)
                             : width == 32 && F == 16 ? 0.9
                             : width == 32            ? 0.5 + std::ldexp(6.5, F - 31)
                             : F == 32                ? 0.6
                                                      : 0.97;
        for (const auto& v : vectors(subject.format.width)) {
            for (int i = 0; i < 3; ++i) {
                const int64_t operands[4] = {v[0], v[1], v[2], i};
                const int64_t result = subject.compute(operands);
                if (v[0] == 0 && v[1] == 0 && v[2] == 0) {
                    ASSERT_EQ(result, 0);
                } else if (is_nearest) {
                    ASSERT_EQ(result, exact::normalised(v.data(), i, subject.format).saturated)
                        << v[0] << " " << v[1] << " " << v[2] << ", component " << i;
                } else {
                    ASSERT_LE(exact::normalise_error(v.data(), i, result, subject.format), bound)
                        << v[0] << " " << v[1] << " " << v[2] << ", component " << i;
                }
            }
        }
    }
}

// A format that can represent -1 but not 1.
TEST(Normalise, HoldsMinusOneWithOneIntegerBit) {
    for (const Subject& subject : subjects(
             []<class Raw, int F>(const int64_t* v) -> int64_t { return component<Raw, F>(v); })) {
        if (subject.format.fraction != subject.format.width - 1) continue;
        const int64_t least = exact::smallest(subject.format.width);
        const int64_t most = exact::largest(subject.format.width);
        for (const int64_t x : {least, -most, int64_t(-1)}) {
            const int64_t down[4] = {0, x, 0, 1}, up[4] = {0, x == least ? most : -x, 0, 1};
            EXPECT_EQ(subject.compute(down), least) << x;
            if (x != least) {
                EXPECT_EQ(subject.compute(up), most) << x;
            }
        }
    }
}

struct Roundings {
    exact::Format format;
    void (*compute)(int64_t a, int64_t* results);
};
template <class Raw, int F>
constexpr Roundings roundings = {{RawLimits<Raw>::width, F}, [](int64_t n, int64_t* results) {
                                     using namespace portable;
                                     const Raw a = Raw(n);
                                     const int64_t all[] = {
                                         integer_floor<Raw, F>(a), integer_ceil<Raw, F>(a),
                                         integer_round<Raw, F>(a), fraction<Raw, F>(a),
                                         floor<Raw, F>(a),         ceil<Raw, F>(a),
                                         round<Raw, F>(a),         trunc<Raw, F>(a)};
                                     std::copy(std::begin(all), std::end(all), results);
                                 }};

TEST(Rounding, IsThatOfTheExactNumber) {
    for (const Roundings& subject :
         {roundings<int8_t, 0>, roundings<int8_t, 1>, roundings<int8_t, 4>, roundings<int8_t, 7>,
          roundings<int16_t, 0>, roundings<int16_t, 8>, roundings<int16_t, 15>, roundings<Int24, 0>,
          roundings<Int24, 12>, roundings<Int24, 23>, roundings<int32_t, 0>, roundings<int32_t, 16>,
          roundings<int32_t, 31>, roundings<int64_t, 0>, roundings<int64_t, 32>,
          roundings<int64_t, 63>}) {
        const auto [width, F] = subject.format;
        SCOPED_TRACE(name(subject.format));
        for (const int64_t a : exact::raws(width)) {
            const __int128 one = static_cast<__int128>(1) << F;
            const __int128 below = a >> F, above = -(-static_cast<__int128>(a) >> F);
            const __int128 nearest = (2 * static_cast<__int128>(a) + one) >> (F + 1);
            const auto saturated = [&](__int128 n) {
                return static_cast<int64_t>(std::min<__int128>(n * one, exact::largest(width)));
            };
            const int64_t expected[] = {int64_t(below),       int64_t(above),
                                        int64_t(nearest),     int64_t(a - below * one),
                                        int64_t(below * one), saturated(above),
                                        saturated(nearest),   saturated(a < 0 ? above : below)};
            int64_t results[8];
            subject.compute(a, results);
            for (int i = 0; i < 8; ++i) ASSERT_EQ(results[i], expected[i]) << a << ", " << i;
        }
    }
}

static_assert(portable::ceil<int16_t, 8>(0x7f01) == 0x7fff, "128 is beyond Q8.8");
static_assert(portable::round<int16_t, 8>(-0x180) == -0x100, "-1.5 is rounded up");
static_assert(kernel::sqrt<int32_t, 16>(2 * 65536) == 92682, "sqrt(2)");
static_assert(kernel::sqrt<int32_t, 16>(-1) == 0, "below zero");
constexpr int32_t pythagorean[] = {-3 * 65536, 4 * 65536, 12 * 65536};
static_assert(portable::length2<int32_t, 16>(pythagorean) == 5 * 65536, "3, 4, 5");
static_assert(portable::length3<int32_t, 16>(pythagorean) == 13 * 65536, "3, 4, 12, 13");

}  // namespace
