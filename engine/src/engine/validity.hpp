// SPDX-License-Identifier: MIT
// fault_in(link, particles): why a world with that many particles refuses a spring, rod, rope, drag
// or plane; Error::none if it does not. Checked when something is added or changed, so that no step
// has to. In fixed-point formats every number is finite, and that check is not compiled.
#pragma once

#include <engine/decimal.hpp>
#include <engine/error.hpp>
#include <engine/links.hpp>
#include <engine/time_step.hpp>

namespace engine {

// Both are false for NaN and infinity.
template <class Scalar>
constexpr bool is_at_least_0(Scalar a) {
    return is_finite(a) && !(a < Scalar());
}
template <class Scalar>
constexpr bool is_between_0_and_1(Scalar a) {
    return is_at_least_0(a) && !(Scalar(Decimal<1, 0>()) < a);
}

// How far the square of a normal may differ from 1: the length by 2^-9, so that 0.707 is accepted;
// in a coarse format, by the rounding of its components and of their squares.
template <class Scalar>
struct NormalTolerance {
    static constexpr Scalar value() { return Decimal<4, 3>(); }
};
template <int I, int F, class A>
struct NormalTolerance<Fixed<I, F, A>> {
    static constexpr Fixed<I, F, A> value() {
        using Raw = typename Fixed<I, F, A>::Raw;
        return Fixed<I, F, A>::from_raw(F > 10 ? static_cast<Raw>(Raw(1) << (F > 10 ? F - 8 : 0))
                                               : Raw(4));
    }
};

// Not inlined, and without dot(), so that the calls of a step are inlined as if this did not exist.
template <class Scalar, int N>
__attribute__((noinline)) bool is_unit(const Vector<Scalar, N>& v) {
    const Scalar one = Decimal<1, 0>();
    const Scalar tolerance = NormalTolerance<Scalar>::value();
    const Scalar most = one + tolerance;
    Scalar square = Scalar();
    for (unsigned char i = 0; i < N; ++i) {
        if (most < absolute(v[i])) return false;  // before its square overflows the format
        square += v[i] * v[i];
    }
    return !(square < one - tolerance) && !(most < square);
}

// Whether a rod or rope may have that length, whose inverse is given.
template <class Scalar>
constexpr bool are_length_and_inverse(Scalar length, Scalar inverse) {
    return is_finite(length) && is_finite(inverse) && inverse > Scalar();
}
// Whether a rod, rope or spring may have that length.
template <class Link, class Scalar>
bool takes_length(const Link&, Scalar length) {
    return are_length_and_inverse(length, inverse_of(length).factor);
}
template <class Scalar, class Ends>
bool takes_length(const Spring<Scalar, Ends>&, Scalar length) {
    return is_at_least_0(length);
}

template <class Vector, class Index>
Error fault_in(const Between<Vector, Index>& ends, Index particles) {
    if (!(ends.a < particles) || !(ends.b < particles)) return Error::no_such_particle;
    return ends.a == ends.b ? Error::same_particle : Error::none;
}
template <class Vector, class Index>
Error fault_in(const Anchored<Vector, Index>& ends, Index particles) {
    if (!(ends.a < particles)) return Error::no_such_particle;
    return is_finite(ends.anchor) ? Error::none : Error::not_finite;
}

template <class Scalar, class Ends, class Index>
Error fault_in(const Spring<Scalar, Ends>& spring, Index particles) {
    if (!is_at_least_0(spring.stiffness) || !is_at_least_0(spring.damping)) {
        return Error::bad_stiffness;
    }
    if (!takes_length(spring, spring.rest_length)) return Error::bad_length;
    return fault_in(spring.ends, particles);
}

template <class Scalar, class Ends, class Index>
Error fault_in(const Rod<Scalar, Ends>& rod, Index particles) {
    if (!are_length_and_inverse(rod.length, rod.inverse.factor)) return Error::bad_length;
    return fault_in(rod.ends, particles);
}

template <class Scalar, class Ends, class Index>
Error fault_in(const Rope<Scalar, Ends>& rope, Index particles) {
    if (!are_length_and_inverse(rope.length, rope.inverse.factor)) return Error::bad_length;
    if (!is_between_0_and_1(rope.restitution)) return Error::bad_restitution;
    return fault_in(rope.ends, particles);
}

template <class Scalar, class Index>
Error fault_in(const Drag<Scalar, Index>& drag, Index particles) {
    if (!is_at_least_0(drag.linear) || !is_at_least_0(drag.quadratic)) return Error::bad_stiffness;
    return drag.particle < particles ? Error::none : Error::no_such_particle;
}

template <class Scalar, class Vector, class Index>
Error fault_in(const Plane<Scalar, Vector>& plane, Index) {
    if (!is_finite(plane.normal) || !is_finite(plane.offset)) return Error::not_finite;
    if (!is_unit(plane.normal)) return Error::bad_normal;
    return is_between_0_and_1(plane.restitution) ? Error::none : Error::bad_restitution;
}

}  // namespace engine
