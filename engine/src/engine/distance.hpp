// SPDX-License-Identifier: MIT
// The distance between the ends of a link, and the direction from one to the other. In fixed point
// a step needs neither a root nor a quotient for it: a link stores 1 / length, and the product of
// that with the difference d of the ends is nearly a unit vector n when the distance is close to
// the length. With e = (n . n - 1) / 2, the unit vector is n (1 + 2 e)^(-1/2), by its series up to
// e^2. Where e is large, a few such steps in sequence converge. The distance is length (1 + e - e^2
// / 2), or d . n.
//
// Proven for Q16.16 (engine/distance_proof_test), for a distance D and a length L from 4 ulp to 98%
// of the range, if (D / L)^2 is within that, too. Close to a length below 2 m, a component of the
// direction is off by at most 8.5 ulp and the excess by 3 L + 1/2 ulp; otherwise by 10.75 ulp and
// 3.25 D + N / 2. Where each product of a sum is rounded (Saturating), these are 9, 3.5 L + 1/2,
// 11.25 and 5 D + N / 2.
#pragma once

#include <engine/choice.hpp>
#include <engine/decimal.hpp>
#include <engine/time_step.hpp>
#include <engine/vector.hpp>

namespace engine {

/// \cond internal

// 1 / a = factor / 2^halvings. For a fixed-point number above 1 the factor lies in 1/2..1, so that
// a long link's inverse is as accurate as a short one's. The factor is 0 if it does not fit the
// format, and for a <= 0. For a = 2^-k, k >= 0, the factor is 1 and `halvings` is -1 - k: scaling
// takes k doublings and no product.
template <class Scalar>
struct Inverse {
    Scalar factor;
    signed char halvings;
};

template <class Scalar>
Inverse<Scalar> inverse_of(Scalar a) {
    const Scalar one = Decimal<1, 0>();
    return {one / a, 0};
}
template <class Scalar>
ENGINE_INLINE Scalar times(Scalar a, const Inverse<Scalar>& inverse) {
    return a * inverse.factor;
}

// Digit by digit, since it runs once for each link: a kernel's table would stay in flash.
template <int I, int F, class A>
__attribute__((noinline, cold)) Inverse<Fixed<I, F, A>> inverse_by_digits(Fixed<I, F, A> a) {
    using Number = Fixed<I, F, A>;
    using Raw = typename Number::Raw;
    using Digits = fixedpoint::Unsigned<Raw>;
    if (!(a > Number())) return {Number(), 0};
    const auto divisor = static_cast<Digits>(a.raw());
    signed char halvings = 0;
    for (Digits left = divisor >> F >> 1; left != 0; left = static_cast<Digits>(left >> 1)) {
        ++halvings;
    }
    Digits quotient = 0, rest = 1;
    for (auto digits = static_cast<unsigned char>(2 * F + halvings);; --digits) {
        if (static_cast<Raw>(quotient) < 0) return {Number(), 0};
        quotient = static_cast<Digits>(2 * quotient);
        if (rest >= divisor) {
            rest = static_cast<Digits>(rest - divisor);
            quotient = static_cast<Digits>(quotient + 1);
        }
        if (digits == 0) break;
        rest = static_cast<Digits>(2 * rest);
    }
    if (rest >= divisor - rest) quotient = static_cast<Digits>(quotient + 1);
    if (static_cast<Raw>(quotient) < 0) return {Number(), 0};
    if (halvings == 0 && (divisor & (divisor - 1)) == 0) {
        halvings = -1;
        for (; quotient >> F > 1; quotient = static_cast<Digits>(quotient >> 1)) --halvings;
    }
    return {Number::from_raw(static_cast<Raw>(quotient)), halvings};
}
// By a quotient of 64 bits. `a` must be above 0 and of at most 32 bits.
template <int I, int F, class A>
ENGINE_INLINE Inverse<Fixed<I, F, A>> inverse_by_quotient(Fixed<I, F, A> a) {
    using Number = Fixed<I, F, A>;
    const auto divisor = static_cast<uint64_t>(a.raw());
    const int power = 63 - __builtin_clzll(divisor) - F;  // 2^power <= a < 2^(power + 1)
    const int halvings = power < 0 ? 0 : power;
    const uint64_t factor = ((uint64_t(2) << (2 * F + halvings)) / divisor + 1) >> 1;
    if (factor >> (I + F - 1) != 0) return {Number(), 0};
    const bool doubles = power <= 0 && (divisor & (divisor - 1)) == 0;
    return {
        Number::from_raw(static_cast<typename Number::Raw>(doubles ? uint64_t(1) << F : factor)),
        static_cast<signed char>(doubles ? power - 1 : halvings)};
}
// Where the compiler knows the length, it divides, and nothing of this stays in flash.
template <int I, int F, class A>
ENGINE_INLINE Inverse<Fixed<I, F, A>> inverse_of(Fixed<I, F, A> a) {
    const auto raw = a.raw();
    return I + F <= 32 && __builtin_constant_p(raw) && raw > 0 ? inverse_by_quotient(a)
                                                               : inverse_by_digits(a);
}
template <int I, int F, class A>
ENGINE_INLINE Fixed<I, F, A> times(Fixed<I, F, A> a, const Inverse<Fixed<I, F, A>>& inverse) {
    signed char i = inverse.halvings;
    if (i < 0) {
        while (++i != 0) a += a;
    } else {
        a *= inverse.factor;
        for (; i != 0; --i) a = half(a);
    }
    return a;
}

template <class Scalar, int N>
__attribute__((noinline, cold)) void halve(Vector<Scalar, N>& v) {
    const auto n = unknown<unsigned char>(N);
    for (unsigned char i = 0; i < n; ++i) v[i] = half(v[i]);
}

// Scales v by a power of two such that its largest component lies in 1/4..1/2, hence 1/4 < |v| <
// 0.87. Zero stays zero.
template <int I, int F, class A, int N>
__attribute__((noinline, cold)) void bring_near_one(Vector<Fixed<I, F, A>, N>& v) {
    using Number = Fixed<I, F, A>;
    using Raw = typename Number::Raw;
    const auto quarter = Number::from_raw(static_cast<Raw>(Raw(1) << (F < 2 ? 0 : F - 2)));
    const auto n = unknown<unsigned char>(N);
    for (;;) {
        Number least = Number();  // -|v_i| of the largest; |v_i| itself may not fit
        for (unsigned char i = 0; i < n; ++i) {
            const Number below_zero = v[i] > Number() ? -v[i] : v[i];
            if (below_zero < least) least = below_zero;
        }
        if (least < -(quarter + quarter)) {
            halve(v);
        } else if (least < -quarter || least == Number()) {
            return;
        } else {
            for (unsigned char i = 0; i < n; ++i) v[i] += v[i];
        }
    }
}

// e = (v . v - 1) / 2, the amount by which |v| exceeds 1 when that is small.
template <class Scalar, int N>
ENGINE_INLINE Scalar excess_over_one(const Vector<Scalar, N>& v) {
    return half(squared_length(v) - Scalar(Decimal<1, 0>()));
}

// Normalises v, whose e is given: multiplies it by 1 - e + 3/2 e^2, which leaves an error of 5/2
// |e|^3 in the length. Returns the amount by which |v| exceeded 1.
template <class Scalar, int N>
__attribute__((noinline)) Scalar mend_length(Vector<Scalar, N>& v, Scalar e) {
    const Scalar square = e * e;
    const Scalar excess = e - half(square);
    v.add_scaled(v, square - excess);
    return excess;
}

// Up to this e, mend_length leaves an error of less than half an ulp.
template <class Number>
struct NearOne;
template <int I, int F, class A>
struct NearOne<Fixed<I, F, A>> {
    static constexpr Fixed<I, F, A> value() {
        using Raw = typename Fixed<I, F, A>::Raw;
        return Fixed<I, F, A>::from_raw(static_cast<Raw>(Raw(1) << (F < 2 ? 0 : F - (F + 5) / 3)));
    }
};

// The distance between two points and the unit direction along it, from an approximate direction
// and its e. Steps of third order converge for |e| <= 1/4, and from 1/4 of the length six suffice.
template <class Scalar, int N>
__attribute__((noinline, cold)) Scalar measure_by_steps(const Vector<Scalar, N>& first,
                                                        const Vector<Scalar, N>& second, Scalar e,
                                                        Vector<Scalar, N>& direction) {
    if (absolute(e) > Scalar(Decimal<25, 2>())) {
        const auto n = unknown<unsigned char>(N);
        for (unsigned char i = 0; i < n; ++i) direction[i] = first[i] - second[i];
        bring_near_one(direction);
        e = excess_over_one(direction);
    }
    for (unsigned char steps = 6; steps > 0; --steps) {
        mend_length(direction, e);
        if (absolute(e) < NearOne<Scalar>::value()) break;
        e = excess_over_one(direction);
    }
    return dot_difference(direction, first, second);
}

// v / length.
template <int I, int F, class A, int N>
ENGINE_INLINE void scale(Vector<Fixed<I, F, A>, N>& v, const Inverse<Fixed<I, F, A>>& inverse) {
    signed char i = inverse.halvings;
    if (i < 0) {
        while (++i != 0) v += v;
    } else {
        scale<N>(v.component, inverse.factor);
        for (; i != 0; --i) halve(v);
    }
}

// measure() from the direction (first - second) / length, and its e. An |e| of up to `little` stays
// in the direction.
template <int I, int F, class A, int N>
ENGINE_INLINE bool measure_scaled(const Vector<Fixed<I, F, A>, N>& first,
                                  const Vector<Fixed<I, F, A>, N>& second,
                                  const Fixed<I, F, A>& length,
                                  const Inverse<Fixed<I, F, A>>& inverse, Fixed<I, F, A> e,
                                  Fixed<I, F, A> little, Vector<Fixed<I, F, A>, N>& direction,
                                  Fixed<I, F, A>& excess) {
    using Number = Fixed<I, F, A>;
    if (inverse.halvings <= 0 && absolute(e) < NearOne<Number>::value()) {
        if (absolute(e) > little) e = mend_length(direction, e);
        excess = short_product(e, length);
        return true;
    }
    const Number distance = measure_by_steps(first, second, e, direction);
    excess = distance - length;
    return !(distance == Number());
}

// Computes the unit direction from the second point to the first, and by how much their distance
// exceeds `length`. Returns false where there is no direction: the points coincide or, if the link
// may be slack, are certainly closer than its length.
template <bool may_be_slack, class Scalar, int N>
bool measure(const Vector<Scalar, N>& first, const Vector<Scalar, N>& second, const Scalar& length,
             const Inverse<Scalar>&, Vector<Scalar, N>& direction, Scalar& excess) {
    direction = first - second;
    const Scalar distance = engine::length(direction);
    direction = divided(direction, distance);
    excess = distance - length;
    return !(distance == Scalar());
}
template <bool may_be_slack, int I, int F, class A, int N>
ENGINE_INLINE typename OnlyIf<RoundsOnce<A>::value, bool>::Type measure(
    const Vector<Fixed<I, F, A>, N>& first, const Vector<Fixed<I, F, A>, N>& second,
    const Fixed<I, F, A>& length, const Inverse<Fixed<I, F, A>>& inverse,
    Vector<Fixed<I, F, A>, N>& direction, Fixed<I, F, A>& excess) {
    using Number = Fixed<I, F, A>;
    direction = first - second;
    scale(direction, inverse);
    const Number e = excess_over_one(direction);
    if (may_be_slack && e < -NearOne<Number>::value()) return false;
    // A direction 1 + e long leaves 2 e of a row's change to the next step: by 4 ulp that is below
    // an ulp of each change below 1/8 m/s.
    const Number little = Number::from_raw(F >= 12 ? 4 : 0);
    return measure_scaled(first, second, length, inverse, e, little, direction, excess);
}

// The overlap of a contact or the slack of a rope, in m, that counts as rest: more than rounding
// moves a particle.
template <class Scalar>
struct RestingGap {
    static constexpr Scalar value() { return Decimal<1, 5>(); }
};
template <int I, int F, class A>
struct RestingGap<Fixed<I, F, A>> {
    static constexpr Fixed<I, F, A> value() { return Fixed<I, F, A>::from_raw(F >= 12 ? 8 : 1); }
};

/// \endcond

}  // namespace engine
