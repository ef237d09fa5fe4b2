// SPDX-License-Identifier: GPL-3.0-or-later
// The fast judge against the exact one, on boundary and random operands with results at, next to
// and far from the right one.
#include "reference/bulk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "reference/judge.hpp"

namespace reference {
namespace {

std::vector<std::int64_t> boundary(const NumberFormat& format) {
    std::vector<std::int64_t> raws = {0, format.min(), format.min() + 1, format.max(),
                                      format.max() - 1};
    for (int bit = 0; bit < format.width - 1; ++bit) {
        for (const std::int64_t step : {-1, 0, 1}) {
            raws.push_back((std::int64_t(1) << bit) + step);
            raws.push_back(-(std::int64_t(1) << bit) + step);
        }
    }
    for (std::int64_t& raw : raws) raw = format.extend(std::uint64_t(raw));
    return raws;
}

class Operands {
  public:
    explicit Operands(const NumberFormat& format) : format_(format), boundary_(boundary(format)) {}

    std::int64_t next() {
        const std::uint64_t pattern = random_();
        switch (pattern % 4) {
            case 0:
                return boundary_[(pattern >> 8) % boundary_.size()];
            case 1:
                return format_.extend(random_());
            // Uniform in length, so that small raws are drawn, too.
            default:
                return format_.extend(random_()) >> ((pattern >> 8) % format_.width);
        }
    }

