// SPDX-License-Identifier: MIT
/// \file
/// polynomial: a polynomial by Horner's rule in a format finer than that of its argument and
/// result, so that one rounding is left, at the end.
#pragma once

#include <fixedpoint/blocks/number.hpp>
#include <fixedpoint/blocks/table.hpp>

namespace fixedpoint {

/// The sum of coefficient[i] x^i, computed in the format of the coefficients and rounded to that of
/// x.
///
/// With W, the coefficients' format: x is converted to W; each of the N - 1 steps c + x p is
/// rounded once. For |x| <= 1 the error so is at most 1/2 ulp of the result and (N - 1)/2 ulp of W:
/// with 8 more fraction bits in W, as Q8.24 has beside Q16.16 and Q16.16 beside Q8.8, below 0.52
/// ulp up to degree 9. What leaves the range of W, in between too, is as its arithmetic has it
/// (Nearest: modulo 2^W); so is, in the conversion at the end, what leaves the range of x.
template <class Number, class Coefficient, uint16_t N>
Number polynomial(Number x, const Table<Coefficient, N>& coefficient) {
    const Coefficient argument = BlockNumber<Coefficient>::from(x);
    Coefficient sum = coefficient[N - 1];
    for (uint16_t i = N - 1; i-- != 0;)
        sum = BlockNumber<Coefficient>::multiply_add(sum, argument, coefficient[i]);
    return BlockNumber<Number>::from(sum);
}

}  // namespace fixedpoint
