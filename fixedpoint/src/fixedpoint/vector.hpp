// SPDX-License-Identifier: MIT
/// \file
/// Operations on vectors of two and three components, stored consecutively as a[0], a[1], a[2].
/// Each rounds once, and so is faster and more accurate than its parts.
#pragma once

#include <fixedpoint/fixed.hpp>

namespace fixedpoint {

/// \cond internal
// A Fixed has the layout of its raw, so an array of them can be read as an array of raws.
template <int IntegerBits, int F, class A>
const SignedRawOf<IntegerBits + F, A>* raws(const Fixed<IntegerBits, F, A>* numbers) {
    static_assert(sizeof(Fixed<IntegerBits, F, A>) == sizeof(SignedRawOf<IntegerBits + F, A>),
                  "A Fixed must consist of its raw only.");
    return reinterpret_cast<const SignedRawOf<IntegerBits + F, A>*>(numbers);
}
template <int IntegerBits, int F, class A>
SignedRawOf<IntegerBits + F, A>* raws(Fixed<IntegerBits, F, A>* numbers) {
    return reinterpret_cast<SignedRawOf<IntegerBits + F, A>*>(numbers);
}
/// \endcond

/// a[0] b[0] + a[1] b[1], rounded once. If it is out of range, the arithmetic decides (Nearest:
/// modulo 2^W; Saturating rounds and saturates each product and sum).
template <int IntegerBits, int F, class A>
Fixed<IntegerBits, F, A> dot2(const Fixed<IntegerBits, F, A>* a,
                              const Fixed<IntegerBits, F, A>* b) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template dot2<SignedRawOf<IntegerBits + F, A>, F>(raws(a), raws(b)));
}
/// a[0] b[0] + a[1] b[1] + a[2] b[2], rounded once. If it is out of range, the arithmetic decides
/// as for dot2.
template <int IntegerBits, int F, class A>
Fixed<IntegerBits, F, A> dot3(const Fixed<IntegerBits, F, A>* a,
                              const Fixed<IntegerBits, F, A>* b) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template dot3<SignedRawOf<IntegerBits + F, A>, F>(raws(a), raws(b)));
}

/// The length of v rounded to nearest, saturated. No square overflows.
template <int IntegerBits, int F, class A>
Fixed<IntegerBits, F, A> length2(const Fixed<IntegerBits, F, A>* v) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template length2<SignedRawOf<IntegerBits + F, A>, F>(raws(v)));
}
/// The length of v rounded to nearest, saturated. No square overflows.
template <int IntegerBits, int F, class A>
Fixed<IntegerBits, F, A> length3(const Fixed<IntegerBits, F, A>* v) {
    return Fixed<IntegerBits, F, A>::from_raw(
        A::template length3<SignedRawOf<IntegerBits + F, A>, F>(raws(v)));
}

/// Writes v / length3(v) to `unit`, each component within 1 ulp, saturated; the zero vector stays
/// zero. `unit` may be `v`.
template <int IntegerBits, int F, class A>
void normalise3(const Fixed<IntegerBits, F, A>* v, Fixed<IntegerBits, F, A>* unit) {
    A::template normalise3<SignedRawOf<IntegerBits + F, A>, F>(raws(v), raws(unit));
}

}  // namespace fixedpoint
