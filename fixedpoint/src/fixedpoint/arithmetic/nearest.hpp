// SPDX-License-Identifier: MIT
// Nearest, the default arithmetic, on raw integers of W bits with F fraction bits.
//
// One rule for every operation and every input: the exact result is rounded to the nearest
// representable number, ties upward: floor(x + 1/2). The ring operations (+ - * negate, abs, shifts,
// dot, multiply_add) are then taken modulo 2^W, so that sums whose intermediates overflow still come
// out right. Everything else (division, square root, functions, lengths) clamps what does not fit,
// since a wrapped quotient would carry no information. Functions that are not correctly rounded
// state their bound where they are defined.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/kernel/atan.hpp>
#include <fixedpoint/kernel/atan2.hpp>
#include <fixedpoint/kernel/divide.hpp>
#include <fixedpoint/kernel/multiply.hpp>
#include <fixedpoint/kernel/sqrt.hpp>
#include <fixedpoint/portable/remainder.hpp>

namespace fixedpoint {

struct Nearest {
    // (a + b) mod 2^W.
    template <class Raw, int F>
    static constexpr Raw add(Raw a, Raw b) {
        return wrapping_add(a, b);
    }
    // (a - b) mod 2^W.
    template <class Raw, int F>
    static constexpr Raw subtract(Raw a, Raw b) {
        return wrapping_subtract(a, b);
    }
    // -a mod 2^W: the smallest number is its own negative.
    template <class Raw, int F>
    static constexpr Raw negate(Raw a) {
        return wrapping_negate(a);
    }
    // a * b rounded, mod 2^W.
    template <class Raw, int F>
    static constexpr Raw multiply(Raw a, Raw b) {
        return kernel::multiply<Raw, F>(a, b);
    }
    // a / b rounded, clamped; a / 0 is the largest number, the smallest one or 0, by the sign of a.
    template <class Raw, int F>
    static constexpr Raw divide(Raw a, Raw b) {
        return kernel::divide<Raw, F>(a, b);
    }
    // a - b trunc(a / b), exact, with the sign of a; a where b is 0.
    template <class Raw, int F>
    static constexpr Raw remainder(Raw a, Raw b) {
        return portable::remainder<Raw, F>(a, b);
    }
    // sqrt(a) rounded; 0 where a < 0.
    template <class Raw, int F>
    static constexpr Raw sqrt(Raw a) {
        return kernel::sqrt<Raw, F>(a);
    }
    // The arc tangent within 0.75 ulp, in radians.
    template <class Raw, int F>
    static constexpr Raw atan(Raw a) {
        return kernel::atan<Raw, F>(a);
    }
    // The angle of (x, y) in (-pi, pi], within 0.75 ulp; 0 where both are 0.
    template <class Raw, int F>
    static constexpr Raw atan2(Raw y, Raw x) {
        return kernel::atan2<Raw, F>(y, x);
    }
    // a 2^count mod 2^W; 0 from count = W on.
    template <class Raw, int F>
    static constexpr Raw shift_left(Raw a, unsigned char count) {
        return wrapping_shift_left(a, count);
    }
};

}  // namespace fixedpoint
