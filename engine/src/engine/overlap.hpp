// SPDX-License-Identifier: MIT
// How far two spheres overlap, and the direction from the second to the first. In Q16.16 both
// follow from products, as for links, with the sum of the radii as the length: the bounds are those
// of distance.hpp, proven for sums of at least 4 ulp. In other formats, and in float, a root and
// quotients cost less.
#pragma once

#include <engine/distance.hpp>

namespace engine {

/// \cond internal

// What a world with collisions remembers of the last pair that it tested. If all radii are equal,
// their sum has one inverse.
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

// How far two spheres overlap; 0 or less if they do not. Each component of `first - second` must be
// less than the sum of their radii, `reach`, and `direction` must be that difference. If they
// overlap, it becomes a unit vector; if their centres coincide, the first axis.
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
    // Balls that lie on each other share the remainder of each change until nothing changes. If a
    // direction is an ulp short, the extra iterations cost more than its correction.
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
// Such spheres are so close that nothing leaves the range of the default arithmetic, applied to
// their difference alone. Not inlined: inline it would take the registers of the broad phase.
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
