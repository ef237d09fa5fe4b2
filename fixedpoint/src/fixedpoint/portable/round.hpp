// SPDX-License-Identifier: MIT
// Rounding to an integer: as a plain integer, which always fits a Raw (integer_floor and the like),
// and as a fixed-point number, saturated (floor and the like).
#pragma once

#include <fixedpoint/integer.hpp>

namespace fixedpoint {
namespace portable {

// The fraction bits of a Raw.
template <class Raw, int F>
constexpr Raw fraction_mask() {
    return static_cast<Raw>((Unsigned<Raw>(1) << F) - 1);
}

// a - floor(a): the fraction, in [0, 1) for negative a too.
template <class Raw, int F>
constexpr Raw fraction(Raw a) {
    return static_cast<Raw>(a & fraction_mask<Raw, F>());
}

// The largest integer <= a / 2^F.
template <class Raw, int F>
constexpr Raw integer_floor(Raw a) {
    return static_cast<Raw>(a >> F);
}

// The smallest integer >= a / 2^F.
template <class Raw, int F>
constexpr Raw integer_ceil(Raw a) {
    return static_cast<Raw>((a >> F) + (fraction<Raw, F>(a) != 0 ? 1 : 0));
}

// The integer nearest to a / 2^F, half up: floor(a / 2^F + 1/2).
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw integer_round(Raw a) {
    // The sum a + 2^(F-1) could overflow; the first fraction bit decides just as well.
    constexpr Raw half = static_cast<Raw>((Unsigned<Raw>(1) << F) >> 1);
    Raw rounded = integer_floor<Raw, F>(a);
    if ((a & half) != 0) rounded = static_cast<Raw>(rounded + 1);
    return rounded;
}

// Whether the integer n is in range. n must not be below it.
template <class Raw, int F>
constexpr bool integral_fits(Raw n) {
    return n <= (RawLimits<Raw>::max >> F);
}

// The number n, or the largest number if n exceeds it.
template <class Raw, int F>
constexpr Raw integral_saturated_above(Raw n) {
    return !integral_fits<Raw, F>(n)
               ? RawLimits<Raw>::max
               : static_cast<Raw>(shifted_left(static_cast<Unsigned<Raw>>(n), F));
}

// The largest integral number <= a; always representable.
template <class Raw, int F>
constexpr Raw floor(Raw a) {
    return static_cast<Raw>(a & ~fraction_mask<Raw, F>());
}

// The smallest integral number >= a; the largest number if that is out of range.
template <class Raw, int F>
constexpr Raw ceil(Raw a) {
    return integral_saturated_above<Raw, F>(integer_ceil<Raw, F>(a));
}

// The integral number nearest to a, half up; the largest number if that is out of range.
template <class Raw, int F>
constexpr Raw round(Raw a) {
    return integral_saturated_above<Raw, F>(integer_round<Raw, F>(a));
}

// a without its fraction, rounded toward zero; always representable.
template <class Raw, int F>
constexpr Raw trunc(Raw a) {
    return a < 0 ? ceil<Raw, F>(a) : floor<Raw, F>(a);
}

}  // namespace portable
}  // namespace fixedpoint
