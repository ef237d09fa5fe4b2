// SPDX-License-Identifier: MIT
/// \file
/// Checked<Hook>: returns what Nearest returns, but first calls Hook::notify(event, operation) if
/// the exact result, rounded, is out of range (overflow), if there is no exact result (division by
/// zero, domain error), and if a product or quotient other than 0 is rounded to 0 (underflow).
/// Operations that are not listed below have a result in range for every operand. parse and the
/// conversions named _checked return a status instead and do not notify.
#pragma once

#include <fixedpoint/arithmetic/saturating.hpp>

namespace fixedpoint {

/// As Nearest, and reports to Hook::notify(Event, Operation) each result that is not the exact one,
/// rounded.
template <class Hook>
struct Checked : Nearest {
    /// a + b mod 2^W; notifies of overflow.
    template <class Raw, int F>
    static constexpr Raw add(Raw a, Raw b) {
        return wrapped<Raw>(Nearest::add<Raw, F>(a, b), Saturating::add<Raw, F>(a, b),
                            Operation::add);
    }
    /// a - b mod 2^W; notifies of overflow.
    template <class Raw, int F>
    static constexpr Raw subtract(Raw a, Raw b) {
        return wrapped<Raw>(Nearest::subtract<Raw, F>(a, b), Saturating::subtract<Raw, F>(a, b),
                            Operation::subtract);
    }
    /// -a mod 2^W; notifies of overflow if a is the smallest number.
    template <class Raw, int F>
    static constexpr Raw negate(Raw a) {
        return wrapped<Raw>(Nearest::negate<Raw, F>(a), Saturating::negate<Raw, F>(a),
                            Operation::negate);
    }
    /// a b rounded, mod 2^W; notifies of overflow, and of underflow if neither is 0 and the product
    /// is rounded to 0.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw multiply(Raw a, Raw b) {
        const Raw result = Nearest::multiply<Raw, F>(a, b);
        const Raw saturated = Saturating::multiply<Raw, F>(a, b);
        // Comparing result and saturated would miss a product that wraps all the way round to its
        // limit.
        if ((saturated == RawLimits<Raw>::max || saturated == RawLimits<Raw>::min) &&
            product_exceeds<Raw, F>(a, b, saturated)) {
            Hook::notify(Event::overflow, Operation::multiply);
        }
        watch_underflow(saturated == 0 && a != 0 && b != 0, Operation::multiply);
        return result;
    }
    /// a / b rounded, saturated; notifies of division by zero, overflow and underflow.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw divide(Raw a, Raw b) {
        const Raw result = Nearest::divide<Raw, F>(a, b);
        if (b == 0) {
            Hook::notify(Event::division_by_zero, Operation::divide);
        } else if ((result == RawLimits<Raw>::max || result == RawLimits<Raw>::min) &&
                   quotient_exceeds<Raw, F>(a, b, result)) {
            Hook::notify(Event::overflow, Operation::divide);
        }
        watch_underflow(result == 0 && a != 0, Operation::divide);
        return result;
    }
    /// As Nearest; notifies of division by zero.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw remainder(Raw a, Raw b) {
        if (b == 0) Hook::notify(Event::division_by_zero, Operation::remainder);
        return Nearest::remainder<Raw, F>(a, b);
    }
    /// `settle` needs more than the result mod 2^W.
    static constexpr bool settles = true;
    /// The result mod 2^W; notifies of overflow if the exact one is out of range.
    template <class Raw>
    static FIXEDPOINT_CONSTEXPR Raw settle(Raw wrapped, bool fits, bool, Operation operation) {
        watch_range(fits, operation);
        return wrapped;
    }
    /// The quotient; notifies of overflow and of division by zero.
    template <class Raw>
    static FIXEDPOINT_CONSTEXPR Raw settle_quotient(Raw quotient, Raw a, Raw b) {
        if (b == 0) Hook::notify(Event::division_by_zero, Operation::divide);
        watch_range(a != RawLimits<Raw>::min || !is_minus_one(b), Operation::divide);
        return quotient;
    }
    /// a 2^count mod 2^W; notifies of overflow.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw shift_left(Raw a, unsigned char count) {
        watch_range(portable::shift_left_fits(a, count), Operation::shift_left);
        return Nearest::shift_left<Raw, F>(a, count);
    }
    /// As Nearest; notifies of overflow.
    template <class Raw, int F, class FromRaw, int FromF>
    static FIXEDPOINT_CONSTEXPR Raw convert(FromRaw a) {
        watch_range(portable::convert_saturated<Raw, F, FromRaw, FromF>(a).fits,
                    Operation::convert);
        return Nearest::convert<Raw, F, FromRaw, FromF>(a);
    }
    /// As Nearest; notifies of a domain error if a < 0.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw sqrt(Raw a) {
        if (a < 0) Hook::notify(Event::domain_error, Operation::sqrt);
        return Nearest::sqrt<Raw, F>(a);
    }
    /// As Nearest; notifies of a domain error if a < 0, of division by zero if a = 0, and of
    /// overflow.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw reciprocal_sqrt(Raw a) {
        if (a < 0) Hook::notify(Event::domain_error, Operation::reciprocal_sqrt);
        if (a == 0) Hook::notify(Event::division_by_zero, Operation::reciprocal_sqrt);
        watch_range(a <= 0 || portable::reciprocal_sqrt_fits<Raw, F>(a),
                    Operation::reciprocal_sqrt);
        return Nearest::reciprocal_sqrt<Raw, F>(a);
    }
    /// As Nearest; notifies of a domain error if a <= 0, and of overflow.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw log(Raw a) {
        if (a <= 0) Hook::notify(Event::domain_error, Operation::log);
        watch_range(a <= 0 || portable::log_fits<Raw, F>(a), Operation::log);
        return Nearest::log<Raw, F>(a);
    }
    /// As Nearest; notifies of overflow.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw exp(Raw a) {
        watch_range(portable::exp_fits<Raw, F>(a), Operation::exp);
        return Nearest::exp<Raw, F>(a);
    }
    /// As Nearest; notifies of overflow, which occurs in formats that cannot represent pi.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw atan2(Raw y, Raw x) {
        watch_range(portable::atan2_fits<Raw, F>(y, x), Operation::atan2);
        return Nearest::atan2<Raw, F>(y, x);
    }
    /// As Nearest; notifies of overflow, which occurs in formats that cannot represent 1.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw cos(Raw angle) {
        watch_range(portable::cos_fits<Raw, F>(angle), Operation::cos);
        return Nearest::cos<Raw, F>(angle);
    }
    /// As Nearest; notifies of overflow of the cosine, once.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR void sincos(Raw angle, Raw* sine_and_cosine) {
        watch_range(portable::cos_fits<Raw, F>(angle), Operation::cos);
        Nearest::sincos<Raw, F>(angle, sine_and_cosine);
    }
    /// \cond internal The functions of portable/elementary_functions.hpp; their evaluation reports
    /// events.
