// SPDX-License-Identifier: MIT
// Products, sums of products, quotients and remainders against exact arithmetic: rounded once, then
// modulo 2^W, or saturated.
#include <algorithm>
#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/portable/divide_small.hpp>
#include <fixedpoint/portable/divide_widening.hpp>
#include <fixedpoint/portable/remainder.hpp>
#include <fixedpoint/portable/wide.hpp>

#include "subjects.hpp"

namespace {

using namespace fixedpoint;

// Calls expected(a, b, c, format), which returns what the subject must return.
template <class Expected>
void check(const std::vector<Subject>& subjects, Expected expected) {
    for (const Subject& subject : subjects) {
        SCOPED_TRACE(testing::Message()
                     << subject.format.width << " bits, F = " << subject.format.fraction);
        std::mt19937_64 random(8);
        const int unused = 64 - subject.format.width;
        for_each_pair(subject.format.width, [&](int64_t a, int64_t b) {
            const auto draw = [&] {
                return static_cast<int64_t>(random()) >> (unused + random() % subject.format.width);
            };
            const int64_t operands[4] = {a, b, draw(), draw()};
            ASSERT_EQ(subject.compute(operands), expected(operands, subject.format))
                << a << " " << b << " " << operands[2] << " " << operands[3];
        });
        if (testing::Test::HasFatalFailure()) return;
    }
}

TEST(Multiply, IsTheNearestNumberModuloTheRange) {
    check(subjects([]<class Raw, int F>(const int64_t* v) -> int64_t {
              return kernel::multiply<Raw, F>(Raw(v[0]), Raw(v[1]));
          }),
          [](const int64_t* v, exact::Format format) {
              return exact::multiply_add(v[0], v[1], 0, format).wrapped;
          });
}

TEST(MultiplySaturating, IsTheNearestNumber) {
    check(subjects([]<class Raw, int F>(const int64_t* v) -> int64_t {
              return kernel::multiply_saturating<Raw, F>(Raw(v[0]), Raw(v[1]));
          }),
          [](const int64_t* v, exact::Format format) {
              return exact::multiply_add(v[0], v[1], 0, format).saturated;
          });
}

TEST(MultiplyAdd, IsRoundedOnce) {
    check(subjects([]<class Raw, int F>(const int64_t* v) -> int64_t {
              return kernel::multiply_add<Raw, F>(Raw(v[0]), Raw(v[1]), Raw(v[2]));
          }),
          [](const int64_t* v, exact::Format format) {
              return exact::multiply_add(v[0], v[1], v[2], format).wrapped;
          });
}

TEST(Dot, IsRoundedOnce) {
    check(subjects([]<class Raw, int F>(const int64_t* v) -> int64_t {
              const Raw a[2] = {Raw(v[0]), Raw(v[2])}, b[2] = {Raw(v[1]), Raw(v[3])};
              return kernel::dot2<Raw, F>(a, b);
          }),
          [](const int64_t* v, exact::Format format) {
              const int64_t a[2] = {v[0], v[2]}, b[2] = {v[1], v[3]};
              return exact::dot(a, b, 2, format).wrapped;
          });
    check(subjects([]<class Raw, int F>(const int64_t* v) -> int64_t {
              const Raw a[3] = {Raw(v[0]), Raw(v[2]), Raw(v[1])};
              const Raw b[3] = {Raw(v[1]), Raw(v[3]), Raw(v[2])};
              return kernel::dot3<Raw, F>(a, b);
          }),
          [](const int64_t* v, exact::Format format) {
              const int64_t a[3] = {v[0], v[2], v[1]}, b[3] = {v[1], v[3], v[2]};
              return exact::dot(a, b, 3, format).wrapped;
          });
}

// Whether in-place vector steps consist of products and sums as defined.
template <class Raw, int F>
bool are_as_defined(const int64_t* v, void add_scaled(Raw*, const Raw*, Raw),
                    void exchange(Raw*, Raw*, const Raw*, Raw),
                    Raw dot_difference(const Raw*, const Raw*, const Raw*)) {
    const Raw n[3] = {Raw(v[0]), Raw(v[2]), Raw(v[3])}, factor = Raw(v[1]);
    const Raw before[3] = {Raw(v[2]), Raw(v[1]), Raw(v[0])};
    Raw sum[3] = {before[0], before[1], before[2]}, a[3] = {n[0], n[1], n[2]};
    Raw b[3] = {before[0], before[1], before[2]}, difference[3];
    add_scaled(sum, n, factor);
    exchange(a, b, n, factor);
    for (int i = 0; i < 3; ++i) {
        const Raw product = kernel::multiply<Raw, F>(n[i], factor);
        if (sum[i] != kernel::multiply_add<Raw, F>(n[i], factor, before[i]) ||
            a[i] != wrapping_add(n[i], product) || b[i] != wrapping_subtract(before[i], product))
            return false;
        difference[i] = wrapping_subtract(n[i], before[i]);
    }
    return dot_difference(n, n, before) == kernel::dot3<Raw, F>(n, difference);
}
TEST(VectorSteps, AreMadeOfProductsAndSums) {
    const auto defined = [](const int64_t*, exact::Format) { return 1; };
    check(subjects([]<class Raw, int F>(const int64_t* v) -> int64_t {
              return are_as_defined<Raw, F>(v, kernel::add_scaled3<Raw, F>,
                                            kernel::exchange3<Raw, F>,
                                            kernel::dot_difference3<Raw, F>);
          }),
          defined);
    check(subjects([]<class Raw, int F>(const int64_t* v) -> int64_t {
              return are_as_defined<Raw, F>(v, portable::add_scaled3<Raw, F>,
                                            portable::exchange3<Raw, F>,
                                            portable::dot_difference3<Raw, F>);
          }),
          defined);
}

// Three products of the smallest number overflow a signed number of twice the width.
TEST(Dot, HoldsThreeSquaresOfTheSmallestNumber) {
    for (const Subject& subject : subjects([]<class Raw, int F>(const int64_t*) -> int64_t {
             const Raw v[3] = {RawLimits<Raw>::min, RawLimits<Raw>::min, RawLimits<Raw>::min};
             return kernel::dot3<Raw, F>(v, v);
         })) {
        const int64_t least = exact::smallest(subject.format.width), v[3] = {least, least, least};
        EXPECT_EQ(subject.compute(v), exact::dot(v, v, 3, subject.format).wrapped);
    }
}

int64_t quotient(const int64_t* v, exact::Format format) {
    if (v[1] != 0) return exact::divide(v[0], v[1], format).saturated;
    return v[0] == 0 ? 0 : v[0] > 0 ? exact::largest(format.width) : exact::smallest(format.width);
}

std::vector<Subject> divisions() {
    std::vector<Subject> all = subjects([]<class Raw, int F>(const int64_t* v) -> int64_t {
        return kernel::divide<Raw, F>(Raw(v[0]), Raw(v[1]));
    });
    for (const auto& more : {subjects([]<class Raw, int F>(const int64_t* v) -> int64_t {
                                 return portable::divide_widening<Raw, F>(Raw(v[0]), Raw(v[1]));
                             }),
                             subjects([]<class Raw, int F>(const int64_t* v) -> int64_t {
                                 return portable::divide_small<Raw, F>(Raw(v[0]), Raw(v[1]));
                             })}) {
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

TEST(Divide, IsTheNearestNumberSaturated) { check(divisions(), quotient); }

// Quotients halfway between two numbers, of either sign, their neighbours, and the limits.
TEST(Divide, RoundsHalvesUpAndSaturatesHalfAnUlpBeyondTheLimits) {
    for (const Subject& subject : divisions()) {
        const auto [width, F] = subject.format;
        SCOPED_TRACE(testing::Message() << width << " bits, F = " << F);
        const auto check = [&](int64_t a, int64_t b) {
            const int64_t v[2] = {a, b};
            ASSERT_EQ(subject.compute(v), quotient(v, subject.format)) << a << " / " << b;
        };
        if (F < width - 2) {
            for (int half = -19; half <= 19; ++half) {
                check(half, int64_t(1) << (F + 1));
                check(half, -(int64_t(1) << (F + 1)));
            }
        }
        // a 2^F / b near 2^(W-1).
        for (int64_t b = 1; b < 40; ++b) {
            const __int128 limit = (static_cast<__int128>(b) << (width - 1)) >> F;
            for (int offset = -1; offset <= 1; ++offset) {
                if (limit + offset > exact::largest(width)) continue;
                const auto a = static_cast<int64_t>(limit + offset);
                check(a, b), check(-a, b), check(a, -b);
            }
        }
    }
}

TEST(Remainder, IsExactWithTheSignOfTheDividend) {
    check(subjects([]<class Raw, int F>(const int64_t* v) -> int64_t {
              return portable::remainder<Raw, F>(Raw(v[0]), Raw(v[1]));
          }),
          [](const int64_t* v, exact::Format) {
              return v[1] == 0 ? v[0] : v[1] == -1 ? 0 : v[0] % v[1];
          });
}

// The device's implementation against the native type of the host.
TEST(Wide, DigitsAndBitsAreTheNativeResults) {
    std::mt19937_64 random(7);
    for (int i = 0; i < 100000; ++i) {
        const uint64_t a = random() >> random() % 64, b = random() >> random() % 64;
        const auto native = portable::multiply_full(a, b);
        const auto digits = portable::multiply_full_by_digits(a, b);
        ASSERT_EQ(digits.high, native.high) << a << " " << b;
        ASSERT_EQ(digits.low, native.low) << a << " " << b;
        const uint64_t divisor = (random() >> random() % 64) | 1, high = a % divisor;
        const auto quotient = portable::divide_full(high, b, divisor);
        const auto bits = portable::divide_full_by_bits(high, b, divisor);
        ASSERT_EQ(bits.quotient, quotient.quotient) << high << " " << b << " " << divisor;
        ASSERT_EQ(bits.remainder, quotient.remainder) << high << " " << b << " " << divisor;
    }
}

static_assert(kernel::divide<int32_t, 16>(3 << 16, 7 << 16) == 28087,
              "A division of constants is a constant.");
static_assert(kernel::divide<int32_t, 16>(-1, 2 << 16) == 0, "Half an ulp is rounded up.");

}  // namespace
