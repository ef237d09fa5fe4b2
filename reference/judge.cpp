// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "reference/exact.hpp"
#include "reference/function.hpp"

namespace reference {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The integer that the rounding requires for an exact result x (in ulp).
template <class Number>
Number rounded(const Number& x, Rounding rounding) {
    switch (rounding) {
        case Rounding::nearest_even: {
            const Number below = floor(x);
            const Number rest = x - below;
            const bool even = floor(scale(below, -1)) * 2 == below;
            const bool up = scale(rest, 1) > 1 || (scale(rest, 1) == 1 && !even);
            return up ? Number(below + 1) : below;
        }
        case Rounding::toward_zero:
            return x < 0 ? Number(-floor(Number(-x))) : floor(x);
        case Rounding::downward:
            return floor(x);
        case Rounding::nearest_half_up:
        case Rounding::within_bound:
            break;
    }
    return floor(Number(x + scale(Number(1), -1)));
}

// x reduced modulo 2^width to [-2^(width-1), 2^(width-1)).
template <class Number>
Number wrapped(const Number& x, int width) {
    const Number turns = floor(Number(scale(x, -width) + scale(Number(1), -1)));
    return x - scale(turns, width);
}

Judgement judge_pinned(const NumberFormat& format, std::int64_t pinned, std::int64_t result) {
    Judgement judgement{.defined = true};
    if (is_finite(format, pinned) && is_finite(format, result)) {
        const Rational target = value(format, pinned);
        const Rational error = (value(format, result) - target) / ulp(format, target);
        judgement.error_ulp = double(error);
        judgement.as_defined = error == 0;
    } else {
        judgement.as_defined =
            pinned == result || (is_nan(format, pinned) && is_nan(format, result));
        judgement.error_ulp = judgement.as_defined ? 0 : infinity;
    }
    return judgement;
}

// Judges a fixed-point or integer result against the exact value x, in ulp.
template <class Number>
Judgement judge_fixed(const NumberFormat& format, const Definition& definition, const Number& x,
                      std::int64_t result) {
    const Number target = rounded(x, definition.rounding);
    const bool above = target > Number(format.max()), below = target < Number(format.min());
    if (above || below) {
        if (definition.overflow == Overflow::undefined)
            return {.excluded = "overflow is undefined here"};
        if (definition.overflow == Overflow::saturates)
            return judge_pinned(format, above ? format.max() : format.min(), result);
    }
    const bool wraps = definition.overflow == Overflow::wraps;
    const auto difference = [&](const Number& from) {
        const Number plain = Number(result) - from;
        return wraps ? wrapped(plain, format.width) : plain;
    };
    const Number error = difference(x);
    const double error_ulp = double(error);
    const bool as_defined = definition.rounding == Rounding::within_bound
                                ? std::abs(error_ulp) <= definition.bound_ulp
                                : difference(target) == 0;
    return {.error_ulp = error_ulp, .as_defined = as_defined};
}

// Judges an IEEE float. The ulp is that of the exact value's binade.
template <class Number>
Judgement judge_float(const NumberFormat& format, const Definition& definition, const Number& exact,
                      std::int64_t result) {
    const Number limit = scale(Number(1), format.infinity_exponent());
    const auto overflow = [&] {
        return judge_pinned(format, raw_of_double(format, exact < 0 ? -infinity : infinity),
                            result);
    };
    if (abs(exact) >= limit) return overflow();
    const int least = format.min_place();
    const int last_place =
        exact == 0 ? least : std::max(binade(exact) - (format.significand_bits() - 1), least);
    const Number x = scale(exact, -last_place);
    const Number target = rounded(x, Rounding::nearest_even);
    if (abs(scale(target, last_place)) >= limit) return overflow();
    if (!is_finite(format, result)) return {.error_ulp = infinity, .as_defined = false};
    const Number got =
        scale(Number(numerator(scale(value(format, result), -least))), least - last_place);
    const bool as_defined = definition.rounding == Rounding::within_bound || got == target;
    const auto error_ulp = double(Number(got - x));
    return {.error_ulp = error_ulp,
            .error = std::ldexp(std::abs(error_ulp), last_place),
            .as_defined = as_defined};
}

// The result of the host's C library for floats that are not finite or outside the domain; its
// special cases are those of C's Annex F. Called only for these.
template <class Float>
Float special_case(Operation operation, const Float* x) {
    switch (operation) {
        case Operation::add:
            return x[0] + x[1];
        case Operation::subtract:
            return x[0] - x[1];
        case Operation::multiply:
            return x[0] * x[1];
        case Operation::divide:
            return x[0] / x[1];
        case Operation::remainder:
            return std::fmod(x[0], x[1]);
        case Operation::negate:
            return -x[0];
        case Operation::abs:
            return std::fabs(x[0]);
        case Operation::convert:
            return x[0];
        case Operation::multiply_add:
            return x[0] * x[1] + x[2];
        case Operation::dot2:
            return x[0] * x[2] + x[1] * x[3];
        case Operation::dot3:
            return x[0] * x[3] + x[1] * x[4] + x[2] * x[5];
        default:
            return function(operation, x);
    }
}

// Adapts the operands to what the published arithmetic computes where it differs from the
// mathematical function.
void follow_published(Operation operation, std::span<Rational> x) {
    if (operation == Operation::atan) x[0] = x[0] < 0 ? Rational(0) : x[0] > 1 ? Rational(1) : x[0];
}
Exact published_angle(const Exact& angle) {
    const Real& principal = std::get<Real>(angle);
    return principal < 0 ? Real(principal + 2 * pi()) : principal;
}

class Judge {
  public:
    Judge(const Subject& subject, std::span<const std::int64_t> operands)
        : subject_(subject), definition_(definition(subject)), operands_(operands) {
        finite_ = true;
        for (std::size_t i = 0; i < operands.size(); ++i)
            finite_ &= is_finite(operand_format(i), operands[i]);
        if (!finite_) return;
        for (std::size_t i = 0; i < operands.size(); ++i)
            values_.push_back(value(operand_format(i), operands[i]));
        if (subject.arithmetic == Arithmetic::published)
            follow_published(subject.operation, values_);
    }

