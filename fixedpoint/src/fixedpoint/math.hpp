// SPDX-License-Identifier: MIT
// The functions of fixed-point numbers. Each returns what its arithmetic defines for every input;
// the sentence stands in arithmetic/nearest.hpp for the default.
#pragma once

#include <fixedpoint/fixed.hpp>
#include <fixedpoint/portable/round.hpp>

namespace fixedpoint {

template <int I, int F, class A>
constexpr Fixed<I, F, A> sqrt(Fixed<I, F, A> a) {
    return Fixed<I, F, A>::from_raw(A::template sqrt<Integer<I + F>, F>(a.raw()));
}
template <int I, int F, class A>
constexpr Fixed<I, F, A> reciprocal_sqrt(Fixed<I, F, A> a) {
    return Fixed<I, F, A>::from_raw(A::template reciprocal_sqrt<Integer<I + F>, F>(a.raw()));
}
template <int I, int F, class A>
constexpr Fixed<I, F, A> atan(Fixed<I, F, A> a) {
    return Fixed<I, F, A>::from_raw(A::template atan<Integer<I + F>, F>(a.raw()));
}
template <int I, int F, class A>
constexpr Fixed<I, F, A> atan2(Fixed<I, F, A> y, Fixed<I, F, A> x) {
    return Fixed<I, F, A>::from_raw(A::template atan2<Integer<I + F>, F>(y.raw(), x.raw()));
}

template <int I, int F, class A>
constexpr Fixed<I, F, A> sin(Fixed<I, F, A> angle) {
    return Fixed<I, F, A>::from_raw(A::template sin<Integer<I + F>, F>(angle.raw()));
}
template <int I, int F, class A>
constexpr Fixed<I, F, A> cos(Fixed<I, F, A> angle) {
    return Fixed<I, F, A>::from_raw(A::template cos<Integer<I + F>, F>(angle.raw()));
}
template <int I, int F, class A>
constexpr Fixed<I, F, A> exp(Fixed<I, F, A> a) {
    return Fixed<I, F, A>::from_raw(A::template exp<Integer<I + F>, F>(a.raw()));
}
template <int I, int F, class A>
constexpr Fixed<I, F, A> log(Fixed<I, F, A> a) {
    return Fixed<I, F, A>::from_raw(A::template log<Integer<I + F>, F>(a.raw()));
}
template <class Number>
struct SineAndCosine {
    Number sine, cosine;
};
// Both of one angle, for less than sin and cos take.
template <int I, int F, class A>
FIXEDPOINT_CONSTEXPR SineAndCosine<Fixed<I, F, A>> sincos(Fixed<I, F, A> angle) {
    Integer<I + F> both[2] = {};
    A::template sincos<Integer<I + F>, F>(angle.raw(), both);
    return {Fixed<I, F, A>::from_raw(both[0]), Fixed<I, F, A>::from_raw(both[1])};
}

// a b + c, rounded once.
template <int I, int F, class A>
constexpr Fixed<I, F, A> multiply_add(Fixed<I, F, A> a, Fixed<I, F, A> b, Fixed<I, F, A> c) {
    return Fixed<I, F, A>::from_raw(
        A::template multiply_add<Integer<I + F>, F>(a.raw(), b.raw(), c.raw()));
}

// a / 2^K rounded: scale_down<10>(a) takes a quarter of a product's time.
template <int K, int I, int F, class A>
constexpr Fixed<I, F, A> scale_down(Fixed<I, F, A> a) {
    static_assert(K >= 0, "scale_down divides by 2^K, K not negative.");
    return Fixed<I, F, A>::from_raw(A::template scale_down<K>(a.raw()));
}

// |a|, the smallest number as the arithmetic negates it.
template <int I, int F, class A>
constexpr Fixed<I, F, A> abs(Fixed<I, F, A> a) {
    return a.raw() < 0 ? -a : a;
}
template <int I, int F, class A>
constexpr Fixed<I, F, A> min(Fixed<I, F, A> a, Fixed<I, F, A> b) {
    return b < a ? b : a;
}
template <int I, int F, class A>
constexpr Fixed<I, F, A> max(Fixed<I, F, A> a, Fixed<I, F, A> b) {
    return a < b ? b : a;
}
// a, but at least `low` and at most `high`; `low` where the two bounds contradict each other.
template <int I, int F, class A>
constexpr Fixed<I, F, A> clamp(Fixed<I, F, A> a, Fixed<I, F, A> low, Fixed<I, F, A> high) {
    return max(low, min(a, high));
}

// The largest integral number <= a.
template <int I, int F, class A>
constexpr Fixed<I, F, A> floor(Fixed<I, F, A> a) {
    return Fixed<I, F, A>::from_raw(portable::floor<Integer<I + F>, F>(a.raw()));
}
// The smallest integral number >= a; the largest number where that does not fit.
template <int I, int F, class A>
constexpr Fixed<I, F, A> ceil(Fixed<I, F, A> a) {
    return Fixed<I, F, A>::from_raw(portable::ceil<Integer<I + F>, F>(a.raw()));
}
// The nearest integral number, ties upward; the largest number where that does not fit.
template <int I, int F, class A>
constexpr Fixed<I, F, A> round(Fixed<I, F, A> a) {
    return Fixed<I, F, A>::from_raw(portable::round<Integer<I + F>, F>(a.raw()));
}
// a without its fraction.
template <int I, int F, class A>
constexpr Fixed<I, F, A> trunc(Fixed<I, F, A> a) {
    return Fixed<I, F, A>::from_raw(portable::trunc<Integer<I + F>, F>(a.raw()));
}

}  // namespace fixedpoint
