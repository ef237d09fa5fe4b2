// SPDX-License-Identifier: MIT
// Vectors of two and three components, which lie one after the other as a[0], a[1], a[2]:
// operations that round once, and so are faster and more exact than their parts.
#pragma once

#include <fixedpoint/fixed.hpp>

namespace fixedpoint {

// A number is its raw and nothing else, and so is a row of numbers.
template <int I, int F, class A>
const Integer<I + F>* raws(const Fixed<I, F, A>* numbers) {
    static_assert(sizeof(Fixed<I, F, A>) == sizeof(Integer<I + F>), "A Fixed holds its raw only.");
    return reinterpret_cast<const Integer<I + F>*>(numbers);
}
template <int I, int F, class A>
Integer<I + F>* raws(Fixed<I, F, A>* numbers) {
    return reinterpret_cast<Integer<I + F>*>(numbers);
}

// The sum of a_i b_i, rounded once, modulo 2^W.
template <int I, int F, class A>
Fixed<I, F, A> dot2(const Fixed<I, F, A>* a, const Fixed<I, F, A>* b) {
    return Fixed<I, F, A>::from_raw(A::template dot2<Integer<I + F>, F>(raws(a), raws(b)));
}
template <int I, int F, class A>
Fixed<I, F, A> dot3(const Fixed<I, F, A>* a, const Fixed<I, F, A>* b) {
    return Fixed<I, F, A>::from_raw(A::template dot3<Integer<I + F>, F>(raws(a), raws(b)));
}

// The length of v within 1 ulp, clamped; no square overflows.
template <int I, int F, class A>
Fixed<I, F, A> length2(const Fixed<I, F, A>* v) {
    return Fixed<I, F, A>::from_raw(A::template length2<Integer<I + F>, F>(raws(v)));
}
template <int I, int F, class A>
Fixed<I, F, A> length3(const Fixed<I, F, A>* v) {
    return Fixed<I, F, A>::from_raw(A::template length3<Integer<I + F>, F>(raws(v)));
}

// v / length3(v), each component within 1 ulp; the zero vector stays zero. `unit` may be v.
template <int I, int F, class A>
void normalise3(const Fixed<I, F, A>* v, Fixed<I, F, A>* unit) {
    A::template normalise3<Integer<I + F>, F>(raws(v), raws(unit));
}

}  // namespace fixedpoint
