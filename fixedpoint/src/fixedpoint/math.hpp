// SPDX-License-Identifier: MIT
/// \file
/// The functions of fixed-point numbers. The arithmetic defines each result for every input; the
/// comments here describe the default, whose rule is in arithmetic/nearest.hpp.
#pragma once

#include <fixedpoint/fixed.hpp>
#include <fixedpoint/kernel/integer_power.hpp>
#include <fixedpoint/kernel/smoothstep.hpp>
#include <fixedpoint/portable/lerp.hpp>
#include <fixedpoint/portable/round.hpp>

namespace fixedpoint {

/// The square root, rounded to nearest; 0 if a < 0.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> sqrt(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template sqrt<RawOf<IntegerBits + F, A>, F>(a.raw()));
}
/// 1 / sqrt(a), faithful (error below 0.75 ulp), saturated; the largest number if a is 0, and 0 if
/// a < 0.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> reciprocal_sqrt(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template reciprocal_sqrt<SignedRawOf<IntegerBits + F, A>, F>(a.raw()));
}
/// The arc tangent in radians, faithful (error below 0.75 ulp), saturated.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> atan(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template atan<SignedRawOf<IntegerBits + F, A>, F>(a.raw()));
}
/// The angle of the vector (x, y) in radians, in (-pi, pi], faithful (error below 0.75 ulp),
/// saturated; 0 if both are 0.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> atan2(Fixed<IntegerBits, F, A> y, Fixed<IntegerBits, F, A> x) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template atan2<SignedRawOf<IntegerBits + F, A>, F>(y.raw(), x.raw()));
}

