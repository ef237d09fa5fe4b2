// SPDX-License-Identifier: MIT
// Checked notifies its hook exactly when the exact result, rounded, is out of range or does not
// exist: every operation, every split of 8 bits, every operand.
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

// How often each event except underflow was reported, and the operation of the last one.
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
        for (int b = -128; b < 128; b += exact::operand_step) check_binary<F>(a, b);
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

// The magnitude of the product of these raw numbers is that of the limit, 2^95, plus 2^64: the
// lower 64-bit words are equal.
TEST(Checked, TellsOfProductsThatAreBeyondTheLimitInTheirUpperWordAlone) {
    using Number = Fixed<32, 32, Checked<Hook>>;
    const int64_t b = -((int64_t(1) << 62) + (int64_t(1) << 31));
    const auto product = [&](int64_t a) {
        return [=] { (void)(Number::from_raw(a) * Number::from_raw(b)); };
    };
    expect(overflow_unless(false), fixedpoint::Operation::multiply, product(int64_t(1) << 33));
    expect(nothing, fixedpoint::Operation::multiply, product(int64_t(1) << 32));
}

// Powers at and beyond the limits of the range: the result of the kernel is unsigned.
TEST(Checked, TellsOfPowersBeyondTheEndsOfQ32_32) {
    using Number = Fixed<32, 32, Checked<Hook>>;
    constexpr int64_t one = int64_t(1) << 32, largest = std::numeric_limits<int64_t>::max();
    const auto power = [](int64_t x, int64_t y) {
        return [=] { (void)pow(Number::from_raw(x), Number::from_raw(y)); };
    };
    expect(nothing, fixedpoint::Operation::pow, power(largest, one));
    expect(nothing, fixedpoint::Operation::pow, power(-2 * one, 31 * one));
    expect(overflow_unless(false), fixedpoint::Operation::pow, power(2 * one, 31 * one));
    expect(overflow_unless(false), fixedpoint::Operation::pow, power(-2 * one, 33 * one));
}

TEST(Checked, TellsOfFloatsThatAreNoNumberOrTooLarge) {
    using Op = fixedpoint::Operation;
    using Number = Fixed<16, 16, Checked<Hook>>;
    expect(domain_error, Op::from_float, [] { (void)from_float<Number>(std::nan("")); });
    expect(overflow_unless(false), Op::from_float, [] { (void)from_float<Number>(-INFINITY); });
    expect(overflow_unless(false), Op::from_float, [] { (void)from_float<Number>(1e30f); });
    expect(nothing, Op::from_float, [] { (void)from_float_checked<Number>(1e30f); });
}

}  // namespace
