// SPDX-License-Identifier: MIT
/// \file
/// Conversions between fixed-point formats, integers, float and double. Every one rounds to
/// nearest, half up (to_float: half to even), and none is implicit.
///
/// Each comes in two forms. The plain form returns a number. If the rounded source is out of range,
/// convert leaves the result to the arithmetic of the target (of the source if the target is an
/// integer), while from_float and from_decimal saturate; Checked notifies its hook in each case.
/// The form named _checked returns Converted: `number` is saturated, and `fits` says whether the
/// rounded source is in range.
///
/// To round to an integer in another direction, write convert<int>(floor(x)) and the like: see
/// math.hpp.
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
// A number as conversions see it: a Raw and its fraction bits, 0 for an integer. An integer does
// not have an arithmetic of its own; that of the other side applies.
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
    using Raw = RawOf<IntegerBits + F, A>;
    template <class Default>
    using ArithmeticOr = A;
    static constexpr int fraction_bits = F;
    static constexpr Fixed<IntegerBits, F, A> number(Raw raw) {
        return Fixed<IntegerBits, F, A>::from_raw(raw);
    }
    static constexpr Raw raw(Fixed<IntegerBits, F, A> number) { return number.raw(); }
};
/// \endcond

/// The source rounded to the fraction bits of the target, as in convert<Q8_8>(x), convert<int>(x)
/// or convert<Q16_16>(38). If it is out of range, the arithmetic decides (Nearest: modulo 2^W).
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
/// The source rounded to the fraction bits of the target and saturated; `fits` says whether the
/// rounded source is in range.
template <class Target, class Source>
FIXEDPOINT_CONSTEXPR Converted<Target> convert_checked(Source source) {
    using To = NumberFormat<Target>;
    using From = NumberFormat<Source>;
    const auto result =
        portable::convert_saturated<typename To::Raw, To::fraction_bits, typename From::Raw,
                                    From::fraction_bits>(From::raw(source));
    return {To::number(result.number), result.fits};
}

/// The float or double x, rounded to nearest, half up, and saturated; 0 if x is NaN. Correctly
/// rounded: it works on the bits of x.
template <class Target, class Float>
constexpr Target from_float(Float x) {
    static_assert(!BuiltinNumber<Float>::is_integer,
                  "from_float takes a float or double: use from_integer for an integer.");
    return Target::from_raw(
        Target::Arithmetic::template from_float<typename Target::Raw, Target::fraction_bits>(x));
}
/// The float or double x, rounded to nearest, half up, and saturated; 0 if x is NaN. `fits` is
/// false if the rounded x is out of range, and for NaN.
template <class Target, class Float>
FIXEDPOINT_CONSTEXPR Converted<Target> from_float_checked(Float x) {
    static_assert(!BuiltinNumber<Float>::is_integer, "from_float_checked takes a float or double.");
    const auto result = portable::from_float<typename Target::Raw, Target::fraction_bits>(x);
    return {Target::from_raw(result.number), result.fits};
}

/// The constant x, an integer, float or double, rounded to nearest, half up: fixed<16, 16>(0.38).
/// The compiler must know x, and the rounded x must be in range, which NaN is not; use from_float
/// for any other x. From C++20 on, and in constant expressions of every standard, another call does
/// not compile. Elsewhere an optimising compiler refuses it, except where it knows no more of x
/// than that it fits; without optimisation, an x out of range stops the program. 0.38 is first
/// rounded to a float or double; a literal from literals.hpp is the decimal itself.
template <int IntegerBits, int FractionBits, class Arithmetic = Nearest, class Number>
FIXEDPOINT_CONSTEVAL Fixed<IntegerBits, FractionBits, Arithmetic> fixed(Number x) {
    return Fixed<IntegerBits, FractionBits, Arithmetic>::from_raw(
        portable::Constant<RawOf<IntegerBits + FractionBits, Arithmetic>, FractionBits,
                           BuiltinNumber<Number>::kind>::raw(x));
}

/// The float or double nearest to x, half to even. Every format is within the range of float.
template <class Float, int IntegerBits, int F, class A>
constexpr Float to_float(Fixed<IntegerBits, F, A> x) {
    return portable::to_float<Float, RawOf<IntegerBits + F, A>, F>(x.raw());
}

/// n / 10^decimals for a signed integer n, rounded to nearest, half up, and saturated:
/// from_decimal<Q16_16>(38, 2) is 0.38.
template <class Target, class Int>
constexpr Target from_decimal(Int n, uint8_t decimals) {
    return Target::from_raw(
        Target::Arithmetic::template from_decimal<typename Target::Raw, Target::fraction_bits>(
            n, decimals));
}
/// n / 10^decimals for a signed integer n, rounded to nearest, half up, and saturated; `fits` says
/// whether the rounded value is in range.
template <class Target, class Int>
FIXEDPOINT_CONSTEXPR Converted<Target> from_decimal_checked(Int n, uint8_t decimals) {
    const auto result =
        portable::from_decimal<typename Target::Raw, Target::fraction_bits>(n, decimals);
    return {Target::from_raw(result.number), result.fits};
}

}  // namespace fixedpoint
