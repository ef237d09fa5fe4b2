// SPDX-License-Identifier: MIT
// What the engine asks of a scalar: the operators + - * / and comparisons, and the functions here,
// which a Fixed computes with the library's operations that round once and every other type
// (float, double, a wide floating-point type) with its operators and the sqrt found by its type.
#pragma once

#include <math.h>

#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/conversion.hpp>
#include <fixedpoint/math.hpp>
#include <fixedpoint/vector.hpp>

namespace engine {

using fixedpoint::Fixed;

// The scalar of choice where nobody has bounded a scene's numbers: nothing wraps, what does not fit
// stays at the end of the range, where it
// is seen. A plain Fixed wraps, and is faster: for scenes of which it is known that they fit.
template <int I, int F>
using Clamped = Fixed<I, F, fixedpoint::Saturating>;

// The sum of a_i b_i over N components.
template <int N, class Scalar>
constexpr Scalar dot(const Scalar* a, const Scalar* b) {
    Scalar sum = a[0] * b[0];
    for (unsigned char i = 1; i < N; ++i) sum += a[i] * b[i];
    return sum;
}

// The length of a vector of N components.
template <int N, class Scalar>
Scalar length(const Scalar* v) {
    using ::sqrt;
    return sqrt(dot<N>(v, v));
}

// a b + c.
template <class Scalar>
constexpr Scalar product_plus(Scalar a, Scalar b, Scalar c) {
    return a * b + c;
}

// a + b and a b, clamped to the scalar's range: for what is better too small than of the wrong
// sign.
template <class Scalar>
constexpr Scalar clamped_sum(Scalar a, Scalar b) {
    return a + b;
}
template <int I, int F, class A>
constexpr Fixed<I, F, A> clamped_sum(Fixed<I, F, A> a, Fixed<I, F, A> b) {
    using Raw = typename Fixed<I, F, A>::Raw;
    return Fixed<I, F, A>::from_raw(fixedpoint::Saturating::template add<Raw, F>(a.raw(), b.raw()));
}
template <class Scalar>
constexpr Scalar clamped_product(Scalar a, Scalar b) {
    return a * b;
}
template <int I, int F, class A>
constexpr Fixed<I, F, A> clamped_product(Fixed<I, F, A> a, Fixed<I, F, A> b) {
    using Raw = typename Fixed<I, F, A>::Raw;
    return Fixed<I, F, A>::from_raw(
        fixedpoint::Saturating::template multiply<Raw, F>(a.raw(), b.raw()));
}

// |a|.
template <class Scalar>
constexpr Scalar absolute(Scalar a) {
    return a < Scalar() ? -a : a;
}

// An arithmetic without compound operations (Published) takes them apart, as every other scalar.
template <class Arithmetic>
struct RoundsOnce {
    template <class A>
    static char test(decltype(A::template dot2<int32_t, 16>(nullptr, nullptr))*);
    template <class A>
    static long test(...);
    static constexpr bool value = sizeof(test<Arithmetic>(nullptr)) == sizeof(char);
};

template <bool condition, class T>
struct OnlyIf {};
template <class T>
struct OnlyIf<true, T> {
    using Type = T;
};
template <int I, int F, class A>
using Compound = typename OnlyIf<RoundsOnce<A>::value, Fixed<I, F, A>>::Type;

template <int N, int I, int F, class A>
Compound<I, F, A> dot(const Fixed<I, F, A>* a, const Fixed<I, F, A>* b) {
    return N == 2 ? fixedpoint::dot2(a, b) : fixedpoint::dot3(a, b);
}
template <int N, int I, int F, class A>
Compound<I, F, A> length(const Fixed<I, F, A>* v) {
    return N == 2 ? fixedpoint::length2(v) : fixedpoint::length3(v);
}
template <int I, int F, class A>
constexpr Compound<I, F, A> product_plus(Fixed<I, F, A> a, Fixed<I, F, A> b, Fixed<I, F, A> c) {
    return fixedpoint::multiply_add(a, b, c);
}

}  // namespace engine
