// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact.hpp"

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_sf_exp.h>
#include <gsl/gsl_sf_log.h>
#include <gsl/gsl_sf_trig.h>

#include <algorithm>
#include <cmath>

#include "reference/function.hpp"

namespace reference {
namespace {

Rational truncate(const Rational& x) { return x < 0 ? Rational(-floor(-x)) : floor(x); }

Rational dot(std::span<const Rational> a, std::span<const Rational> b) {
    Rational sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

Real length(std::span<const Rational> v) { return sqrt(to_real(dot(v, v))); }

// The exponent of a float's last place in the binade of x.
int last_place(const NumberFormat& format, const Rational& x) {
    const int least = format.min_place();
    return x == 0 ? least : std::max(binade(x) - format.significand_bits() + 1, least);
}

}  // namespace

Rational value(const NumberFormat& format, std::int64_t raw) {
    if (format.is_float()) {
        int exponent;
        const double significand = std::frexp(to_double(format, raw), &exponent);
        return scale(Rational(std::int64_t(std::ldexp(significand, 53))), exponent - 53);
    }
    return scale(Rational(raw), -format.fraction);
}

Rational ulp(const NumberFormat& format, const Rational& at) {
    return scale(Rational(1), format.is_float() ? last_place(format, at) : -format.fraction);
}

std::int64_t nearest_raw(const NumberFormat& format, const Rational& number) {
    if (number >= value(format, format.max())) return format.max();
    if (number <= value(format, format.min())) return format.min();
    const Rational scaled = number / ulp(format, number);
    Rational rounded = floor(scaled + Rational(1, 2));
    if (!format.is_float()) return std::int64_t(numerator(rounded));
    if (rounded - scaled == Rational(1, 2) && numerator(rounded) % 2 != 0) rounded -= 1;
    return raw_of_double(format,
                         std::ldexp(double(numerator(rounded)), last_place(format, number)));
}

const Real& pi() {
    static const Real value = 4 * atan(Real(1));
    return value;
}

Exact exact(Operation operation, std::span<const Rational> operands, std::size_t component) {
    const auto& x = operands;
    const auto real = [&](std::size_t i) { return to_real(x[i]); };
    switch (operation) {
        case Operation::add:
            return Rational(x[0] + x[1]);
        case Operation::subtract:
            return Rational(x[0] - x[1]);
        case Operation::multiply:
            return Rational(x[0] * x[1]);
        case Operation::divide:
            return Rational(x[0] / x[1]);
        case Operation::remainder:
            return Rational(x[0] - x[1] * truncate(x[0] / x[1]));
        case Operation::negate:
            return Rational(-x[0]);
        case Operation::abs:
            return Rational(abs(x[0]));
        case Operation::shift_left:
            return scale(x[0], int(numerator(x[1])));
        case Operation::shift_right:
            return scale(x[0], -int(numerator(x[1])));
        case Operation::convert:
            return x[0];
        case Operation::multiply_add:
            return Rational(x[0] * x[1] + x[2]);
        case Operation::dot2:
            return dot(x.subspan(0, 2), x.subspan(2, 2));
        case Operation::dot3:
            return dot(x.subspan(0, 3), x.subspan(3, 3));
        case Operation::sincos: {
            const Real angle = real(0);
            return function(component == 0 ? Operation::sin : Operation::cos, &angle);
        }
        case Operation::sincos_turns: {
            const Real angle = real(0);
            return function(component == 0 ? Operation::sin_turns : Operation::cos_turns, &angle);
        }
        case Operation::sincos_degrees: {
            const Real angle = real(0);
            return function(component == 0 ? Operation::sin_degrees : Operation::cos_degrees,
                            &angle);
        }
        case Operation::divrem:
        case Operation::divmod: {
            const Rational ratio = x[0] / x[1];
            const Rational quotient =
                operation == Operation::divrem ? truncate(ratio) : Rational(floor(ratio));
            return component == 0 ? quotient : Rational(x[0] - x[1] * quotient);
        }
        case Operation::lerp:
            return Rational(x[0] + (x[1] - x[0]) * x[2]);
        case Operation::smoothstep: {
            const Rational t = x[0] < 0 ? Rational(0) : x[0] > 1 ? Rational(1) : x[0];
            return Rational(t * t * (3 - 2 * t));
        }
        case Operation::midpoint:
            return Rational((x[0] + x[1]) / 2);
        case Operation::abs_diff:
            return Rational(abs(Rational(x[0] - x[1])));
        case Operation::copysign:
            return Rational(x[1] < 0 ? -abs(x[0]) : abs(x[0]));
        case Operation::sign:
            return Rational(x[0] < 0 ? -1 : x[0] > 0 ? 1 : 0);
        case Operation::isqrt:
            return Rational(sqrt(numerator(floor(x[0]))));
        case Operation::length2:
        case Operation::length3:
            return length(x);
        case Operation::normalise3:
            return Real(real(component) / length(x));
        default: {
            Real numbers[2];
            for (std::size_t i = 0; i < x.size(); ++i) numbers[i] = real(i);
            return function(operation, numbers);
        }
    }
}

std::optional<double> second_opinion(Operation operation, std::span<const double> operands) {
    const auto& x = operands;
    switch (operation) {
        case Operation::sqrt:
            return GSL_REAL(gsl_complex_sqrt_real(x[0]));
        case Operation::atan:
            return GSL_REAL(gsl_complex_arctan(gsl_complex_rect(x[0], 0)));
        case Operation::atan2:
            return gsl_complex_arg(gsl_complex_rect(x[1], x[0]));
        case Operation::sin:
            return gsl_sf_sin(x[0]);
        case Operation::cos:
            return gsl_sf_cos(x[0]);
        case Operation::exp:
            return gsl_sf_exp(x[0]);
        case Operation::log:
            return gsl_sf_log(x[0]);
        case Operation::tan:
            return GSL_REAL(gsl_complex_tan(gsl_complex_rect(x[0], 0)));
        case Operation::asin:
            return GSL_REAL(gsl_complex_arcsin_real(x[0]));
        case Operation::acos:
            return GSL_REAL(gsl_complex_arccos_real(x[0]));
        case Operation::expm1:
            return gsl_expm1(x[0]);
        case Operation::log1p:
            return gsl_log1p(x[0]);
        case Operation::sinh:
            return GSL_REAL(gsl_complex_sinh(gsl_complex_rect(x[0], 0)));
        case Operation::cosh:
            return GSL_REAL(gsl_complex_cosh(gsl_complex_rect(x[0], 0)));
        case Operation::tanh:
            return GSL_REAL(gsl_complex_tanh(gsl_complex_rect(x[0], 0)));
        case Operation::pow:
            return GSL_REAL(gsl_complex_pow_real(gsl_complex_rect(x[0], 0), x[1]));
        case Operation::length2:
            return gsl_sf_hypot(x[0], x[1]);
        default:
            return std::nullopt;
    }
}

}  // namespace reference
