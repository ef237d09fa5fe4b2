// SPDX-License-Identifier: GPL-3.0-or-later
// The number types in which exact values are computed, and the roundings between them.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/mpfr.hpp>

namespace reference {

namespace multiprecision = boost::multiprecision;

// No expression templates: results are stored immediately, and `auto` is the number type.
using Integer = multiprecision::number<multiprecision::cpp_int_backend<>, multiprecision::et_off>;
using Rational =
    multiprecision::number<multiprecision::rational_adaptor<multiprecision::cpp_int_backend<>>,
                           multiprecision::et_off>;

// 96 decimal digits are 319 bits. A value of a 64-bit format takes at most 64 of them before the
// binary point of its raw, which leaves over 200 bits below the ulp.
using Real =
    multiprecision::number<multiprecision::mpfr_float_backend<96, multiprecision::allocate_stack>,
                           multiprecision::et_off>;

// x 2^exponent, exactly.
Rational scale(const Rational& x, int exponent);
Real scale(const Real& x, int exponent);

Rational floor(const Rational& x);
Real floor(const Real& x);

// The exponent e with 2^e <= |x| < 2^(e+1). `x` must be neither zero nor infinite.
int binade(const Rational& x);
int binade(const Real& x);

Real to_real(const Rational& x);

}  // namespace reference
