// SPDX-License-Identifier: MIT
// The operations that are exact or rounded once (lerp, smoothstep, midpoint, quotients with
// remainder, ...) against exact integers: every operand of every split of 8 bits, boundary and
// random ones of the wider formats.
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

template <int Bits, int... F, class Check>
void for_each_split(std::integer_sequence<int, F...>, Check check) {
    (check.template operator()<Bits, F>(), ...);
}
template <class Check>
void for_each_8_bit_split(Check check) {
    for_each_split<8>(std::make_integer_sequence<int, 8>(), check);
}
template <class Check>
void for_each_wider_split(Check check) {
    for_each_split<16>(std::integer_sequence<int, 0, 1, 8, 15>(), check);
    for_each_split<32>(std::integer_sequence<int, 0, 1, 10, 11, 16, 21, 22, 30, 31>(), check);
    for_each_split<64>(std::integer_sequence<int, 0, 1, 21, 22, 31, 32, 33, 48, 62, 63>(), check);
}

// Numbers of every magnitude and those at the limits, not all of 16 bits.
template <class Raw>
std::vector<Raw> operands(size_t count) {
    std::vector<Raw> numbers = exact::raws<Raw>();
    std::mt19937_64 random(7);
    std::shuffle(numbers.begin(), numbers.end(), random);
    numbers.resize(count / exact::operand_step);
    for (int i = 0; i < 3; ++i) {
        numbers.push_back(static_cast<Raw>(i));
        numbers.push_back(static_cast<Raw>(-i));
        numbers.push_back(static_cast<Raw>(RawLimits<Raw>::max - i));
        numbers.push_back(static_cast<Raw>(RawLimits<Raw>::min + i));
    }
    return numbers;
}

// floor(n / 2^bits + 1/2) of small integers.
int64_t rounded(int64_t n, int bits) {
    return bits == 0 ? n : (n + (int64_t(1) << (bits - 1))) >> bits;
}

TEST(Lerp, EveryOperandOf8Bits) {
    for_each_8_bit_split([]<int Bits, int F>() {
        using Number = Fixed<Bits - F, F>;
        using SaturatingNumber = Fixed<Bits - F, F, Saturating>;
        int64_t failures = 0;
        for (int a = -128; a < 128; ++a) {
            for (int b = -128; b < 128; b += exact::operand_step) {
                for (int t = -128; t < 128; t += exact::operand_step) {
                    const int64_t exact = a + rounded(int64_t(t) * (b - a), F);
                    const auto raw = [](int n) { return static_cast<int8_t>(n); };
                    failures += lerp(Number::from_raw(raw(a)), Number::from_raw(raw(b)),
                                     Number::from_raw(raw(t)))
                                    .raw() != static_cast<int8_t>(exact);
                    // Where nothing saturates the two are the same function.
                    if (exact >= -128 && exact < 128) continue;
                    failures +=
                        lerp(SaturatingNumber::from_raw(raw(a)), SaturatingNumber::from_raw(raw(b)),
                             SaturatingNumber::from_raw(raw(t)))
                            .raw() != (exact < 0 ? -128 : 127);
                }
            }
        }
        EXPECT_EQ(failures, 0) << F;
    });
}

TEST(Lerp, OfWiderNumbers) {
    for_each_wider_split([]<int Bits, int F>() {
        using Raw = Integer<Bits>;
        const std::vector<Raw> numbers = operands<Raw>(20);
        for (const Raw a : numbers) {
            for (const Raw b : numbers) {
                for (const Raw t : numbers) {
                    const Int exact = a + exact::nearest(Int(t) * (Int(b) - a), Int(1) << F);
                    const auto of = [&](auto number) {
                        using Number = decltype(number);
                        return lerp(Number::from_raw(a), Number::from_raw(b), Number::from_raw(t))
                            .raw();
                    };
                    ASSERT_EQ(of(Fixed<Bits - F, F>()), exact::wrapped<Raw>(exact))
                        << a << ", " << b << ", " << t << ", F = " << F;
                    ASSERT_EQ(of(Fixed<Bits - F, F, Saturating>()), exact::clamped<Raw>(exact));
                    events = 0;
                    of(Fixed<Bits - F, F, Checked<Hook>>());
                    ASSERT_EQ(events, exact::fits<Raw>(exact) ? 0 : 1);
                    if (events == 0) continue;
                    ASSERT_TRUE(last_event == Event::overflow &&
                                last_operation == fixedpoint::Operation::lerp);
                }
            }
        }
    });
}