  private:
    NumberFormat format_;
    std::vector<std::int64_t> boundary_;
    std::mt19937_64 random_{7};
};

// The exact value of one of several results, in ulp.
long double component(const Subject& subject, std::span<const std::int64_t> v, std::size_t index) {
    const auto scale = [&](long double x, int sign) {
        return std::ldexp(x, sign * subject.format.fraction);
    };
    if (gives_integer_quotient(subject.operation)) {
        if (v[1] == 0) return static_cast<long double>(v[0]);
        // Of 128 bits, since MIN / -1 does not fit.
        const __int128 a = v[0], b = v[1];
        const bool down =
            subject.operation == Operation::divmod && a % b != 0 && (a % b < 0) != (b < 0);
        return static_cast<long double>(index == 0 ? a / b - (down ? 1 : 0)
                                                   : a % b + (down ? b : 0));
    }
    const long double tau = 8 * std::atan(1.0L);
    const long double unit = subject.operation == Operation::sincos           ? 1
                             : subject.operation == Operation::sincos_turns   ? tau
                             : subject.operation == Operation::sincos_degrees ? tau / 360
                                                                              : 0;
    if (unit != 0) {
        const long double angle = scale(v[0], -1) * unit;
        return scale(index == 0 ? std::sin(angle) : std::cos(angle), 1);
    }
    long double square = 0;
    for (const std::int64_t each : v) square += (long double)(each)*each;
    return square == 0 ? 0 : scale(v[index] / std::sqrt(square), 1);
}

// A result that is right or slightly wrong, wherever the exact value lies.
std::int64_t plausible(const Subject& subject, std::span<const std::int64_t> operands,
                       std::size_t index, std::int64_t step) {
    // The judge's own error for the result 0 leads to the right one modulo 2^W, as far as double is
    // exact.
    std::vector<std::int64_t> results(shape(subject.operation).results, 0);
    if (results.size() > 1) {
        const long double x = component(subject, operands, index);
        return std::clamp(std::int64_t(std::floor(x)), subject.format.min() + 2,
                          subject.format.max() - 2) +
               step;
    }
    std::int64_t result = 0;
    for (int round = 0; round < 3; ++round) {
        const Judgement judgement = judge(subject, operands, result);
        if (judgement.excluded) break;
        result = subject.format.extend(std::uint64_t(result) -
                                       std::uint64_t(__int128(std::floor(judgement.error_ulp))));
    }
    return subject.format.extend(std::uint64_t(result) + std::uint64_t(step));
}

// A sanitizer checks paths and not results, so fewer operands suffice. The step is odd, so that
// every kind of result, which depends on the round modulo 8, still occurs.
#ifdef SPARSE_OPERANDS
constexpr int round_step = 7;
#else
constexpr int round_step = 1;
#endif

using FastJudge = Judgement(std::span<const std::int64_t>, std::span<const std::int64_t>);

void compare(const Subject& subject, FastJudge* fast_judge, int rounds) {
    SCOPED_TRACE(std::string(shape(subject.operation).name) + " " + format_name(subject.format) +
                 " arithmetic " + std::to_string(int(subject.arithmetic)));
    Operands source(subject.operand_format);
    int right = 0, wrong = 0;
    for (int i = 0; i < rounds; i += round_step) {
        std::int64_t operands[max_operands], results[max_results];
        const OperationShape& of = shape(subject.operation);
        const std::span operand_span(operands, of.operands), result_span(results, of.results);
        for (std::int64_t& operand : operand_span) operand = source.next();
        for (std::size_t k = 0; k < of.results; ++k)
            results[k] = i % 8 == 7 ? subject.format.extend(std::uint64_t(source.next()))
                                    : plausible(subject, operand_span, k, i % 4 - 1);
        const Judgement expected = judge(subject, operand_span, result_span);
        const Judgement got = fast_judge(operand_span, result_span);
        ASSERT_EQ(got.excluded == nullptr, expected.excluded == nullptr)
            << operands[0] << " " << operands[1];
        if (expected.excluded) continue;
        // Of several results the largest error counts; two of equal size may differ in sign.
        const auto size = [&](double error) { return of.results > 1 ? std::abs(error) : error; };
        ASSERT_NEAR(size(got.error_ulp), size(expected.error_ulp),
                    1e-4 + 1e-12 * std::abs(expected.error_ulp))
            << operands[0] << " " << operands[1] << " -> " << results[0];
        ASSERT_EQ(got.defined, expected.defined) << operands[0] << " " << operands[1];
        ASSERT_EQ(got.underflow, expected.underflow) << operands[0] << " " << operands[1];
        // Where a bound is met to the last bit, the fast judge may decide either way.
        const bool on_bound =
            definition(subject).rounding == Rounding::within_bound &&
            std::abs(std::abs(expected.error_ulp) - definition(subject).bound_ulp) < 1e-4;
        ASSERT_TRUE(on_bound || got.as_defined == expected.as_defined)
            << operands[0] << " " << operands[1] << " -> " << results[0] << " error "
            << expected.error_ulp;
        right += expected.as_defined;
        wrong += !expected.as_defined;
    }
    EXPECT_GT(right, rounds / round_step / 20);  // both verdicts have been compared
    if (definition(subject).bound_ulp != no_bound) {
        EXPECT_GT(wrong, rounds / round_step / 20);
    }
}

template <Subject subject>
void compare(int rounds) {
    compare(subject, bulk::judge<subject>, rounds);
}

template <NumberFormat format, Arithmetic arithmetic, Operation... operation>
void compare_all(int rounds) {
    (compare<Subject{operation, format, arithmetic}>(rounds), ...);
}

// In the default arithmetic. The fast judge has no shifts, and no exp of 64 bits.
template <NumberFormat format, Operation operation>
void compare_default(int rounds) {
    constexpr bool is_judged = operation != Operation::convert && !is_shift(operation) &&
                               !(operation == Operation::exp && format.width > 32);
    // Between -1 and 1 degrees the cosine rounds to 1, which such a format cannot hold.
    constexpr bool saturates =
        operation == Operation::sincos_degrees && format.width - format.fraction == 1;
    if constexpr (is_judged && !saturates)
        compare<Subject{operation, format, Arithmetic::nearest}>(rounds);
}

template <NumberFormat format>
void compare_arithmetics(int rounds) {
    using enum Operation;
#define COMPARE(name, ...) compare_default<format, Operation::name>(rounds);
    OPERATIONS(COMPARE)
#undef COMPARE
    compare_all<format, Arithmetic::published, add, subtract, multiply, divide, Operation::sqrt,
                Operation::atan, Operation::atan2>(rounds);
    compare_all<format, Arithmetic::saturating, add, subtract, multiply, negate, Operation::abs,
                multiply_add, divide>(rounds);
    compare_all<format, Arithmetic::toward_zero, multiply, divide>(rounds);
    compare_all<format, Arithmetic::downward, multiply, divide>(rounds);
    compare_all<format, Arithmetic::half_to_even, multiply, divide>(rounds);
    if constexpr (format.width <= 32)
        compare_all<format, Arithmetic::correctly_rounded, Operation::exp, Operation::log,
                    Operation::sin, sincos, Operation::atan2, reciprocal_sqrt>(rounds);
}

TEST(Bulk, AgreesInQ4_4) { compare_arithmetics<q4_4>(1000); }
TEST(Bulk, AgreesInQ8_8) { compare_arithmetics<q8_8>(1000); }
TEST(Bulk, AgreesInQ16_16) { compare_arithmetics<q16_16>(1000); }
TEST(Bulk, AgreesInQ32_32) { compare_arithmetics<q32_32>(1000); }
TEST(Bulk, AgreesInQ1_31) { compare_arithmetics<fixed_format(1, 31)>(1000); }
TEST(Bulk, AgreesInQ16_0) { compare_arithmetics<fixed_format(16, 0)>(1000); }
#ifndef SPARSE_OPERANDS  // the other formats take the same paths
TEST(Bulk, AgreesInQ1_15) { compare_arithmetics<fixed_format(1, 15)>(1000); }
TEST(Bulk, AgreesInQ8_24) { compare_arithmetics<fixed_format(8, 24)>(1000); }
#endif

template <NumberFormat format>
void compare_without_sign(int rounds) {
    using enum Operation;
    compare_all<format, Arithmetic::nearest, add, subtract, multiply, divide, remainder, negate,
                multiply_add, Operation::sqrt, divrem, divmod, Operation::lerp, Operation::midpoint,
                abs_diff>(rounds);
    compare_all<format, Arithmetic::saturating, add, subtract, multiply, multiply_add, divide>(
        rounds);
}
TEST(Bulk, AgreesWithoutSign) {
    compare_without_sign<unsigned_format(8, 8)>(1000);
    compare_without_sign<unsigned_format(16, 16)>(1000);
    compare_without_sign<unsigned_format(0, 16)>(1000);
}

// The exact value lies 2^-28 ulp below a tie; in double it is the tie.
TEST(Bulk, DecidesTheSideOfATie) {
    constexpr Subject subject{Operation::sin, fixed_format(1, 31), Arithmetic::correctly_rounded};
    const std::int64_t angle = -1422477815;
    const auto below = static_cast<std::int64_t>(
        std::floor(std::ldexp(std::sin(std::ldexp(double(angle), -31)), 31)));
    EXPECT_TRUE(bulk::judge<subject>(std::span(&angle, 1), below).as_defined);
    EXPECT_FALSE(bulk::judge<subject>(std::span(&angle, 1), below + 1).as_defined);
}

TEST(Bulk, AgreesOnIntegers) {
    using enum Operation;
    constexpr NumberFormat int16{FormatKind::integer, 16, 0}, int64{FormatKind::integer, 64, 0};
    compare_all<int16, Arithmetic::integer, add, subtract, multiply, divide, remainder>(2000);
    compare_all<int64, Arithmetic::integer, add, subtract, multiply, divide, remainder>(2000);
}

TEST(Bulk, AgreesOnConversions) {
    compare<Subject{Operation::convert, q8_8, Arithmetic::nearest, q16_16}>(4000);
    compare<Subject{Operation::convert, q8_8, Arithmetic::saturating, q32_32}>(4000);
    compare<Subject{Operation::convert, q32_32, Arithmetic::nearest, q8_8}>(4000);
    compare<Subject{Operation::convert, q4_4, Arithmetic::published, q16_16}>(4000);
}

}  // namespace
}  // namespace reference
