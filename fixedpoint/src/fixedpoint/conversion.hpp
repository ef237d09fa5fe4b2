// SPDX-License-Identifier: MIT
/// \file
/// Numbers of one kind as numbers of another: fixed-point formats, integers, float and double.
/// Every conversion rounds to nearest, half up (to_float: half to even), and none is implicit.
///
/// Each comes in two forms. The plain one returns a number: where the source does not fit, convert
/// does what the arithmetic of the target does (of the source, where the target is an integer), and
/// from_float and from_decimal saturate; Checked notifies its hook of all of them. The one named
/// _checked returns Converted: `number` is saturated, and `fits` says whether the source, rounded,
/// is in the range.
///
/// An integer rounded otherwise is convert<int>(floor(x)), and so on: see math.hpp.
#pragma once

#include <fixedpoint/fixed.hpp>
#include <fixedpoint/portable/constant.hpp>
#include <fixedpoint/portable/convert.hpp>
#include <fixedpoint/portable/floating_point.hpp>
#include <fixedpoint/portable/from_decimal.hpp>

namespace fixedpoint {

/// \cond internal
using portable::Converted;
/// \endcond

/// \cond internal
// What conversions see in a number: a Raw and the bits behind its point, none in an integer. An
// integer has no arithmetic of its own: that of the other side applies.
template <class Number>
struct NumberFormat {
    static_assert(BuiltinNumber<Number>::is_integer,
                  "convert is for fixed-point numbers and integers: use from_float and to_float.");
    using Raw = Number;
    static constexpr int fraction_bits = 0;
    template <class Default>
    using ArithmeticOr = Default;
    static constexpr Number number(Raw raw) { return raw; }
    static constexpr Raw raw(Number number) { return number; }
};
template <int IntegerBits, int F, class A>
struct NumberFormat<Fixed<IntegerBits, F, A>> {
    using Raw = Integer<IntegerBits + F>;
    template <class Default>
    using ArithmeticOr = A;
    static constexpr int fraction_bits = F;
    static constexpr Fixed<IntegerBits, F, A> number(Raw raw) {
        return Fixed<IntegerBits, F, A>::from_raw(raw);
    }
    static constexpr Raw raw(Fixed<IntegerBits, F, A> number) { return number.raw(); }
};
/// \endcond

/// The source rounded to the fraction bits of the target: convert<Q8_8>(x),
/// convert<int>(x), convert<Q16_16>(38).
template <class Target, class Source>
constexpr Target convert(Source source) {
    using To = NumberFormat<Target>;
    using From = NumberFormat<Source>;
    using Arithmetic =
        typename To::template ArithmeticOr<typename From::template ArithmeticOr<Nearest>>;
    return To::number(
        Arithmetic::template convert<typename To::Raw, To::fraction_bits, typename From::Raw,
                                     From::fraction_bits>(From::raw(source)));
}
/// The source rounded to the fraction bits of the target, in `number`, saturated; `fits` says
/// whether it, rounded, is in the range.
template <class Target, class Source>
FIXEDPOINT_CONSTEXPR Converted<Target> convert_checked(Source source) {
    using To = NumberFormat<Target>;
    using From = NumberFormat<Source>;
    const auto result =
        portable::convert_clamped<typename To::Raw, To::fraction_bits, typename From::Raw,
                                  From::fraction_bits>(From::raw(source));
    return {To::number(result.number), result.fits};
}

/// The float or double x, rounded; NaN gives 0 and does not fit. Exact: x is taken apart by its
/// bits.
template <class Target, class Float>
constexpr Target from_float(Float x) {
    static_assert(!BuiltinNumber<Float>::is_integer,
                  "from_float takes a float or double: use from_integer for an integer.");
    return Target::from_raw(
        Target::Arithmetic::template from_float<typename Target::Raw, Target::fraction_bits>(x));
}
/// The number nearest to x, half up, in `number`, saturated; `fits` is false where it is out of the
/// range, and for NaN, whose number is 0.
template <class Target, class Float>
FIXEDPOINT_CONSTEXPR Converted<Target> from_float_checked(Float x) {
    static_assert(!BuiltinNumber<Float>::is_integer, "from_float_checked takes a float or double.");
    const auto result = portable::from_float<typename Target::Raw, Target::fraction_bits>(x);
    return {Target::from_raw(result.number), result.fits};
}

/// The constant x, an integer, float or double, rounded to nearest, half up: fixed<16, 16>(0.38).
/// It does not compile where the format does not hold x, rounded, nor for NaN, nor where the
/// compiler does not know x: from_float takes those. 0.38 is the float or double that C++ makes of
/// it; a literal of literals.hpp is the decimal itself. In C++20 always evaluated by the compiler;
/// before, where it is a constant expression or the compiler optimises.
template <int IntegerBits, int FractionBits, class Arithmetic = Nearest, class Number>
FIXEDPOINT_CONSTEVAL Fixed<IntegerBits, FractionBits, Arithmetic> fixed(Number x) {
    return Fixed<IntegerBits, FractionBits, Arithmetic>::from_raw(
        portable::Constant<Integer<IntegerBits + FractionBits>, FractionBits,
                           BuiltinNumber<Number>::kind>::raw(x));
}

/// The float or double nearest to x, half to even.
template <class Float, int IntegerBits, int F, class A>
constexpr Float to_float(Fixed<IntegerBits, F, A> x) {
    return portable::to_float<Float, Integer<IntegerBits + F>, F>(x.raw());
}

/// n / 10^decimals, rounded: from_decimal<Q16_16>(38, 2) is 0.38.
template <class Target, class Int>
constexpr Target from_decimal(Int n, uint8_t decimals) {
    return Target::from_raw(
        Target::Arithmetic::template from_decimal<typename Target::Raw, Target::fraction_bits>(
            n, decimals));
}
/// n / 10^decimals rounded to nearest, half up, in `number`, saturated; `fits` says whether it,
/// rounded, is in the range.
template <class Target, class Int>
FIXEDPOINT_CONSTEXPR Converted<Target> from_decimal_checked(Int n, uint8_t decimals) {
    const auto result =
        portable::from_decimal<typename Target::Raw, Target::fraction_bits>(n, decimals);
    return {Target::from_raw(result.number), result.fits};
}

}  // namespace fixedpoint
