// SPDX-License-Identifier: MIT
/// \file
/// Mathematical constants, rounded to nearest from 60 digits: constants::pi<Q16_16>(). A constant
/// outside the range of its format does not compile.
#pragma once

#include <fixedpoint/fixed.hpp>
#include <fixedpoint/portable/decimal_literal.hpp>

namespace fixedpoint {

/// Mathematical constants in every format that can represent them.
namespace constants {

/// \cond internal
// Parsed like a literal, and checked against the range. The text is an argument of a function,
// since C++11 does not accept it as a template argument, and that function is a single return
// statement.
template <class Number>
constexpr portable::Converted<typename Number::Raw> parsed(const char* digits, int count) {
    return portable::parse_literal<typename Number::Raw, Number::fraction_bits>(digits,
                                                                                digits + count);
}
// The raw is passed as the integer that the compiler computes it in, since one of 24 bits may be a
// class.
template <class Number, decltype(+typename Number::Raw()) raw, bool fits>
constexpr Number checked() {
    static_assert(fits, "This constant lies outside the range of its fixed-point format.");
    return Number::from_raw(static_cast<typename Number::Raw>(raw));
}
#define FIXEDPOINT_CONSTANT(text)                                  \
    checked<Number, +parsed<Number>(text, sizeof text - 1).number, \
            parsed<Number>(text, sizeof text - 1).fits>()
/// \endcond

/// The circumference of a circle over its diameter.
template <class Number>
constexpr Number pi() {
    return FIXEDPOINT_CONSTANT("3.14159265358979323846264338327950288419716939937510582097494");
}
/// A full turn in radians, 2 pi.
template <class Number>
constexpr Number tau() {
    return FIXEDPOINT_CONSTANT("6.28318530717958647692528676655900576839433879875021164194989");
}
/// The base of the natural logarithm.
template <class Number>
constexpr Number e() {
    return FIXEDPOINT_CONSTANT("2.71828182845904523536028747135266249775724709369995957496697");
}
/// The natural logarithm of 2.
template <class Number>
constexpr Number ln2() {
    return FIXEDPOINT_CONSTANT("0.693147180559945309417232121458176568075500134360255254120680");
}
/// The natural logarithm of 10.
template <class Number>
constexpr Number ln10() {
    return FIXEDPOINT_CONSTANT("2.30258509299404568401799145468436420760110148862877297603333");
}
/// The square root of 2.
template <class Number>
constexpr Number sqrt2() {
    return FIXEDPOINT_CONSTANT("1.41421356237309504880168872420969807856967187537694807317668");
}
/// (1 + sqrt(5)) / 2.
template <class Number>
constexpr Number golden_ratio() {
    return FIXEDPOINT_CONSTANT("1.61803398874989484820458683436563811772030917980576286213545");
}
/// 180 / pi: multiply an angle in radians by it to get degrees.
template <class Number>
constexpr Number degrees_per_radian() {
    return FIXEDPOINT_CONSTANT("57.2957795130823208767981548141051703324054724665643215491602");
}

#undef FIXEDPOINT_CONSTANT

}  // namespace constants
}  // namespace fixedpoint
