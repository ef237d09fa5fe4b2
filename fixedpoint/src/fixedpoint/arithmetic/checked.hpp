// SPDX-License-Identifier: MIT
// Checked<Hook>: returns what Nearest returns, and calls Hook::notify(event, operation) first where
// the result is not the rounded exact one: on overflow, division by zero and domain errors of the
// operations named below. Dot products, lengths and the other functions are not watched.
#pragma once

#include <fixedpoint/arithmetic/saturating.hpp>

namespace fixedpoint {

enum class Event : unsigned char { overflow, division_by_zero, domain_error };

enum class Operation : unsigned char {
    add,
    subtract,
    negate,
    multiply,
    divide,
    remainder,
    shift_left,
    convert,
    sqrt,
    reciprocal_sqrt,
    log,
};

template <class Hook>
struct Checked : Nearest {
    template <class Raw, int F>
    static constexpr Raw add(Raw a, Raw b) {
        return wrapped<Raw>(Nearest::add<Raw, F>(a, b), Saturating::add<Raw, F>(a, b),
                            Operation::add);
    }
    template <class Raw, int F>
    static constexpr Raw subtract(Raw a, Raw b) {
        return wrapped<Raw>(Nearest::subtract<Raw, F>(a, b), Saturating::subtract<Raw, F>(a, b),
                            Operation::subtract);
    }
    template <class Raw, int F>
    static constexpr Raw negate(Raw a) {
        return wrapped<Raw>(Nearest::negate<Raw, F>(a), Saturating::negate<Raw, F>(a),
                            Operation::negate);
    }
    template <class Raw, int F>
    static constexpr Raw multiply(Raw a, Raw b) {
        const Raw result = Nearest::multiply<Raw, F>(a, b);
        const Raw clamped = Saturating::multiply<Raw, F>(a, b);
        // Comparing the two would miss a product that wraps all the way round to its limit.
        if ((clamped == raw_max<Raw> || clamped == raw_min<Raw>)&&product_exceeds<Raw, F>(
                a, b, clamped)) {
            Hook::notify(Event::overflow, Operation::multiply);
        }
        return result;
    }
    template <class Raw, int F>
    static constexpr Raw divide(Raw a, Raw b) {
        const Raw result = Nearest::divide<Raw, F>(a, b);
        if (b == 0) {
            Hook::notify(Event::division_by_zero, Operation::divide);
        } else if ((result == raw_max<Raw> || result == raw_min<Raw>)&&quotient_exceeds<Raw, F>(
                       a, b, result)) {
            Hook::notify(Event::overflow, Operation::divide);
        }
        return result;
    }
    template <class Raw, int F>
    static constexpr Raw remainder(Raw a, Raw b) {
        if (b == 0) Hook::notify(Event::division_by_zero, Operation::remainder);
        return Nearest::remainder<Raw, F>(a, b);
    }
    template <class Raw, int F>
    static constexpr Raw shift_left(Raw a, unsigned char count) {
        return wrapped<Raw>(Nearest::shift_left<Raw, F>(a, count),
                            Saturating::shift_left<Raw, F>(a, count), Operation::shift_left);
    }
    template <class Raw, int F, class FromRaw, int FromF>
    static constexpr Raw convert(FromRaw a) {
        if (!portable::convert_clamped<Raw, F, FromRaw, FromF>(a).fits) {
            Hook::notify(Event::overflow, Operation::convert);
        }
        return Nearest::convert<Raw, F, FromRaw, FromF>(a);
    }
    template <class Raw, int F>
    static constexpr Raw sqrt(Raw a) {
        if (a < 0) Hook::notify(Event::domain_error, Operation::sqrt);
        return Nearest::sqrt<Raw, F>(a);
    }
    template <class Raw, int F>
    static constexpr Raw reciprocal_sqrt(Raw a) {
        if (a < 0) Hook::notify(Event::domain_error, Operation::reciprocal_sqrt);
        if (a == 0) Hook::notify(Event::division_by_zero, Operation::reciprocal_sqrt);
        return Nearest::reciprocal_sqrt<Raw, F>(a);
    }
    template <class Raw, int F>
    static constexpr Raw log(Raw a) {
        if (a <= 0) Hook::notify(Event::domain_error, Operation::log);
        return Nearest::log<Raw, F>(a);
    }

  private:
    template <class Raw>
    static constexpr Raw wrapped(Raw result, Raw clamped, Operation operation) {
        if (result != clamped) Hook::notify(Event::overflow, operation);
        return result;
    }

    // Whether |numerator| 2^shift lies more than half of |unit| beyond |limit| |unit| (by half
    // itself only where the result is positive, since ties go upward).
    static constexpr bool beyond(portable::Wide128 value, portable::Wide128 limit, uint64_t half,
                                 bool tie_counts) {
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
    static constexpr bool product_exceeds(Raw a, Raw b, Raw limit) {
        // a b against limit 2^F, in units of 1: half an ulp is 2^(F-1).
        if (F == 0) {
            return beyond(portable::multiply_full(magnitude<int64_t>(a), magnitude<int64_t>(b)),
                          shifted(magnitude<int64_t>(limit), 0), 0, false);
        }
        return beyond(portable::multiply_full(magnitude<int64_t>(a), magnitude<int64_t>(b)),
                      shifted(magnitude<int64_t>(limit), F), (uint64_t(1) << F) >> 1, limit > 0);
    }
    template <class Raw, int F>
    static constexpr bool quotient_exceeds(Raw a, Raw b, Raw limit) {
        // a 2^F against limit b; half an ulp is |b| / 2, a tie only where b is even.
        const uint64_t divisor = magnitude<int64_t>(b);
        return beyond(shifted(magnitude<int64_t>(a), F),
                      portable::multiply_full(magnitude<int64_t>(limit), divisor),
                      (divisor + 1) >> 1, limit > 0 || (divisor & 1) != 0);
    }
};

}  // namespace fixedpoint