/// The sine of any angle in radians, faithful (error below 0.75 ulp), never outside [-1, 1].
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> sin(Fixed<IntegerBits, F, A> angle) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template sin<SignedRawOf<IntegerBits + F, A>, F>(angle.raw()));
}
/// The cosine of any angle in radians, faithful (error below 0.75 ulp), never outside [-1, 1],
/// saturated.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> cos(Fixed<IntegerBits, F, A> angle) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template cos<SignedRawOf<IntegerBits + F, A>, F>(angle.raw()));
}
/// e^a, faithful (error below 0.75 ulp), saturated.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> exp(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template exp<SignedRawOf<IntegerBits + F, A>, F>(a.raw()));
}
/// The natural logarithm, faithful (error below 0.75 ulp), saturated; the smallest number if
/// a <= 0.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> log(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template log<SignedRawOf<IntegerBits + F, A>, F>(a.raw()));
}
/// The tangent of any angle in radians, faithful (error below 0.75 ulp), saturated. In a format
/// with more than 48 integer bits the error grows to 2^(integer bits - 53) ulp near a pole.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> tan(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template tan<SignedRawOf<IntegerBits + F, A>, F>(a.raw()));
}
/// The arc sine in radians, faithful (error below 0.75 ulp), saturated; with more than 58 fraction
/// bits the error is below 3 ulp. An argument outside [-1, 1] counts as the nearer end.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> asin(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template asin<SignedRawOf<IntegerBits + F, A>, F>(a.raw()));
}
/// The arc cosine in radians, faithful (error below 0.75 ulp), saturated; with more than 58
/// fraction bits the error is below 3 ulp. An argument outside [-1, 1] counts as the nearer end.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> acos(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template acos<SignedRawOf<IntegerBits + F, A>, F>(a.raw()));
}
/// 2^a, faithful (error below 0.75 ulp), saturated.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> exp2(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template exp2<SignedRawOf<IntegerBits + F, A>, F>(a.raw()));
}
/// e^a - 1, faithful (error below 0.75 ulp), saturated. It keeps the digits that exp(a) - 1 loses
/// near 0.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> expm1(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template expm1<SignedRawOf<IntegerBits + F, A>, F>(a.raw()));
}
/// The logarithm to base 2, faithful (error below 0.75 ulp), saturated; exact for powers of 2, and
/// the smallest number if a <= 0.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> log2(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template log2<SignedRawOf<IntegerBits + F, A>, F>(a.raw()));
}
/// The logarithm to base 10, faithful (error below 0.75 ulp), saturated; the smallest number if
/// a <= 0.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> log10(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template log10<SignedRawOf<IntegerBits + F, A>, F>(a.raw()));
}
/// ln(1 + a), faithful (error below 0.75 ulp), saturated; the smallest number if a <= -1.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> log1p(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template log1p<SignedRawOf<IntegerBits + F, A>, F>(a.raw()));
}
/// The hyperbolic sine, faithful (error below 0.75 ulp), saturated.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> sinh(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template sinh<SignedRawOf<IntegerBits + F, A>, F>(a.raw()));
}
/// The hyperbolic cosine, faithful (error below 0.75 ulp), saturated.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> cosh(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template cosh<SignedRawOf<IntegerBits + F, A>, F>(a.raw()));
}
/// The hyperbolic tangent, faithful (error below 0.75 ulp), never outside [-1, 1].
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> tanh(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template tanh<SignedRawOf<IntegerBits + F, A>, F>(a.raw()));
}
/// The cube root, faithful (error below 0.75 ulp), saturated; negative if a is.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> cbrt(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template cbrt<SignedRawOf<IntegerBits + F, A>, F>(a.raw()));
}
/// x^y, faithful (error below 0.75 ulp), saturated; 1 if y is 0. Otherwise, if x is 0: 0, or the
/// largest number if y < 0. If x < 0: the power of |x|, negated if y is odd, and 0 if y is not an
/// integer.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> pow(Fixed<IntegerBits, F, A> x, Fixed<IntegerBits, F, A> y) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template pow<SignedRawOf<IntegerBits + F, A>, F>(x.raw(), y.raw()));
}
/// x^n for an integer n of any type, faithful (error below 0.75 ulp), saturated; 1 if n is 0, and
/// the largest number if x is 0 and n < 0.
template <int IntegerBits, int F, class A, class Int>
FIXEDPOINT_CONSTEXPR Fixed<IntegerBits, F, A> power(Fixed<IntegerBits, F, A> x, Int n) {
    static_assert(BuiltinNumber<Int>::kind == BuiltinKind::integer,
                  "power takes an integer exponent: use pow for a fixed-point one.");
    using Raw = SignedRawOf<IntegerBits + F, A>;
    const auto result = kernel::integer_power<Raw, F>(
        x.raw(), portable::integer_magnitude<Unsigned<Int>>(n), portable::is_negative_integer(n));
    return Fixed<IntegerBits, F, A>::from_raw(
        A::settle(result.number, result.outcome == portable::Outcome::in_range, result.number >= 0,
                  Operation::power));
}
/// sqrt(a^2 + b^2) rounded to nearest, saturated. No square overflows.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR Fixed<IntegerBits, F, A> hypot(Fixed<IntegerBits, F, A> a,
                                                    Fixed<IntegerBits, F, A> b) {
    const SignedRawOf<IntegerBits + F, A> vector[2] = {a.raw(), b.raw()};
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template length2<SignedRawOf<IntegerBits + F, A>, F>(vector));
}
/// sqrt(a^2 + b^2 + c^2) rounded to nearest, saturated. No square overflows.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR Fixed<IntegerBits, F, A> hypot(Fixed<IntegerBits, F, A> a,
                                                    Fixed<IntegerBits, F, A> b,
                                                    Fixed<IntegerBits, F, A> c) {
    const SignedRawOf<IntegerBits + F, A> vector[3] = {a.raw(), b.raw(), c.raw()};
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template length3<SignedRawOf<IntegerBits + F, A>, F>(vector));
}
/// What sincos returns.
template <class Number>
struct SineAndCosine {
    /// Each in [-1, 1].
    /// @{
    Number sine, cosine;
    /// @}
};
/// What sin and cos return for the angle, in less time than two calls.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR SineAndCosine<Fixed<IntegerBits, F, A>> sincos(
    Fixed<IntegerBits, F, A> angle) {
    SignedRawOf<IntegerBits + F, A> both[2] = {};
    A::template sincos<SignedRawOf<IntegerBits + F, A>, F>(angle.raw(), both);
    return {Fixed<IntegerBits, F, A>::from_raw(both[0]),
            Fixed<IntegerBits, F, A>::from_raw(both[1])};
}

