// SPDX-License-Identifier: MIT
// By how much two spheres overlap, and in which direction the first lies from the second. In Q16.16
// products tell both, as of links, with the sum of the radii for the length: the bounds are those
// of distance.hpp, proven from a sum of 4 ulp on. In other formats, and in float, a root and
// quotients are the cheaper way.
#pragma once

#include <engine/distance.hpp>

namespace engine {

/// \cond internal

// What a world that has collisions knows of the pair whose overlap was last asked for. Where all
// radii are alike, their sum has one inverse.
template <class Scalar, bool by_products>
struct Reach {};
template <class Scalar>
struct Reach<Scalar, true> {
    Scalar reach = Scalar();
    Inverse<Scalar> inverse = {};
};
template <class Scalar, bool used>
struct LastReach {};
template <class Scalar>
struct LastReach<Scalar, true> {};
template <class A>
struct LastReach<Fixed<16, 16, A>, true> : Reach<Fixed<16, 16, A>, RoundsOnce<A>::value> {};
template <>
struct LastReach<SaturatingFixed<16, 16>, true> : LastReach<Fixed<16, 16>, true> {};

// Of spheres of which each component of `first - second` is below the sum of their radii, `reach`:
// by how much they overlap, 0 or less where they do not. Where they do, `direction`, which must be
// that difference, becomes 1 long; where the centres coincide, the first axis.
template <class Scalar, int N>
ENGINE_INLINE Scalar overlap(const Vector<Scalar, N>&, const Vector<Scalar, N>&, Scalar reach,
                             LastReach<Scalar, true>&, Vector<Scalar, N>& direction) {
    const Scalar distance = length(direction);
    if (!(distance < reach)) return Scalar();
    direction = divided(direction, distance);
    if (distance == Scalar()) direction[0] = Decimal<1, 0>();
    return reach - distance;
}
template <class A, int N>
ENGINE_INLINE Compound<16, 16, A> overlap(const Vector<Fixed<16, 16, A>, N>& first,
                                          const Vector<Fixed<16, 16, A>, N>& second,
                                          Fixed<16, 16, A> reach,
                                          LastReach<Fixed<16, 16, A>, true>& last,
                                          Vector<Fixed<16, 16, A>, N>& direction) {
    if (!(reach == last.reach)) {
        last.reach = reach;
        last.inverse = inverse_of(reach);
    }
    scale(direction, last.inverse);
    const auto e = excess_over_one(direction);
    Fixed<16, 16, A> excess = {};
    if (!(e < excess)) return excess;
    // Balls that lie on each other share what is left of each change until nothing changes: a
    // direction an ulp short takes more iterations than to mend it.
    const Fixed<16, 16, A> little = {};
    if (!measure_scaled(first, second, reach, last.inverse, e, little, direction, excess)) {
        direction[0] = Decimal<1, 0>();
    }
    return -excess;
}

template <class To, class From, int N>
ENGINE_INLINE Vector<To, N> in_arithmetic_of(const Vector<From, N>& v) {
    Vector<To, N> same;
    for_components<N>([&](unsigned char i)
                          ENGINE_INLINE_LAMBDA { same[i] = To::from_raw(v[i].raw()); });
    return same;
}
// Such spheres are so near each other that nothing leaves the range, and the default arithmetic
// will do, of their difference alone. By a call: inline it takes the registers of the search for
// pairs.
template <int N>
__attribute__((noinline)) SaturatingFixed<16, 16> overlap(
    const Vector<SaturatingFixed<16, 16>, N>&, const Vector<SaturatingFixed<16, 16>, N>&,
    SaturatingFixed<16, 16> reach, LastReach<SaturatingFixed<16, 16>, true>& last,
    Vector<SaturatingFixed<16, 16>, N>& direction) {
    using Number = Fixed<16, 16>;
    LastReach<Number, true>& inverse = last;
    Vector<Number, N> unit = in_arithmetic_of<Number>(direction);
    const Vector<Number, N> apart = unit, origin;
    const Number depth = overlap(apart, origin, Number::from_raw(reach.raw()), inverse, unit);
    direction = in_arithmetic_of<SaturatingFixed<16, 16>>(unit);
    return SaturatingFixed<16, 16>::from_raw(depth.raw());
}

/// \endcond

}  // namespace engine
