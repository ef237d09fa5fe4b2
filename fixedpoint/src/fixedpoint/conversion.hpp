// SPDX-License-Identifier: MIT
// Numbers of one kind as numbers of another: fixed-point formats, integers, float and double.
// Every conversion rounds to nearest, ties upward (to_float: to even), and none is implicit. What
// does not fit is treated as the arithmetic of the target says (integers: modulo 2^W); those named
// _clamped and those from float and decimal return Converted: `number` is the nearest number of the
// target, `fits` says whether the source, rounded, is in its range.
//
// An integer rounded otherwise is convert<int>(floor(x)), and so on: see math.hpp.
#pragma once

#include <fixedpoint/fixed.hpp>
#include <fixedpoint/portable/convert.hpp>
#include <fixedpoint/portable/floating_point.hpp>
#include <fixedpoint/portable/from_decimal.hpp>

namespace fixedpoint {

using portable::Converted;

// What conversions see in a number: a Raw and the bits behind its point, none in an integer.
template <class Number>
struct NumberFormat {
    static_assert(Number(3) / Number(2) == Number(1),
                  "convert is for fixed-point numbers and integers: use from_float and to_float.");
    using Raw = Number;
    using Arithmetic = Nearest;
    static constexpr int fraction_bits = 0;
    static constexpr Number number(Raw raw) { return raw; }
    static constexpr Raw raw(Number number) { return number; }
};
template <int I, int F, class A>
struct NumberFormat<Fixed<I, F, A>> {
    using Raw = Integer<I + F>;
    using Arithmetic = A;
    static constexpr int fraction_bits = F;
    static constexpr Fixed<I, F, A> number(Raw raw) { return Fixed<I, F, A>::from_raw(raw); }
    static constexpr Raw raw(Fixed<I, F, A> number) { return number.raw(); }
};

// The source rounded to the fraction bits of the target: convert<Q8_8>(x),
// convert<int>(x), convert<Q16_16>(38).
template <class Target, class Source>
constexpr Target convert(Source source) {
    using To = NumberFormat<Target>;
    using From = NumberFormat<Source>;
    return To::number(
        To::Arithmetic::template convert<typename To::Raw, To::fraction_bits, typename From::Raw,
                                         From::fraction_bits>(From::raw(source)));
}

// The same, clamped to the range of the target.
template <class Target, class Source>
FIXEDPOINT_CONSTEXPR Converted<Target> convert_clamped(Source source) {
    using To = NumberFormat<Target>;
    using From = NumberFormat<Source>;
    const auto result =
        portable::convert_clamped<typename To::Raw, To::fraction_bits, typename From::Raw,
                                  From::fraction_bits>(From::raw(source));
    return {To::number(result.number), result.fits};
}

// The float or double x rounded and clamped; NaN gives 0, which does not fit. Exact: x is taken
// apart by its bits.
template <class Target, class Float>
FIXEDPOINT_CONSTEXPR Converted<Target> from_float(Float x) {
    const auto result = portable::from_float<typename Target::Raw, Target::fraction_bits>(x);
    return {Target::from_raw(result.number), result.fits};
}

// The float or double nearest to x, ties to even.
template <class Float, int I, int F, class A>
constexpr Float to_float(Fixed<I, F, A> x) {
    return portable::to_float<Float, Integer<I + F>, F>(x.raw());
}

// n / 10^decimals rounded and clamped: from_decimal<Q16_16>(38, 2) is 0.38.
template <class Target, class Int>
FIXEDPOINT_CONSTEXPR Converted<Target> from_decimal(Int n, uint8_t decimals) {
    const auto result =
        portable::from_decimal<typename Target::Raw, Target::fraction_bits>(n, decimals);
    return {Target::from_raw(result.number), result.fits};
}

}  // namespace fixedpoint