/// a b + c, rounded once. If it is out of range, the arithmetic decides (Nearest: modulo 2^W;
/// Saturating rounds and saturates the product first).
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> multiply_add(Fixed<IntegerBits, F, A> a,
                                                Fixed<IntegerBits, F, A> b,
                                                Fixed<IntegerBits, F, A> c) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template multiply_add<RawOf<IntegerBits + F, A>, F>(a.raw(), b.raw(), c.raw()));
}

/// a / 2^K, rounded; K must not be negative. scale_down<10>(a) takes a quarter of a product's time.
template <int K, int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> scale_down(Fixed<IntegerBits, F, A> a) {
    static_assert(K >= 0, "scale_down divides by 2^K: K must not be negative.");
    return Fixed<IntegerBits, F, A>::from_raw(A::template scale_down<K>(a.raw()));
}

/// |a|. For the smallest number the arithmetic decides, as for its negative (Nearest: the number
/// itself).
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> abs(Fixed<IntegerBits, F, A> a) {
    return a.raw() < 0 ? -a : a;
}
/// The smaller of the two.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> min(Fixed<IntegerBits, F, A> a, Fixed<IntegerBits, F, A> b) {
    return b < a ? b : a;
}
/// The larger of the two.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> max(Fixed<IntegerBits, F, A> a, Fixed<IntegerBits, F, A> b) {
    return a < b ? b : a;
}
/// a limited to [low, high]; `low` if low > high.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> clamp(Fixed<IntegerBits, F, A> a, Fixed<IntegerBits, F, A> low,
                                         Fixed<IntegerBits, F, A> high) {
    return max(low, min(a, high));
}

/// -1, 0 or 1 if a is negative, zero or positive: an integer, since some formats cannot represent
/// 1.
template <int IntegerBits, int F, class A>
constexpr int sign(Fixed<IntegerBits, F, A> a) {
    return a.raw() < 0 ? -1 : a.raw() > 0 ? 1 : 0;
}
/// |a| with the sign of b, where 0 counts as positive. If a is the smallest number and b is not
/// negative, the arithmetic decides as for its negative (Nearest: the number itself).
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> copysign(Fixed<IntegerBits, F, A> a,
                                            Fixed<IntegerBits, F, A> b) {
    // Only the negative of the smallest number is out of range.
    return Fixed<IntegerBits, F, A>::from_raw(
        A::settle(kernel::copysign<SignedRawOf<IntegerBits + F, A>, F>(a.raw(), b.raw()),
                  b.raw() < 0 || a.raw() != RawLimits<SignedRawOf<IntegerBits + F, A>>::min, true,
                  Operation::negate));
}
/// (a + b) / 2, rounded to nearest, half up. No intermediate sum overflows.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> midpoint(Fixed<IntegerBits, F, A> a,
                                            Fixed<IntegerBits, F, A> b) {
    // a + b = 2 (a | b) - (a ^ b).
    return Fixed<IntegerBits, F, A>::from_raw(
        static_cast<RawOf<IntegerBits + F, A>>((a.raw() | b.raw()) - ((a.raw() ^ b.raw()) >> 1)));
}
/// |a - b|, exact. If it is out of range, the arithmetic decides (Nearest: modulo 2^W).
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR Fixed<IntegerBits, F, A> abs_diff(Fixed<IntegerBits, F, A> a,
                                                       Fixed<IntegerBits, F, A> b) {
    const auto distance = kernel::abs_diff<RawOf<IntegerBits + F, A>, F>(a.raw(), b.raw());
    return Fixed<IntegerBits, F, A>::from_raw(
        A::settle(distance, distance >= 0, true, Operation::subtract));
}
/// a + t (b - a), rounded once, for every t: a if t is 0, b if t is 1. For t in [0, 1] it lies
/// between a and b. If it is out of range, the arithmetic decides (Nearest: modulo 2^W).
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR Fixed<IntegerBits, F, A> lerp(Fixed<IntegerBits, F, A> a,
                                                   Fixed<IntegerBits, F, A> b,
                                                   Fixed<IntegerBits, F, A> t) {
    using Number = Fixed<IntegerBits, F, A>;
    using Raw = typename Number::Raw;
    const portable::Settled<Raw> result =
        A::settles ? portable::lerp<Raw, F>(a.raw(), b.raw(), t.raw())
                   : portable::Settled<Raw>{
                         kernel::wrapping_lerp<Raw, F>(a.raw(), b.raw(), t.raw()), true, false};
    return Number::from_raw(
        A::settle(result.wrapped, result.fits, result.is_above, Operation::lerp));
}
/// 3 t^2 - 2 t^3, rounded once: it rises from 0 to 1 with a continuous slope. 0 if t < 0, and 1 if
/// t > 1, saturated if the format cannot represent 1.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR Fixed<IntegerBits, F, A> smoothstep(Fixed<IntegerBits, F, A> t) {
    return Fixed<IntegerBits, F, A>::from_raw(
        kernel::smoothstep<SignedRawOf<IntegerBits + F, A>, F>(t.raw()));
}

