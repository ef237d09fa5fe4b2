// SPDX-License-Identifier: MIT
/// \file
/// Vectors of two and three components, which lie one after the other as a[0], a[1], a[2]:
/// operations that round once, and so are faster and more exact than their parts.
#pragma once

#include <fixedpoint/fixed.hpp>

namespace fixedpoint {

/// \cond internal
// A number is its raw and nothing else, and so is a row of numbers.
template <int IntegerBits, int F, class A>
const Integer<IntegerBits + F>* raws(const Fixed<IntegerBits, F, A>* numbers) {
    static_assert(sizeof(Fixed<IntegerBits, F, A>) == sizeof(Integer<IntegerBits + F>),
                  "A Fixed holds its raw only.");
    return reinterpret_cast<const Integer<IntegerBits + F>*>(numbers);
}
template <int IntegerBits, int F, class A>
Integer<IntegerBits + F>* raws(Fixed<IntegerBits, F, A>* numbers) {
    return reinterpret_cast<Integer<IntegerBits + F>*>(numbers);
}
/// \endcond

/// The sum of a_i b_i, rounded once, modulo 2^W.
template <int IntegerBits, int F, class A>
Fixed<IntegerBits, F, A> dot2(const Fixed<IntegerBits, F, A>* a,
                              const Fixed<IntegerBits, F, A>* b) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template dot2<Integer<IntegerBits + F>, F>(raws(a), raws(b)));
}
/// The sum of the three a_i b_i, rounded once, modulo 2^W.
template <int IntegerBits, int F, class A>
Fixed<IntegerBits, F, A> dot3(const Fixed<IntegerBits, F, A>* a,
                              const Fixed<IntegerBits, F, A>* b) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template dot3<Integer<IntegerBits + F>, F>(raws(a), raws(b)));
}

/// The length of v within 1 ulp, saturated; no square overflows.
template <int IntegerBits, int F, class A>
Fixed<IntegerBits, F, A> length2(const Fixed<IntegerBits, F, A>* v) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template length2<Integer<IntegerBits + F>, F>(raws(v)));
}
/// The length of v within 1 ulp, saturated; no square overflows.
template <int IntegerBits, int F, class A>
Fixed<IntegerBits, F, A> length3(const Fixed<IntegerBits, F, A>* v) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template length3<Integer<IntegerBits + F>, F>(raws(v)));
}

/// v / length3(v), each component within 1 ulp; the zero vector stays zero. `unit` may be v.
template <int IntegerBits, int F, class A>
void normalise3(const Fixed<IntegerBits, F, A>* v, Fixed<IntegerBits, F, A>* unit) {
    A::template normalise3<Integer<IntegerBits + F>, F>(raws(v), raws(unit));
}

}  // namespace fixedpoint
