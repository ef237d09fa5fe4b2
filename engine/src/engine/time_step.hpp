// SPDX-License-Identifier: MIT
/// \file
/// BinaryStep<K>: a time step of 2^-K s. In every format, products with it are more accurate than
/// with a rounded 0.001, and a shift takes a quarter of a multiplication's time. A scalar in
/// seconds is a time step, too.
#pragma once

#include <engine/scalar.hpp>

namespace engine {

/// A time step of 2^-K s. K must be in 0..59.
template <int K>
struct BinaryStep {
    static_assert(K >= 0 && K < 60, "A binary step is 2^-K seconds: K must be in 0..59.");
};

/// Whether T is a time step other than a scalar in seconds: such a type reaches the integrators
/// unchanged. To add one, specialise this and provide half(T), a product with the scalar on the
/// left, and a conversion to the scalar.
template <class T>
struct IsTimeStep {
    /// Whether it is one.
    static constexpr bool value = false;
};
/// \cond internal
template <int K>
struct IsTimeStep<BinaryStep<K>> {
    static constexpr bool value = true;
};
/// \endcond

/// \cond internal
// A step in seconds as a scalar.
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
        static_assert(I > 1 || K > 0, "A step of 1 s does not fit a format of one integer bit.");
        using Raw = typename Number::Raw;
        // Half an ulp rounds up to one ulp, less to 0.
        return Number::from_raw(F >= K ? static_cast<Raw>(Raw(1) << (F >= K ? F - K : 0))
                                       : Raw(F + 1 == K));
    }
    static constexpr Number of(Number dt) { return dt; }
};
/// \endcond
/// A step in seconds, rounded to the scalar: half an ulp becomes one ulp, a shorter step 0.
template <class Scalar, class TimeStep>
constexpr Scalar seconds(TimeStep dt) {
    return Seconds<Scalar>::of(dt);
}

/// Half of a step.
template <int K>
constexpr BinaryStep<K + 1> half(BinaryStep<K>) {
    return {};
}
/// \cond internal
template <class Scalar>
constexpr Scalar half(Scalar dt) {
    return dt * (Scalar(1) / Scalar(2));
}
template <int I, int F, class A>
constexpr Fixed<I, F, A> half(Fixed<I, F, A> dt) {
    return dt >> 1;
}
/// \endcond

/// The product of a scalar and the step in seconds, rounded.
template <class Scalar, int K>
constexpr auto operator*(Scalar a, BinaryStep<K>) -> decltype(Scalar(1) / a) {
    return a * seconds<Scalar>(BinaryStep<K>());
}
/// \cond internal
template <int I, int F, class A, int K>
constexpr Fixed<I, F, A> operator*(Fixed<I, F, A> a, BinaryStep<K>) {
    return fixedpoint::scale_down<K>(a);
}
/// \endcond

/// floor((a + residual) / 2^count), where the sum saturates; the remainder, in units of an ulp,
/// becomes the new residual. `count` must be less than the width of the format. For the largest
/// `count`, nothing is carried.
template <int I, int F, class A>
FIXEDPOINT_CONSTEXPR Fixed<I, F, A> carried_shift(Fixed<I, F, A> a, unsigned char count,
                                                  Fixed<I, F, A>& residual) {
    using Raw = typename Fixed<I, F, A>::Raw;
    const auto sum = saturating_sum(a, residual);
    const auto whole = sum >> count;
    const bool holds = count < I + F - 1;
    residual = Fixed<I, F, A>::from_raw(
        holds ? static_cast<Raw>(sum.raw() & ((Raw(1) << (holds ? count : 0)) - 1)) : Raw(0));
    return whole;
}
/// a dt; the part below one ulp is carried in `residual` to the next product, so that nothing is
/// lost over many binary steps. With every other step and every other scalar the product is rounded
/// and `residual` is not used.
template <class Scalar, class TimeStep>
constexpr Scalar carried_product(Scalar a, TimeStep dt, Scalar&) {
    return a * dt;
}
/// \cond internal
template <int I, int F, class A, int K>
constexpr Fixed<I, F, A> carried_product(Fixed<I, F, A> a, BinaryStep<K>,
                                         Fixed<I, F, A>& residual) {
    return carried_shift(a, K, residual);
}
/// \endcond

}  // namespace engine
