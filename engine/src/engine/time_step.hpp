// SPDX-License-Identifier: MIT
// BinaryStep<K>: a time step of 2^-K s. Every format holds products with it more exactly than with
// a rounded 0.001, and a shift is four times as fast as a multiplication. A plain scalar in seconds
// works as a time step too.
#pragma once

#include <engine/scalar.hpp>

namespace engine {

template <int K>
struct BinaryStep {
    static_assert(K >= 0 && K < 60, "A binary step is 2^-K seconds, K from 0 to 59.");
};

// The integer floor(a / 2^K + 1/2), for every a.
template <int K, class Raw>
constexpr Raw shift_nearest_plain(Raw a) {
    return K == 0 ? a : K > fixedpoint::width_of<Raw> ? 0 : ((a >> (K - 1)) + 1) >> 1;
}
#ifdef __AVR__
// Whole bytes first, then bit by bit: left to itself the compiler shifts in a loop of K rounds.
template <int K, class Raw>
inline Raw shift_nearest_by_bytes(Raw a) {
    constexpr unsigned char bits = K - 1;
    a >>= bits / 8 * 8;
    for (unsigned char i = 0; i < bits % 8; ++i) {
        a >>= 1;
        __asm__("" : "+r"(a));
    }
    a += 1;
    __asm__("" : "+r"(a));
    return a >> 1;
}
template <int K, class Raw>
constexpr Raw shift_nearest(Raw a) {
    return K == 0 || K > fixedpoint::width_of<Raw> || __builtin_constant_p(a)
               ? shift_nearest_plain<K>(a)
               : shift_nearest_by_bytes<(K == 0 || K > fixedpoint::width_of<Raw> ? 1 : K)>(a);
}
#else
template <int K, class Raw>
constexpr Raw shift_nearest(Raw a) {
    return shift_nearest_plain<K>(a);
}
#endif

// A step in seconds, as a scalar holds it.
template <class Scalar>
struct Seconds {
    template <int K>
    static constexpr Scalar of(BinaryStep<K>) {
        return Scalar(1) / Scalar(int64_t(1) << K);
    }
    static constexpr Scalar of(Scalar dt) { return dt; }
};
template <int I, int F, class A>
struct Seconds<Fixed<I, F, A>> {
    using Number = Fixed<I, F, A>;
    template <int K>
    static constexpr Number of(BinaryStep<K>) {
        return Number::from_raw(shift_nearest<K>(typename Number::Raw(1) << F));
    }
    static constexpr Number of(Number dt) { return dt; }
};
template <class Scalar, class TimeStep>
constexpr Scalar seconds(TimeStep dt) {
    return Seconds<Scalar>::of(dt);
}

// Half of a step.
template <int K>
constexpr BinaryStep<K + 1> half(BinaryStep<K>) {
    return {};
}
template <class Scalar>
constexpr Scalar half(Scalar dt) {
    return dt * (Scalar(1) / Scalar(2));
}
template <int I, int F, class A>
constexpr Fixed<I, F, A> half(Fixed<I, F, A> dt) {
    return dt >> 1;
}

template <class Scalar, int K>
constexpr Scalar operator*(Scalar a, BinaryStep<K>) {
    return a * seconds<Scalar>(BinaryStep<K>());
}
template <int I, int F, class A, int K>
constexpr Fixed<I, F, A> operator*(Fixed<I, F, A> a, BinaryStep<K>) {
    return Fixed<I, F, A>::from_raw(shift_nearest<K>(a.raw()));
}

}  // namespace engine