#define FIXEDPOINT_ELEMENTARY_FUNCTION(name, Function)                                    \
    template <class Raw, int F, class... Operands>                                        \
    static FIXEDPOINT_CONSTEXPR Raw name(Operands... operands) {                          \
        return watched(portable::Evaluated<kernel::Function, Raw, F>::apply(operands...), \
                       Operation::name);                                                  \
    }
    FIXEDPOINT_ELEMENTARY_FUNCTIONS(FIXEDPOINT_ELEMENTARY_FUNCTION)
#undef FIXEDPOINT_ELEMENTARY_FUNCTION  /// \endcond
    /// As Nearest; notifies of overflow.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw ceil(Raw a) {
        watch_range(portable::integral_fits<Raw, F>(portable::integer_ceil<Raw, F>(a)),
                    Operation::ceil);
        return Nearest::ceil<Raw, F>(a);
    }
    /// As Nearest; notifies of overflow.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw round(Raw a) {
        watch_range(portable::integral_fits<Raw, F>(portable::integer_round<Raw, F>(a)),
                    Operation::round);
        return Nearest::round<Raw, F>(a);
    }
    /// As Nearest; notifies of overflow, and of a domain error if x is NaN.
    template <class Raw, int F, class Float>
    static FIXEDPOINT_CONSTEXPR Raw from_float(Float x) {
        if (x != x) Hook::notify(Event::domain_error, Operation::from_float);
        watch_range(x != x || portable::from_float<Raw, F>(x).fits, Operation::from_float);
        return Nearest::from_float<Raw, F>(x);
    }
    /// As Nearest; notifies of overflow.
    template <class Raw, int F, class Int>
    static FIXEDPOINT_CONSTEXPR Raw from_decimal(Int n, uint8_t decimals) {
        watch_range(portable::from_decimal<Raw, F>(n, decimals).fits, Operation::from_decimal);
        return Nearest::from_decimal<Raw, F>(n, decimals);
    }

    /// a b + c rounded once, mod 2^W; notifies of overflow, and of underflow of the product.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw multiply_add(Raw a, Raw b, Raw c) {
        const Raw result = Nearest::multiply_add<Raw, F>(a, b, c);
        const portable::DoubleWord<Raw> terms[2] = {portable::exact_product(a, b),
                                                    widened<Raw, F>(c)};
        watch_sum<Raw, F>(terms, 2, result, Operation::multiply_add);
        watch_underflow(a != 0 && b != 0 && Saturating::multiply<Raw, F>(a, b) == 0,
                        Operation::multiply_add);
        return result;
    }
    /// As Nearest; notifies of overflow of the sum.
    template <class Raw, int F>
    static constexpr Raw dot2(const Raw* a, const Raw* b) {
        return watched_dot<Raw, F>(a, b, 2, Nearest::dot2<Raw, F>(a, b));
    }
    /// As Nearest; notifies of overflow of the sum.
    template <class Raw, int F>
    static constexpr Raw dot3(const Raw* a, const Raw* b) {
        return watched_dot<Raw, F>(a, b, 3, Nearest::dot3<Raw, F>(a, b));
    }
    /// As Nearest; notifies of overflow.
    template <class Raw, int F>
    static constexpr Raw length2(const Raw* v) {
        return watched_length<Raw>(v, 2, Nearest::length2<Raw, F>(v));
    }
    /// As Nearest; notifies of overflow.
    template <class Raw, int F>
    static constexpr Raw length3(const Raw* v) {
        return watched_length<Raw>(v, 3, Nearest::length3<Raw, F>(v));
    }
    /// As Nearest; notifies of overflow, which occurs in formats that cannot represent 1: once,
    /// however many components are 1.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR void normalise3(const Raw* v, Raw* unit) {
        watch_range(portable::normalised_fits<Raw, F>(v, 0) &&
                        portable::normalised_fits<Raw, F>(v, 1) &&
                        portable::normalised_fits<Raw, F>(v, 2),
                    Operation::normalise);
        Nearest::normalise3<Raw, F>(v, unit);
    }
    /// As Nearest; notifies of underflow if a is not 0 and the result is.
    template <int K, class Raw>
    static FIXEDPOINT_CONSTEXPR Raw scale_down(Raw a) {
        const Raw result = Nearest::scale_down<K>(a);
        watch_underflow(result == 0 && a != 0, Operation::scale_down);
        return result;
    }

  private:
    template <class Raw>
    static FIXEDPOINT_CONSTEXPR Raw watched(portable::Evaluation<Raw> evaluation,
                                            Operation operation) {
        using portable::Outcome;
        if (evaluation.outcome != Outcome::in_range) {
            Hook::notify(evaluation.outcome == Outcome::overflow           ? Event::overflow
                         : evaluation.outcome == Outcome::division_by_zero ? Event::division_by_zero
                                                                           : Event::domain_error,
                         operation);
        }
        return evaluation.number;
    }
    static FIXEDPOINT_CONSTEXPR void watch_range(bool fits, Operation operation) {
        if (!fits) Hook::notify(Event::overflow, operation);
    }
    static FIXEDPOINT_CONSTEXPR void watch_underflow(bool vanished, Operation operation) {
        if (vanished) Hook::notify(Event::underflow, operation);
    }

    // c 2^F, in twice the width.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR portable::DoubleWord<Raw> widened(Raw c) {
        using Sum = portable::DoubleWord<Raw>;
        const Sum wide = static_cast<Sum>(static_cast<Sum>(portable::exact_product(c, Raw(1))));
        return static_cast<Sum>(wide << F);
    }
    // Notifies if the sum of up to three terms of 2W bits, divided by 2^F, is not the result. The
    // two differ by a multiple of 2^W if the sum overflowed and by at most 1/2 if it did not. A
    // quarter of each term is enough to distinguish the cases, and three quarters do not overflow
    // 2W bits.
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR void watch_sum(const portable::DoubleWord<Raw>* terms, int n,
                                               Raw result, Operation operation) {
        using Sum = portable::DoubleWord<Raw>;
        Sum difference = Sum(uint8_t(0));
        for (int i = 0; i < n; ++i) {
            difference = static_cast<Sum>(difference + quarter<Raw>(terms[i]));
        }
        difference = static_cast<Sum>(difference - quarter<Raw>(widened<Raw, F>(result)));
        const Sum most = static_cast<Sum>(Sum(uint8_t(1)) << (RawLimits<Raw>::width + F - 3));
        if (static_cast<Sum>(difference + most) >= static_cast<Sum>(most << 1)) {
            Hook::notify(Event::overflow, operation);
        }
    }
    // floor(a / 4) of a number of as many bits as a Sum, in two's complement if Raw is.
    template <class Raw>
    static FIXEDPOINT_CONSTEXPR portable::DoubleWord<Raw> quarter(portable::DoubleWord<Raw> a) {
        using Sum = portable::DoubleWord<Raw>;
        const Sum bias = static_cast<Sum>(Sum(uint8_t(RawLimits<Raw>::is_signed ? 1 : 0))
                                          << (8 * sizeof(Sum) - 1));
        return static_cast<Sum>(static_cast<Sum>(static_cast<Sum>(a + bias) >> 2) -
                                static_cast<Sum>(bias >> 2));
    }
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw watched_dot(const Raw* a, const Raw* b, int n, Raw result) {
        portable::DoubleWord<Raw> terms[3] = {};
        for (int i = 0; i < n; ++i) terms[i] = portable::exact_product(a[i], b[i]);
        watch_sum<Raw, F>(terms, n, result, Operation::dot);
        return result;
    }
    template <class Raw>
    static FIXEDPOINT_CONSTEXPR Raw watched_length(const Raw* v, int n, Raw result) {
        // The root rounds to more than the largest number if its square exceeds (max + 1/2)^2.
        const portable::DoubleWord<Raw> most = static_cast<portable::DoubleWord<Raw>>(
            portable::square(RawLimits<Raw>::max) +
            portable::DoubleWord<Raw>(magnitude(RawLimits<Raw>::max)));
        if (portable::sum_of_squares(v, n) > most) {
            Hook::notify(Event::overflow, Operation::length);
        }
        return result;
    }

    // Only for sums, which cannot wrap all the way round to the saturated result.
    template <class Raw>
    static FIXEDPOINT_CONSTEXPR Raw wrapped(Raw result, Raw saturated, Operation operation) {
        watch_range(result == saturated, operation);
        return result;
    }

    // Whether `value` exceeds `limit` by more than `half`, or by exactly `half` if `tie_counts`:
    // halves are rounded up, so a tie leaves the range only above it.
    static FIXEDPOINT_CONSTEXPR bool beyond(portable::Wide128 value, portable::Wide128 limit,
                                            uint64_t half, bool tie_counts) {
        const uint64_t low = value.low - limit.low;
        const uint64_t borrow = value.low < limit.low ? 1 : 0;
        if (value.high < limit.high || (value.high == limit.high && borrow != 0)) return false;
        const uint64_t high = value.high - limit.high - borrow;
        return high != 0 || (tie_counts ? low >= half : low > half);
    }
    static constexpr portable::Wide128 shifted(uint64_t value, int count) {
        return {count == 0 ? 0 : value >> (64 - count), value << count};
    }
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR bool product_exceeds(Raw a, Raw b, Raw limit) {
        // Compares |a b| with |limit| 2^F; half an ulp is 2^(F-1).
        if (F == 0) {
            return beyond(portable::multiply_full(magnitude(a), magnitude(b)),
                          shifted(magnitude(limit), 0), 0, false);
        }
        return beyond(portable::multiply_full(magnitude(a), magnitude(b)),
                      shifted(magnitude(limit), F), (uint64_t(1) << F) >> 1, limit > 0);
    }
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR bool quotient_exceeds(Raw a, Raw b, Raw limit) {
        // Compares |a| 2^F with |limit b|; half an ulp is |b| / 2, and a tie is possible only if b
        // is even.
        const uint64_t divisor = magnitude(b);
        return beyond(shifted(magnitude(a), F), portable::multiply_full(magnitude(limit), divisor),
                      (divisor >> 1) + (divisor & 1), limit > 0 || (divisor & 1) != 0);
    }
};

}  // namespace fixedpoint