/// What divmod and divrem return: a = quotient b + remainder.
template <class Number>
struct QuotientAndRemainder {
    /// An integer of the raw's type, whose range is wider than the format's.
    typename Number::Raw quotient;
    /// The exact remainder.
    Number remainder;
};
/// The integer trunc(a / b) and the exact remainder a % b, which is 0 or has the sign of a. If b is
/// 0, the quotient is the largest integer, the smallest, or 0, by the sign of a, and the remainder
/// is a. The smallest number divided by -1 ulp saturates to the largest integer, with remainder 0.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR QuotientAndRemainder<Fixed<IntegerBits, F, A>> divrem(
    Fixed<IntegerBits, F, A> a, Fixed<IntegerBits, F, A> b) {
    RawOf<IntegerBits + F, A> both[2] = {};
    kernel::divrem<RawOf<IntegerBits + F, A>, F>(a.raw(), b.raw(), both);
    return {A::settle_quotient(both[0], a.raw(), b.raw()),
            Fixed<IntegerBits, F, A>::from_raw(both[1])};
}
/// The integer floor(a / b) and the exact remainder a - b floor(a / b), which is 0 or has the sign
/// of b. If b is 0, or the quotient out of range, the results are those of divrem.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR QuotientAndRemainder<Fixed<IntegerBits, F, A>> divmod(
    Fixed<IntegerBits, F, A> a, Fixed<IntegerBits, F, A> b) {
    RawOf<IntegerBits + F, A> both[2] = {};
    kernel::divmod<RawOf<IntegerBits + F, A>, F>(a.raw(), b.raw(), both);
    return {A::settle_quotient(both[0], a.raw(), b.raw()),
            Fixed<IntegerBits, F, A>::from_raw(both[1])};
}

/// The largest integral number <= a.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> floor(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        portable::floor<RawOf<IntegerBits + F, A>, F>(a.raw()));
}
/// The smallest integral number >= a; the largest number if that is out of range.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> ceil(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template ceil<RawOf<IntegerBits + F, A>, F>(a.raw()));
}
/// The nearest integral number, half up; the largest number if that is out of range.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> round(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template round<RawOf<IntegerBits + F, A>, F>(a.raw()));
}
/// a rounded toward zero to an integral number.
template <int IntegerBits, int F, class A>
constexpr Fixed<IntegerBits, F, A> trunc(Fixed<IntegerBits, F, A> a) {
    return Fixed<IntegerBits, F, A>::from_raw(
        portable::trunc<RawOf<IntegerBits + F, A>, F>(a.raw()));
}

}  // namespace fixedpoint