    Judgement component(std::size_t index, std::int64_t result) const {
        if (subject_.operand_format.is_float()) {
            if (!subject_.format.is_float()) return from_float(result);
            if (!finite_ || !in_domain_of_operation()) return special(result);
        } else if (!in_domain_of_operation()) {
            if (subject_.arithmetic == Arithmetic::integer ||
                subject_.arithmetic == Arithmetic::accum)
                return {.excluded = "undefined outside the operation's domain"};
            return judge_pinned(
                subject_.format,
                outside_domain(subject_.operation, subject_.format, operands_[0], index), result);
        }
        return against(exact_value(index), result);
    }

  private:
    bool in_domain_of_operation() const {
        if (!subject_.operand_format.is_float())
            return in_domain(subject_.operation, operands_, raw_one(subject_.operand_format));
        double numbers[max_operands];
        for (std::size_t i = 0; i < operands_.size(); ++i)
            numbers[i] = to_double(subject_.operand_format, operands_[i]);
        return in_domain(subject_.operation, std::span<const double>(numbers, operands_.size()),
                         1.0);
    }

    NumberFormat operand_format(std::size_t index) const {
        if (takes_integer(subject_.operation, index) && !subject_.operand_format.is_float())
            return {FormatKind::integer, 64, 0};
        return subject_.operand_format;
    }

    Exact exact_value(std::size_t index) const {
        const Exact result = exact(subject_.operation, values_, index);
        if (gives_integer(subject_.operation) && index == 0)
            return scale(std::get<Rational>(result), -subject_.format.fraction);
        if (subject_.operation != Operation::atan2) return result;
        if (subject_.arithmetic == Arithmetic::published) return published_angle(result);
        const bool minus_zero = subject_.format.is_float() && values_[0] == 0 && operands_[0] != 0;
        return minus_zero ? Exact(Real(-std::get<Real>(result))) : result;
    }

    Judgement against(const Exact& exact, std::int64_t result) const {
        return std::visit(
            [&](const auto& number) {
                if (subject_.format.is_float())
                    return judge_float(subject_.format, definition_, number, result);
                const auto in_ulp = scale(number, subject_.format.fraction);
                Judgement judgement = judge_fixed(subject_.format, definition_, in_ulp, result);
                judgement.error =
                    std::ldexp(std::abs(judgement.error_ulp), -subject_.format.fraction);
                judgement.underflow = vanishes(subject_.operation) && abs(in_ulp) * 2 < 1;
                return judgement;
            },
            exact);
    }

    Judgement from_float(std::int64_t result) const {
        if (finite_) return against(values_[0], result);
        if (definition_.overflow == Overflow::undefined)
            return {.excluded = "overflow is undefined here"};
        const double number = to_double(subject_.operand_format, operands_[0]);
        const std::int64_t pinned = std::isnan(number) ? 0
                                    : number > 0       ? subject_.format.max()
                                                       : subject_.format.min();
        return judge_pinned(subject_.format, pinned, result);
    }

    Judgement special(std::int64_t result) const {
        if (is_auxiliary(subject_.operation))
            return {.excluded = "C defines no special cases for this operation"};
        if (vector_operands(subject_.operation) == 1)
            return {.excluded = "a vector function of floats that are not finite, or all zero"};
        // Sine and cosine of a number that is not finite are the same NaN.
        const Operation operation =
            subject_.operation == Operation::sincos ? Operation::sin : subject_.operation;
        return subject_.operand_format.width == 32 ? special_as<float>(operation, result)
                                                   : special_as<double>(operation, result);
    }

    template <class Float>
    Judgement special_as(Operation operation, std::int64_t result) const {
        Float numbers[max_operands] = {};
        for (std::size_t i = 0; i < operands_.size(); ++i)
            numbers[i] = Float(to_double(subject_.operand_format, operands_[i]));
        const Float pinned = special_case(operation, numbers);
        return judge_pinned(subject_.format, raw_of_double(subject_.format, pinned), result);
    }

    const Subject& subject_;
    const Definition definition_;
    const std::span<const std::int64_t> operands_;
    bool finite_;
    std::vector<Rational> values_;
};

}  // namespace

Judgement judge(const Subject& subject, std::span<const std::int64_t> operands,
                std::span<const std::int64_t> results) {
    const OperationShape& expected = shape(subject.operation);
    if (operands.size() != expected.operands || results.size() != expected.results) {
        throw std::invalid_argument(
            fmt::format("{} takes {} operands and gives {} results, not {} and {}", expected.name,
                        expected.operands, expected.results, operands.size(), results.size()));
    }
    const Judge of_operands(subject, operands);
    Judgement worst = of_operands.component(0, results[0]);
    for (std::size_t i = 1; i < results.size(); ++i) {
        const Judgement other = of_operands.component(i, results[i]);
        if (std::abs(other.error_ulp) > std::abs(worst.error_ulp))
            worst.error_ulp = other.error_ulp;
        worst.error = std::max(worst.error, other.error);
        worst.as_defined &= other.as_defined;
        worst.defined &= other.defined;
        worst.underflow &= other.underflow;
        if (other.excluded) worst.excluded = other.excluded;
    }
    return worst;
}

}  // namespace reference
