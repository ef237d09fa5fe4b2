// SPDX-License-Identifier: MIT
// The operations that are exact or rounded once (lerp, smoothstep, midpoint, quotients with
// remainder, ...) compared with exact integers: every operand of every 8-bit format, boundary and
// random operands of the wider formats.
#include <gtest/gtest.h>

#include <algorithm>
#include <fixedpoint/arithmetic/checked.hpp>
#include <fixedpoint/arithmetic/rounded.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/conversion.hpp>
#include <fixedpoint/integer_root.hpp>
#include <fixedpoint/math.hpp>
#include <fixedpoint/vector.hpp>
#include <limits>
#include <numeric>
#include <random>
#include <utility>

#include "exact.hpp"
#include "exact_integer.hpp"

namespace {

using namespace fixedpoint;
using exact::Int;

int events = 0;
Event last_event;
fixedpoint::Operation last_operation;
struct Hook {
    static void notify(Event event, fixedpoint::Operation operation) {
        ++events;
        last_event = event;
        last_operation = operation;
    }
};

template <class Number>
Number number(int64_t raw) {
    return Number::from_raw(static_cast<typename Number::Raw>(raw));
}

// The result in each arithmetic, and how many events Checked reported.
struct Results {
    int64_t nearest, saturating, checked;
    int events;
};
template <int Bits, int F, class Operation, class... Raws>
Results in_each_arithmetic(Operation operation, Raws... raws) {
    const auto result = [&]<class Number>(Number) {
        return operation(number<Number>(raws)...).raw();
    };
    events = 0;
    const int64_t checked = result(Fixed<Bits - F, F, Checked<Hook>>());
    return {result(Fixed<Bits - F, F>()), result(Fixed<Bits - F, F, Saturating>()), checked,
            events};
}

struct Quotient {
    int64_t quotient, remainder;
};
struct Pair {
    int sign;
    int64_t midpoint;
    Results copysign, abs_diff;
    Quotient truncated, floored;
};
// The operations of a format as plain functions, so that the checks are compiled once.
struct Split {
    int width, fraction;
    Results (*lerp)(int64_t a, int64_t b, int64_t t);
    int64_t (*smoothstep)(int64_t t);
    Pair (*pair)(int64_t a, int64_t b);
};
template <int Bits, int F>
Split split() {
    using Number = Fixed<Bits - F, F>;
    return {
        Bits, F,
        [](int64_t a, int64_t b, int64_t t) {
            return in_each_arithmetic<Bits, F>([](auto x, auto y, auto z) { return lerp(x, y, z); },
                                               a, b, t);
        },
        [](int64_t t) -> int64_t { return smoothstep(number<Number>(t)).raw(); },
        [](int64_t a, int64_t b) -> Pair {
            const auto x = number<Number>(a), y = number<Number>(b);
            const auto truncated = divrem(x, y), floored = divmod(x, y);
            return {
                sign(x),
                midpoint(x, y).raw(),
                in_each_arithmetic<Bits, F>([](auto u, auto v) { return copysign(u, v); }, a, b),
                in_each_arithmetic<Bits, F>([](auto u, auto v) { return abs_diff(u, v); }, a, b),
                {truncated.quotient, truncated.remainder.raw()},
                {floored.quotient, floored.remainder.raw()}};
        }};
}
template <int Bits, int... F>
void add_splits(std::vector<Split>& all, std::integer_sequence<int, F...>) {
    (all.push_back(split<Bits, F>()), ...);
}
std::vector<Split> splits_of_8_bits() {
    std::vector<Split> all;
    add_splits<8>(all, std::make_integer_sequence<int, 8>());
    return all;
}
std::vector<Split> wider_splits() {
    std::vector<Split> all;
    add_splits<16>(all, std::integer_sequence<int, 0, 1, 8, 15>());
    add_splits<24>(all, std::integer_sequence<int, 0, 10, 12, 16, 23>());
    add_splits<32>(all, std::integer_sequence<int, 0, 1, 10, 11, 16, 21, 22, 30, 31>());
    add_splits<64>(all, std::integer_sequence<int, 0, 1, 21, 22, 31, 32, 33, 48, 62, 63>());
    return all;
}

// Numbers of every magnitude and those at the limits, but not all 16-bit numbers.
std::vector<int64_t> operands(int width, size_t count) {
    std::vector<int64_t> numbers = exact::raws(width);
    std::mt19937_64 random(7);
    std::shuffle(numbers.begin(), numbers.end(), random);
    numbers.resize(count / exact::operand_step);
    for (int i = 0; i < 3; ++i) {
        for (const int64_t n :
             {int64_t(i), int64_t(-i), exact::largest(width) - i, exact::smallest(width) + i})
            numbers.push_back(n);
    }
    return numbers;
}
// Calls check(a, b) for every pair of 8 bits, or of `count` numbers and the limits, until one
// fails.
template <class Check>
void for_each_pair(int width, size_t count, Check check) {
    std::vector<int64_t> left = width == 8 ? exact::raws(8) : operands(width, count), right = left;
    const size_t step = width == 8 ? exact::operand_step : 1;
    for (const int64_t a : left) {
        for (size_t i = 0; i < right.size(); i += step) {
            check(a, right[i]);
            if (testing::Test::HasFatalFailure()) return;
        }
    }
}

bool as_exact(const Results& results, const Int& exact, int width) {
    return results.nearest == exact::wrapped(exact, width) && results.checked == results.nearest &&
           results.saturating == exact::saturated(exact, width) &&
           results.events == (exact::fits(exact, width) ? 0 : 1);
}

// floor(n / 2^bits + 1/2) for small integers.
int64_t rounded(int64_t n, int bits) {
    return bits == 0 ? n : (n + (int64_t(1) << (bits - 1))) >> bits;
}

template <int F>
int64_t failures_of_lerp() {
    int64_t failures = 0;
    for (int a = -128; a < 128; ++a) {
        for (int b = -128; b < 128; b += exact::operand_step) {
            for (int t = -128; t < 128; t += exact::operand_step) {
                const int64_t exact = a + rounded(int64_t(t) * (b - a), F);
                const auto of = [&]<class Number>(Number) {
                    return lerp(number<Number>(a), number<Number>(b), number<Number>(t)).raw();
                };
                failures += of(Fixed<8 - F, F>()) != static_cast<int8_t>(exact);
                // If nothing saturates, the two are the same function.
                if (exact >= -128 && exact < 128) continue;
                failures += of(Fixed<8 - F, F, Saturating>()) != (exact < 0 ? -128 : 127);
            }
        }
    }
    return failures;
}
TEST(Lerp, EveryOperandOf8Bits) {
    const auto check = []<int... F>(std::integer_sequence<int, F...>) {
        int f = 0;
        for (const int64_t failures : {failures_of_lerp<F>()...}) EXPECT_EQ(failures, 0) << f++;
    };
    check(std::make_integer_sequence<int, 8>());
}

TEST(Lerp, OfWiderNumbers) {
    for (const Split& split : wider_splits()) {
        const std::vector<int64_t> numbers = operands(split.width, 20);
        for (const int64_t a : numbers) {
            for (const int64_t b : numbers) {
                for (const int64_t t : numbers) {
                    const Int exact =
                        a + exact::nearest(Int(t) * (Int(b) - a), Int(1) << split.fraction);
                    const Results results = split.lerp(a, b, t);
                    ASSERT_TRUE(as_exact(results, exact, split.width))
                        << a << ", " << b << ", " << t << ", F = " << split.fraction << ": "
                        << results.nearest << ", " << results.saturating << " for " << exact;
                    ASSERT_TRUE(results.events == 0 ||
                                (last_event == Event::overflow &&
                                 last_operation == fixedpoint::Operation::lerp));
                }
            }
        }
    }
}

TEST(Smoothstep, EveryNumberOf8And16BitsAndSomeOfWiderOnes) {
    const auto check = [](const Split& split, int64_t t) {
        const Int one = Int(1) << split.fraction;
        const Int u = t < 0 ? Int(0) : t > one ? one : Int(t);
        const Int exact = exact::nearest(u * u * (3 * one - 2 * u), one * one);
        ASSERT_EQ(split.smoothstep(t), exact::saturated(exact, split.width))
            << t << ", F = " << split.fraction;
    };
    for (const Split& split : splits_of_8_bits()) {
        for (int t = -128; t < 128; ++t) check(split, t);
    }
    for (const Split& split : wider_splits()) {
        std::mt19937_64 random(static_cast<uint64_t>(split.fraction));
        for (const int64_t t : exact::raws(split.width)) check(split, t);
        // Between 0 and 1, where the result is neither.
        for (int i = 0; i < 2000; ++i)
            check(split, exact::wrapped(random() >> 1 >> (63 - split.fraction), split.width));
    }
}

// a / 0: the limit that has the sign of a.
int64_t limit_of(int64_t a, int width) {
    return a > 0 ? exact::largest(width) : a < 0 ? exact::smallest(width) : 0;
}
void expect_pair(const Split& split, int64_t a, int64_t b) {
    const int width = split.width;
    const Pair pair = split.pair(a, b);
    ASSERT_EQ(pair.sign, (a > 0) - (a < 0));
    ASSERT_TRUE(as_exact(pair.copysign, (b < 0 ? -1 : 1) * abs(Int(a)), width)) << a << ", " << b;
    ASSERT_TRUE(as_exact(pair.abs_diff, abs(Int(a) - b), width)) << a << ", " << b;
    ASSERT_EQ(pair.midpoint, exact::nearest(Int(a) + b, 2)) << a << ", " << b;
    if (b == 0) {
        for (const Quotient& each : {pair.truncated, pair.floored})
            ASSERT_TRUE(each.quotient == limit_of(a, width) && each.remainder == a) << a;
        return;
    }
    // Int divides toward zero.
    ASSERT_EQ(pair.truncated.quotient, exact::saturated(Int(a) / b, width)) << a << ", " << b;
    ASSERT_EQ(pair.truncated.remainder, Int(a) % b);
    const Int quotient = exact::floor_of(b < 0 ? -Int(a) : Int(a), abs(Int(b)));
    ASSERT_EQ(pair.floored.quotient, exact::saturated(quotient, width)) << a << ", " << b;
    ASSERT_EQ(pair.floored.remainder, a - quotient * b);
}
TEST(Pairs, EveryPairOf8BitsAndSomeOfWiderOnes) {
    for (const std::vector<Split>& splits : {splits_of_8_bits(), wider_splits()}) {
        for (const Split& split : splits) {
            for_each_pair(split.width, 100,
                          [&](int64_t a, int64_t b) { expect_pair(split, a, b); });
        }
    }
}
TEST(Pairs, CheckedTellsOfAQuotientThatThereIsNot) {
    using Number = Fixed<8, 8, Checked<Hook>>;
    const auto told = [](int16_t a, int16_t b, Event event) {
        events = 0;
        divmod(Number::from_raw(a), Number::from_raw(b));
        return events == 1 && last_event == event;
    };
    EXPECT_TRUE(told(5, 0, Event::division_by_zero));
    EXPECT_TRUE(told(-32768, -1, Event::overflow));
    EXPECT_FALSE(told(-32768, 1, Event::overflow) || told(5, -1, Event::overflow));
}

void expect_root(const Int& n, const Int& root, const Int& of_kernel) {
    ASSERT_EQ(of_kernel, root) << n;
    if (n < 1) {
        ASSERT_EQ(root, 0);
        return;
    }
    ASSERT_TRUE(root * root <= n && (root + 1) * (root + 1) > n) << n;
}
template <class Integral>
void expect_roots(const std::vector<Integral>& numbers) {
    for (const Integral n : numbers) {
        expect_root(+n, +isqrt(n), +kernel::integer_root(n));
        if (testing::Test::HasFatalFailure()) return;
    }
}
template <class Integral>
std::vector<Integral> raws() {
    std::vector<Integral> numbers;
    for (const int64_t n : exact::raws(8 * int{sizeof(Integral)}))
        numbers.push_back(static_cast<Integral>(n));
    return numbers;
}
TEST(IntegerRoot, IsTheLargestIntegerWhoseSquareIsNotLarger) {
    expect_roots(raws<int8_t>());
    expect_roots(raws<int16_t>());
    expect_roots(raws<Int24>());
    expect_roots(raws<int32_t>());
    expect_roots(raws<int64_t>());
    expect_roots(raws<uint8_t>());
    expect_roots(raws<uint16_t>());
    expect_roots(raws<UnsignedInt24>());
    expect_roots(raws<uint32_t>());
    expect_roots(raws<uint64_t>());
    std::vector<uint8_t> all_of_8_bits(256);
    std::iota(all_of_8_bits.begin(), all_of_8_bits.end(), uint8_t(0));
    expect_roots(all_of_8_bits);
    std::vector<uint16_t> all_of_16_bits(65536);
    std::iota(all_of_16_bits.begin(), all_of_16_bits.end(), uint16_t(0));
    expect_roots(all_of_16_bits);
    // Squares and the numbers just below them.
    std::vector<uint32_t> squares_of_16_bits;
    for (uint32_t n = 1; n <= UINT16_MAX; ++n) {
        squares_of_16_bits.push_back(n * n);
        squares_of_16_bits.push_back(n * n - 1);
    }
    squares_of_16_bits.push_back(UINT32_MAX);
    expect_roots(squares_of_16_bits);
    std::vector<uint64_t> squares = {UINT64_MAX};
    for (uint64_t n = 1; n <= UINT32_MAX; n += n / 9 + 1) {
        squares.push_back(n * n);
        squares.push_back(n * n - 1);
    }
    for (uint64_t n = UINT32_MAX; n > UINT32_MAX - 1000; --n) {
        squares.push_back(n * n);
        squares.push_back(n * n - 1);
    }
    expect_roots(squares);
}

// n / d for integers in a rounding mode. d must be above 0.
Int rounded_to(Rounding rounding, const Int& n, const Int& d) {
    const Int below = exact::floor_of(n, d), rest = n - below * d;
    switch (rounding) {
        case Rounding::toward_zero:
            return n / d;  // like Boost
        case Rounding::downward:
            return below;
        case Rounding::half_to_even:
            return below + (2 * rest > d || (2 * rest == d && below % 2 != 0) ? 1 : 0);
    }
    return 0;
}
struct RoundedResults {
    int64_t product, multiply_add, dot2, dot3, quotient, scaled_by_3, scaled_by_all, coarse;
};
struct RoundedSplit {
    int width, fraction;
    RoundedResults (*compute)(int64_t a, int64_t b);
};
template <Rounding rounding, int Bits, int F>
RoundedSplit rounded_split() {
    return {Bits, F, [](int64_t a, int64_t b) -> RoundedResults {
                using Number = Fixed<Bits - F, F, Rounded<rounding>>;
                const auto x = number<Number>(a), y = number<Number>(b);
                const Number u[] = {x, y, x}, v[] = {y, y, x};
                // To fewer fraction bits, and to integers.
                using Coarse = Fixed<Bits - F / 2, F / 2, Rounded<rounding>>;
                return {(x * y).raw(),
                        multiply_add(x, y, x).raw(),
                        dot2(u, v).raw(),
                        dot3(u, v).raw(),
                        (x / y).raw(),
                        scale_down<3>(x).raw(),
                        scale_down<Bits>(x).raw(),
                        convert<Coarse>(x).raw()};
            }};
}
void expect_rounded(Rounding rounding, const RoundedSplit& split, int64_t a, int64_t b) {
    const auto nearest = [&](const Int& n, const Int& d) { return rounded_to(rounding, n, d); };
    const int width = split.width, F = split.fraction;
    const Int one = Int(1) << F, product = nearest(Int(a) * b, one),
              two = product + nearest(Int(b) * b, one);
    const RoundedResults got = split.compute(a, b);
    const auto expect = [&](const char* name, int64_t result, const Int& exact) {
        ASSERT_EQ(result, exact::wrapped(exact, width))
            << name << " of " << a << ", " << b << ", F = " << F;
    };
    expect("x * y", got.product, product);
    expect("multiply_add", got.multiply_add, product + a);
    expect("dot2", got.dot2, two);
    expect("dot3", got.dot3, two + nearest(Int(a) * a, one));
    expect("x / y", got.quotient,
           b == 0 ? limit_of(a, width)
                  : exact::saturated(nearest((b < 0 ? -1 : 1) * Int(a) * one, abs(Int(b))), width));
    expect("scale_down by 3", got.scaled_by_3, nearest(a, 8));
    ASSERT_EQ(got.scaled_by_all, nearest(a, Int(1) << width));
    expect("convert", got.coarse, nearest(a, Int(1) << (F - F / 2)));
}
template <Rounding rounding>
void expect_every_rounding() {
    for (const RoundedSplit& split :
         {rounded_split<rounding, 8, 0>(), rounded_split<rounding, 8, 4>(),
          rounded_split<rounding, 8, 7>(), rounded_split<rounding, 16, 8>(),
          rounded_split<rounding, 16, 15>(), rounded_split<rounding, 24, 12>(),
          rounded_split<rounding, 32, 16>(), rounded_split<rounding, 32, 31>(),
          rounded_split<rounding, 64, 32>(), rounded_split<rounding, 64, 63>()}) {
        for_each_pair(split.width, 30,
                      [&](int64_t a, int64_t b) { expect_rounded(rounding, split, a, b); });
    }
}
TEST(Rounding, TowardZero) { expect_every_rounding<Rounding::toward_zero>(); }
TEST(Rounding, Downward) { expect_every_rounding<Rounding::downward>(); }
TEST(Rounding, HalfToEven) { expect_every_rounding<Rounding::half_to_even>(); }

}  // namespace
