// SPDX-License-Identifier: GPL-3.0-or-later
// PowerOfTwoStep: 2^-exponent s, like engine::BinaryStep, but chosen at run time, so that the host
// needs one instance of a scene for all time steps. Its products are bit for bit those of
// BinaryStep, as the comparison with the chip shows.
#pragma once

#include <cstdint>
#include <engine/scalar.hpp>
#include <engine/time_step.hpp>

namespace scene_bench {

struct PowerOfTwoStep {
    int exponent;

    // The step in seconds as a scalar.
    template <class Scalar>
    operator Scalar() const {
        return seconds(static_cast<const Scalar*>(nullptr));
    }

  private:
    template <class Scalar>
    Scalar seconds(const Scalar*) const {
        return Scalar(1) / Scalar(std::int64_t(1) << exponent);
    }
    template <int I, int F, class A>
    fixedpoint::Fixed<I, F, A> seconds(const fixedpoint::Fixed<I, F, A>*) const;
};

inline PowerOfTwoStep half(PowerOfTwoStep dt) { return {dt.exponent + 1}; }

template <class Scalar>
Scalar operator*(Scalar a, PowerOfTwoStep dt) {
    return a * static_cast<Scalar>(dt);
}
template <int I, int F, class A>
fixedpoint::Fixed<I, F, A> operator*(fixedpoint::Fixed<I, F, A> a, PowerOfTwoStep dt) {
    using Raw = typename fixedpoint::Fixed<I, F, A>::Raw;
    if (dt.exponent == 0) return a;
    if (dt.exponent > I + F) return {};
    const Raw doubled = static_cast<Raw>(a.raw() >> (dt.exponent - 1));
    return fixedpoint::Fixed<I, F, A>::from_raw(
        static_cast<Raw>((static_cast<std::int64_t>(doubled >> 1)) + (doubled & 1)));
}

// With compensated integration, as for BinaryStep.
template <int I, int F, class A>
fixedpoint::Fixed<I, F, A> carried_product(fixedpoint::Fixed<I, F, A> a, PowerOfTwoStep dt,
                                           fixedpoint::Fixed<I, F, A>& residual) {
    return engine::carried_shift(a, static_cast<unsigned char>(dt.exponent), residual);
}

template <int I, int F, class A>
fixedpoint::Fixed<I, F, A> PowerOfTwoStep::seconds(const fixedpoint::Fixed<I, F, A>*) const {
    return fixedpoint::Fixed<I, F, A>::from_raw(typename fixedpoint::Fixed<I, F, A>::Raw(1) << F) *
           *this;
}

}  // namespace scene_bench

template <>
struct engine::IsTimeStep<scene_bench::PowerOfTwoStep> {
    static constexpr bool value = true;
};
