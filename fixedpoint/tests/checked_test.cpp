// SPDX-License-Identifier: MIT
// Checked tells its hook exactly where the exact result, rounded, is not in the range or there is
// none: every operation, every split of 8 bits, every operand. Of wider formats, operands on both
// sides of the limit.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fixedpoint/arithmetic/checked.hpp>
#include <fixedpoint/conversion.hpp>
#include <fixedpoint/math.hpp>
#include <fixedpoint/vector.hpp>
#include <limits>
#include <random>
#include <utility>

#include "exact.hpp"

namespace {

using namespace fixedpoint;
using exact::Function;

// How often each event but underflow was told, and of which operation last.
struct Told {
    int overflows, divisions_by_zero, domain_errors;
    friend bool operator==(const Told& a, const Told& b) {
        return a.overflows == b.overflows && a.divisions_by_zero == b.divisions_by_zero &&
               a.domain_errors == b.domain_errors;
    }
    friend void PrintTo(const Told& told, std::ostream* stream) {
        *stream << told.overflows << " overflows, " << told.divisions_by_zero
                << " divisions by zero, " << told.domain_errors << " domain errors";
    }
};
Told told;
fixedpoint::Operation last_operation;
struct Hook {
    static void notify(Event event, fixedpoint::Operation operation) {
        told.overflows += event == Event::overflow;
        told.divisions_by_zero += event == Event::division_by_zero;
        told.domain_errors += event == Event::domain_error;
        if (event != Event::underflow) last_operation = operation;
    }
};

constexpr Told nothing = {0, 0, 0}, division_by_zero = {0, 1, 0}, domain_error = {0, 0, 1};
Told overflow_unless(bool fits) { return {fits ? 0 : 1, 0, 0}; }

template <class Compute>
void expect(const Told& expected, fixedpoint::Operation operation, const Compute& compute) {
    told = nothing;
    last_operation = operation;
    compute();
    ASSERT_EQ(told, expected) << "operation " << static_cast<int>(operation);
    ASSERT_EQ(last_operation, operation);
}

template <int F>
using Number = Fixed<8 - F, F, Checked<Hook>>;
template <int F>
constexpr exact::Format format = {8, F};

template <int F>
void check_unary(int raw) {
    using Op = fixedpoint::Operation;
    const auto a = Number<F>::from_raw(static_cast<int8_t>(raw));
    constexpr auto f = format<F>;
    const auto fits = [&](Function which) { return exact::function(which, raw, f).fits; };
    const bool negated_fits = exact::subtract(0, raw, f).fits;
    expect(overflow_unless(negated_fits), Op::negate, [&] { (void)-a; });
    expect(overflow_unless(raw >= 0 || negated_fits), Op::negate, [&] { (void)abs(a); });
    expect(raw < 0 ? domain_error : overflow_unless(fits(Function::sqrt)), Op::sqrt,
           [&] { (void)sqrt(a); });
    expect(raw < 0    ? domain_error
           : raw == 0 ? division_by_zero
                      : overflow_unless(fits(Function::reciprocal_sqrt)),
           Op::reciprocal_sqrt, [&] { (void)reciprocal_sqrt(a); });
    expect(raw <= 0 ? domain_error : overflow_unless(fits(Function::log)), Op::log,
           [&] { (void)log(a); });
    expect(overflow_unless(fits(Function::exp)), Op::exp, [&] { (void)exp(a); });
    expect(overflow_unless(fits(Function::cos)), Op::cos, [&] { (void)cos(a); });
    expect(overflow_unless(fits(Function::cos)), Op::cos, [&] { (void)sincos(a); });
    // In range for every operand.
    expect(overflow_unless(fits(Function::sin)), Op::cos, [&] { (void)sin(a); });
    expect(overflow_unless(fits(Function::atan)), Op::atan2, [&] { (void)atan(a); });
    expect(nothing, Op::round, [&] { (void)floor(a), (void)trunc(a); });
    // ceil(a) = -floor(-a), round(a) = floor(a + 1/2).
    const int one = 1 << F, up = (raw + one - 1) >> F, nearest = (2 * raw + one) >> (F + 1);
    expect(overflow_unless(up * one <= 127), Op::ceil, [&] { (void)ceil(a); });
    expect(overflow_unless(nearest * one <= 127), Op::round, [&] { (void)round(a); });
    for (int count = 0; count < 300; ++count) {
        const bool shift_fits = exact::scale(raw, count, 8).fits;
        expect(overflow_unless(shift_fits), Op::shift_left, [&] { (void)(a << count); });
        expect(nothing, Op::shift_left, [&] { (void)(a >> count); });
    }
    const auto convert_fits = [&](int to, int width, bool is_signed) {
        return overflow_unless(exact::scale(raw, to - F, width, is_signed).fits);
    };
    expect(convert_fits(0, 8, true), Op::convert, [&] { (void)convert<int8_t>(a); });
    expect(convert_fits(0, 8, false), Op::convert, [&] { (void)convert<uint8_t>(a); });
    expect(convert_fits(7, 8, true), Op::convert, [&] { (void)convert<Number<7>>(a); });
    expect(convert_fits(0, 8, true), Op::convert, [&] { (void)convert<Number<0>>(a); });
    expect(convert_fits(16, 32, true), Op::convert, [&] { (void)convert<Q16_16>(a); });
    expect(overflow_unless(exact::scale(raw, F, 8).fits), Op::convert,
           [&] { (void)Number<F>::from_integer(raw); });
    expect(overflow_unless(exact::scale(raw + 65536, F, 8).fits), Op::convert,
           [&] { (void)Number<F>::from_integer(raw + 65536); });
    expect(overflow_unless(exact::decimal(raw, 1, f).fits), Op::from_decimal,
           [&] { (void)from_decimal<Number<F>>(raw, 1); });
    for (const int exponent : {-9, -F, 1 - F, 0}) {
        expect(overflow_unless(exact::binary(raw, exponent, f).fits), Op::from_float,
               [&] { (void)from_float<Number<F>>(std::ldexp(float(raw), exponent)); });
    }
}

template <int F>
void check_binary(int left, int right) {
    using Op = fixedpoint::Operation;
    const auto a = Number<F>::from_raw(static_cast<int8_t>(left));
    const auto b = Number<F>::from_raw(static_cast<int8_t>(right));
    constexpr auto f = format<F>;
    expect(overflow_unless(exact::add(left, right, f).fits), Op::add, [&] { (void)(a + b); });
    expect(overflow_unless(exact::subtract(left, right, f).fits), Op::subtract,
           [&] { (void)(a - b); });
    expect(overflow_unless(exact::multiply_add(left, right, 0, f).fits), Op::multiply,
           [&] { (void)(a * b); });
    expect(right == 0 ? division_by_zero : overflow_unless(exact::divide(left, right, f).fits),
           Op::divide, [&] { (void)(a / b); });
    expect(right == 0 ? division_by_zero : nothing, Op::remainder, [&] { (void)(a % b); });
    expect(overflow_unless(exact::atan2(left, right, f).fits), Op::atan2,
           [&] { (void)atan2(a, b); });
    // A third operand that changes with both.
    const int third = static_cast<int8_t>(left * 5 + right * 3);
    const auto c = Number<F>::from_raw(static_cast<int8_t>(third));
    expect(overflow_unless(exact::multiply_add(left, right, third, f).fits), Op::multiply_add,
           [&] { (void)multiply_add(a, b, c); });
    const Number<F> x[3] = {a, b, c}, y[3] = {b, c, a};
    const int64_t v[3] = {left, right, third}, w[3] = {right, third, left};
    expect(overflow_unless(exact::dot(v, w, 2, f).fits), Op::dot, [&] { (void)dot2(x, y); });
    expect(overflow_unless(exact::dot(v, w, 3, f).fits), Op::dot, [&] { (void)dot3(x, y); });
    expect(overflow_unless(exact::length(v, 2, f).fits), Op::length, [&] { (void)length2(x); });
    expect(overflow_unless(exact::length(v, 3, f).fits), Op::length, [&] { (void)length3(x); });
    for (const bool plane : {false, true}) {
        const Number<F> z[3] = {a, b, plane ? Number<F>() : c};
        const int64_t u[3] = {left, right, plane ? 0 : third};
        Number<F> unit[3];
        const bool is_zero = u[0] == 0 && u[1] == 0 && u[2] == 0;
        const bool fits =
            is_zero || (exact::normalised(u, 0, f).fits && exact::normalised(u, 1, f).fits &&
                        exact::normalised(u, 2, f).fits);
        expect(overflow_unless(fits), Op::normalise, [&] { normalise3(z, unit); });
    }
}

template <int F>
void check_split() {
    SCOPED_TRACE(testing::Message() << F << " fraction bits");
    for (int a = -128; a < 128; ++a) {
        check_unary<F>(a);
        for (int b = -128; b < 128; ++b) check_binary<F>(a, b);
        ASSERT_FALSE(testing::Test::HasFailure()) << a;
    }
}

template <class>
struct Splits;
template <int... F>
struct Splits<std::integer_sequence<int, F...>> {
    static void check() { (check_split<F>(), ...); }
};

TEST(Checked, TellsWhatLeavesTheRangeInEverySplitOf8Bits) {
    Splits<std::make_integer_sequence<int, 8>>::check();
}

TEST(Checked, TellsOfFloatsThatAreNoNumberOrTooLarge) {
    using Op = fixedpoint::Operation;
    using Number = Fixed<16, 16, Checked<Hook>>;
    expect(domain_error, Op::from_float, [] { (void)from_float<Number>(std::nan("")); });
    expect(overflow_unless(false), Op::from_float, [] { (void)from_float<Number>(-INFINITY); });
    expect(overflow_unless(false), Op::from_float, [] { (void)from_float<Number>(1e30f); });
    expect(nothing, Op::from_float, [] { (void)from_float_checked<Number>(1e30f); });
}

// Wider formats: the predicates beside exact arithmetic, where the answer changes.
struct Ranges {
    exact::Format format;
    int64_t exp_limit, log_limit;
    bool (*cos_fits)(int64_t);
    bool (*reciprocal_sqrt_fits)(int64_t);
    bool (*atan2_fits)(int64_t, int64_t);
    bool (*normalised_fits)(const int64_t*);
};
template <class Raw, int F>
constexpr Ranges ranges = {
    {RawLimits<Raw>::width, F},
    portable::exp_limit<Raw, F>(),
    portable::log_limit<Raw, F>(),
    [](int64_t a) { return portable::cos_fits<Raw, F>(Raw(a)); },
    [](int64_t a) { return portable::reciprocal_sqrt_fits<Raw, F>(Raw(a)); },
    [](int64_t y, int64_t x) { return portable::atan2_fits<Raw, F>(Raw(y), Raw(x)); },
    [](const int64_t* v) {
        const Raw raw[3] = {Raw(v[0]), Raw(v[1]), Raw(v[2])};
        return portable::normalised_fits<Raw, F>(raw, 0);
    }};
template <class Raw, int... F>
std::vector<Ranges> every_split(std::integer_sequence<int, F...>) {
    return {ranges<Raw, F>...};
}

class CheckedRange : public testing::TestWithParam<int> {
  protected:
    static std::vector<Ranges> splits() {
        if (GetParam() == 16) return every_split<int16_t>(std::make_integer_sequence<int, 16>{});
        if (GetParam() == 32) return every_split<int32_t>(std::make_integer_sequence<int, 32>{});
        return every_split<int64_t>(std::make_integer_sequence<int, 64>{});
    }
};

TEST_P(CheckedRange, ExpAndLogChangeAtTheirLimits) {
    for (const Ranges& split : splits()) {
        SCOPED_TRACE(split.format.fraction);
        EXPECT_FALSE(exact::function(Function::exp, split.exp_limit, split.format).fits);
        EXPECT_TRUE(exact::function(Function::exp, split.exp_limit - 1, split.format).fits);
        EXPECT_TRUE(exact::function(Function::log, split.log_limit + 1, split.format).fits);
        if (split.log_limit > 0) {
            EXPECT_FALSE(exact::function(Function::log, split.log_limit, split.format).fits);
        }
    }
}

TEST_P(CheckedRange, CosAndReciprocalSqrt) {
    const int width = GetParam();
    std::vector<int64_t> operands;
    for (int bit = 0; bit < width - 1; ++bit) {
        for (int offset = -2; offset <= 2; ++offset)
            operands.push_back((int64_t(1) << bit) + offset);
    }
    const auto root = static_cast<int64_t>(std::sqrt(std::ldexp(1.0L, width - 1)));
    for (int64_t a = root - 2; a <= root + 2; ++a) operands.insert(operands.end(), {a, -a});
    for (const Ranges& split : splits()) {
        SCOPED_TRACE(split.format.fraction);
        for (const int64_t a : operands) {
            if (split.format.fraction >= width - 2) {
                ASSERT_EQ(split.cos_fits(a), exact::function(Function::cos, a, split.format).fits)
                    << a;
            }
            if (a > 0) {
                ASSERT_EQ(split.reciprocal_sqrt_fits(a),
                          exact::function(Function::reciprocal_sqrt, a, split.format).fits)
                    << a;
            }
        }
    }
}

TEST_P(CheckedRange, Atan2OnBothSidesOfTheLimit) {
    std::mt19937_64 random(4);
    for (const Ranges& split : splits()) {
        const int width = split.format.width, integer_bits = width - split.format.fraction;
        if (integer_bits > 3) continue;
        SCOPED_TRACE(split.format.fraction);
        for (int i = 0; i < 300; ++i) {
            const int64_t y = static_cast<int64_t>(random()) >> (64 - width);
            const long double at =
                y / std::tan(std::ldexp(1.0L, integer_bits - 1)) * (y < 0 ? -1 : 1);
            if (std::abs(at) > std::ldexp(0.99L, width - 1)) continue;
            for (int offset = -3; offset <= 3; ++offset) {
                // Of 64 bits the limit is known to 2^-61, a few units of x.
                const int64_t x = std::llround(at) + (width == 64 ? 16 * offset + 8 : offset);
                ASSERT_EQ(split.atan2_fits(y, x), exact::atan2(y, x, split.format).fits)
                    << y << " " << x;
            }
        }
        for (const int64_t y : {int64_t(0), int64_t(1), int64_t(-1)}) {
            for (const int64_t x : {int64_t(-1), int64_t(0), int64_t(1)}) {
                ASSERT_EQ(split.atan2_fits(y, x), exact::atan2(y, x, split.format).fits);
            }
        }
    }
}

TEST_P(CheckedRange, NormaliseOnBothSidesOfTheLimit) {
    std::mt19937_64 random(5);
    const Ranges split = splits().back();  // one integer bit
    const int width = GetParam();
    for (int i = 0; i < 2000; ++i) {
        const int64_t x = static_cast<int64_t>(random() >> (65 - width));
        // v_y^2 is about 2 x^2 / 2^F.
        const auto y = static_cast<int64_t>(
            std::llround(std::sqrt(2.0L * x) * std::sqrt(std::ldexp((long double)x, -width))));
        for (int64_t offset = -2; offset <= 2; ++offset) {
            const int64_t v[3] = {x, y + offset, static_cast<int64_t>(random() % 3)};
            ASSERT_EQ(split.normalised_fits(v), exact::normalised(v, 0, split.format).fits)
                << v[0] << " " << v[1] << " " << v[2];
        }
    }
    const int64_t least[3] = {exact::smallest(width), 0, 0};
    EXPECT_TRUE(split.normalised_fits(least));
}

INSTANTIATE_TEST_SUITE_P(Widths, CheckedRange, testing::Values(16, 32, 64));

}  // namespace