template <int Bits, int F>
void expect_smoothstep(Integer<Bits> t) {
    using Raw = Integer<Bits>;
    const Int one = Int(1) << F;
    const Int u = t < 0 ? Int(0) : t > one ? one : Int(t);
    const Int exact = exact::nearest(u * u * (3 * one - 2 * u), one * one);
    ASSERT_EQ((smoothstep(Fixed<Bits - F, F>::from_raw(t)).raw()), exact::clamped<Raw>(exact))
        << t << ", F = " << F;
}
TEST(Smoothstep, EveryNumberOf8And16BitsAndSomeOfWiderOnes) {
    for_each_8_bit_split([]<int Bits, int F>() {
        for (int t = -128; t < 128; ++t) expect_smoothstep<Bits, F>(static_cast<int8_t>(t));
    });
    for_each_wider_split([]<int Bits, int F>() {
        std::mt19937_64 random(F);
        for (const auto t : exact::raws<Integer<Bits>>()) expect_smoothstep<Bits, F>(t);
        // From 0 to 1, where the result is neither.
        for (int i = 0; i < 2000; ++i)
            expect_smoothstep<Bits, F>(static_cast<Integer<Bits>>(random() >> 1 >> (63 - F)));
    });
}

template <int Bits, int F>
void expect_pair(Integer<Bits> a, Integer<Bits> b) {
    using Raw = Integer<Bits>;
    using Number = Fixed<Bits - F, F>;
    const Number x = Number::from_raw(a), y = Number::from_raw(b);
    ASSERT_EQ(sign(x), (a > 0) - (a < 0));
    using SaturatingNumber = Fixed<Bits - F, F, Saturating>;
    using CheckedNumber = Fixed<Bits - F, F, Checked<Hook>>;
    const Int signed_as_b = (b < 0 ? -1 : 1) * abs(Int(a)), distance = abs(Int(a) - b);
    events = 0;
    ASSERT_EQ(copysign(x, y).raw(), exact::wrapped<Raw>(signed_as_b));
    ASSERT_EQ(copysign(SaturatingNumber::from_raw(a), SaturatingNumber::from_raw(b)).raw(),
              exact::clamped<Raw>(signed_as_b));
    ASSERT_EQ(copysign(CheckedNumber::from_raw(a), CheckedNumber::from_raw(b)).raw(),
              exact::wrapped<Raw>(signed_as_b));
    ASSERT_EQ(events, exact::fits<Raw>(signed_as_b) ? 0 : 1);
    ASSERT_EQ(midpoint(x, y).raw(), exact::nearest(Int(a) + b, 2)) << a << ", " << b;
    ASSERT_EQ(abs_diff(x, y).raw(), exact::wrapped<Raw>(distance));
    ASSERT_EQ(abs_diff(SaturatingNumber::from_raw(a), SaturatingNumber::from_raw(b)).raw(),
              exact::clamped<Raw>(distance));
    events = 0;
    ASSERT_EQ(abs_diff(CheckedNumber::from_raw(a), CheckedNumber::from_raw(b)).raw(),
              exact::wrapped<Raw>(distance));
    ASSERT_EQ(events, exact::fits<Raw>(distance) ? 0 : 1);
    const auto truncated = divrem(x, y), floored = divmod(x, y);
    if (b == 0) {
        const Raw limit = a > 0 ? RawLimits<Raw>::max : a < 0 ? RawLimits<Raw>::min : Raw(0);
        ASSERT_TRUE(truncated.quotient == limit && truncated.remainder.raw() == a &&
                    floored.quotient == limit && floored.remainder.raw() == a);
        return;
    }
    // Boost divides integers toward zero.
    ASSERT_EQ(truncated.quotient, exact::clamped<Raw>(Int(a) / b)) << a << ", " << b;
    ASSERT_EQ(truncated.remainder.raw(), Int(a) % b);
    const Int quotient = exact::floor_of(b < 0 ? -Int(a) : Int(a), abs(Int(b)));
    ASSERT_EQ(floored.quotient, exact::clamped<Raw>(quotient)) << a << ", " << b;
    ASSERT_EQ(floored.remainder.raw(), a - quotient * b);
}
TEST(Pairs, EveryPairOf8BitsAndSomeOfWiderOnes) {
    for_each_8_bit_split([]<int Bits, int F>() {
        for (int a = -128; a < 128; ++a) {
            for (int b = -128; b < 128; b += exact::operand_step)
                expect_pair<Bits, F>(static_cast<int8_t>(a), static_cast<int8_t>(b));
        }
    });
    for_each_wider_split([]<int Bits, int F>() {
        const auto numbers = operands<Integer<Bits>>(100);
        for (const auto a : numbers) {
            for (const auto b : numbers) expect_pair<Bits, F>(a, b);
        }
    });
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

template <class Integral>
void expect_roots(const std::vector<Integral>& numbers) {
    for (const Integral n : numbers) {
        const Int root = isqrt(n);
        ASSERT_EQ(kernel::integer_root(n), root) << Int(n);
        if (n < Integral(1)) {
            ASSERT_EQ(root, 0);
            continue;
        }
        ASSERT_TRUE(root * root <= n && (root + 1) * (root + 1) > n) << Int(n);
    }
}
template <class Integral>
std::vector<Integral> unsigned_ones() {
    std::vector<Integral> numbers;
    for (const auto n : exact::raws<Integer<8 * sizeof(Integral)>>())
        numbers.push_back(static_cast<Integral>(n));
    return numbers;
}
TEST(IntegerRoot, IsTheLargestIntegerWhoseSquareIsNotLarger) {
    expect_roots(exact::raws<int8_t>());
    expect_roots(exact::raws<int16_t>());
    expect_roots(exact::raws<int32_t>());
    expect_roots(exact::raws<int64_t>());
    expect_roots(unsigned_ones<uint8_t>());
    expect_roots(unsigned_ones<uint16_t>());
    expect_roots(unsigned_ones<uint32_t>());
    expect_roots(unsigned_ones<uint64_t>());
    std::vector<uint8_t> all_of_8_bits(256);
    std::iota(all_of_8_bits.begin(), all_of_8_bits.end(), uint8_t(0));
    expect_roots(all_of_8_bits);
    std::vector<uint16_t> all_of_16_bits(65536);
    std::iota(all_of_16_bits.begin(), all_of_16_bits.end(), uint16_t(0));
    expect_roots(all_of_16_bits);
    // Squares, and the numbers before them.
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

// n / d of integers, d > 0, as a mode rounds it.
Int rounded_to(Rounding rounding, const Int& n, const Int& d) {
    const Int below = exact::floor_of(n, d), rest = n - below * d;
    switch (rounding) {
        case Rounding::toward_zero:
            return n / d;  // as Boost divides
        case Rounding::downward:
            return below;
        case Rounding::half_to_even:
            return below + (2 * rest > d || (2 * rest == d && below % 2 != 0) ? 1 : 0);
    }
    return 0;
}
template <Rounding rounding, int Bits, int F>
void expect_rounded(Integer<Bits> a, Integer<Bits> b) {
    using Raw = Integer<Bits>;
    using Number = Fixed<Bits - F, F, Rounded<rounding>>;
    const Number x = Number::from_raw(a), y = Number::from_raw(b);
    const Int one = Int(1) << F;
    ASSERT_EQ((x * y).raw(), exact::wrapped<Raw>(rounded_to(rounding, Int(a) * b, one)))
        << a << ", " << b << ", F = " << F;
    ASSERT_EQ(multiply_add(x, y, x).raw(),
              exact::wrapped<Raw>(rounded_to(rounding, Int(a) * b, one) + a));
    const Number u[] = {x, y, x}, v[] = {y, y, x};
    const Int two = rounded_to(rounding, Int(a) * b, one) + rounded_to(rounding, Int(b) * b, one);
    ASSERT_EQ(dot2(u, v).raw(), exact::wrapped<Raw>(two));
    ASSERT_EQ(dot3(u, v).raw(), exact::wrapped<Raw>(two + rounded_to(rounding, Int(a) * a, one)));
    const Raw limit = a > 0 ? RawLimits<Raw>::max : a < 0 ? RawLimits<Raw>::min : Raw(0);
    ASSERT_EQ((x / y).raw(), b == 0 ? limit
                                    : exact::clamped<Raw>(rounded_to(
                                          rounding, (b < 0 ? -1 : 1) * Int(a) * one, abs(Int(b)))))
        << a << ", " << b << ", F = " << F;
    ASSERT_EQ(scale_down<3>(x).raw(), exact::wrapped<Raw>(rounded_to(rounding, a, 8)));
    ASSERT_EQ(scale_down<Bits>(x).raw(), rounded_to(rounding, a, Int(1) << Bits));
    // To less fraction bits, and to integers.
    using Coarse = Fixed<Bits - F / 2, F / 2, Rounded<rounding>>;
    ASSERT_EQ(convert<Coarse>(x).raw(),
              exact::wrapped<Raw>(rounded_to(rounding, a, Int(1) << (F - F / 2))));
}
template <Rounding rounding>
void expect_every_rounding() {
    for_each_split<8>(std::integer_sequence<int, 0, 4, 7>(), []<int Bits, int F>() {
        for (int a = -128; a < 128; ++a) {
            for (int b = -128; b < 128; b += exact::operand_step)
                expect_rounded<rounding, Bits, F>(static_cast<int8_t>(a), static_cast<int8_t>(b));
        }
    });
    const auto check = []<int Bits, int F>() {
        const auto numbers = operands<Integer<Bits>>(30);
        for (const auto a : numbers) {
            for (const auto b : numbers) expect_rounded<rounding, Bits, F>(a, b);
        }
    };
    for_each_split<16>(std::integer_sequence<int, 15>(), check);
    for_each_split<32>(std::integer_sequence<int, 16>(), check);
    for_each_split<64>(std::integer_sequence<int, 32, 63>(), check);
}
TEST(Rounding, TowardZero) { expect_every_rounding<Rounding::toward_zero>(); }
TEST(Rounding, Downward) { expect_every_rounding<Rounding::downward>(); }
TEST(Rounding, HalfToEven) { expect_every_rounding<Rounding::half_to_even>(); }

}  // namespace
