// SPDX-License-Identifier: MIT
/// \file
/// Quaternions for rotations in space, and the step that keeps them of length 1.
#pragma once

#include <fixedpoint/blocks/number.hpp>

namespace fixedpoint {

/// The quaternion w + i x + j y + k z. One of length 1 is a rotation: by the angle a about the unit
/// vector (u, v, t), cos(a/2) + sin(a/2) (i u + j v + k t).
template <class Number>
struct Quaternion {
    /// w, x, y, z.
    Number part[4];
};

/// \cond internal
template <class Number>
Number dot4(const Number* a, const Number* b) {
    using N = BlockNumber<Number>;
    return N::multiply_add(a[3], b[3], N::dot3(a, b));
}
/// \endcond

/// \cond internal
template <class Number>
struct QuaternionProduct {
    static void apply(const Number* a, const Number* b, Number* result) {
        const Number w = b[0], x = b[1], y = b[2], z = b[3];
        const Number of_w[4] = {w, -x, -y, -z}, of_x[4] = {x, w, z, -y};
        const Number of_y[4] = {y, -z, w, x}, of_z[4] = {z, y, -x, w};
        result[0] = dot4(a, of_w);
        result[1] = dot4(a, of_x);
        result[2] = dot4(a, of_y);
        result[3] = dot4(a, of_z);
    }
};
template <int F>
struct QuaternionProduct<Fixed<32 - F, F>> {
    using Number = Fixed<32 - F, F>;
    static void apply(const Number* a, const Number* b, Number* result) {
        kernel::quaternion_product<int32_t, F>(raws(result), raws(a), raws(b));
    }
};
/// \endcond

/// The product a b: the rotation by b, then by a. Each part within 1 ulp, and rounded once in the
/// default arithmetic of 32 bits; out of the range as the arithmetic has it. The format needs 3
/// integer bits, the sign among them, for two of length 1.
template <class Number>
Quaternion<Number> operator*(const Quaternion<Number>& a, const Quaternion<Number>& b) {
    Quaternion<Number> product;
    QuaternionProduct<Number>::apply(a.part, b.part, product.part);
    return product;
}

/// The conjugate, of a rotation the inverse; negatives of the smallest number as the arithmetic has
/// them.
template <class Number>
Quaternion<Number> conjugate(const Quaternion<Number>& a) {
    return {{a.part[0], -a.part[1], -a.part[2], -a.part[3]}};
}

/// \cond internal
// The kernel of each split of 32 bits but Q16.16: a_i += a_i b, each product rounded once.
template <int F>
struct Amplify4Kernel;
#define FIXEDPOINT_AMPLIFY4_KERNEL(KERNEL, shape, name, I, F)                              \
    extern "C" void fixedpoint_amplify4_q##I##_##F(int32_t* a, int32_t b);                 \
    template <>                                                                            \
    struct Amplify4Kernel<F> {                                                             \
        static void apply(int32_t* a, int32_t b) { fixedpoint_amplify4_q##I##_##F(a, b); } \
    };
FIXEDPOINT_SPLITS_32(FIXEDPOINT_AMPLIFY4_KERNEL, , , )
#undef FIXEDPOINT_AMPLIFY4_KERNEL
// Which of two functions there is: a call from one into the other would cost the short formats.
template <class Number, bool in_kernel = SplitOf32<Number>::value>
struct Renormalised {
    using Quaternion = fixedpoint::Quaternion<Number>;
};
template <class Number>
struct Renormalised<Number, true> {
    using QuaternionByKernel = Quaternion<Number>;
};
/// \endcond

/// a as a quaternion of length 1, by one step of Newton's method: a + a (1 - |a|^2) / 2. One of
/// length 1 + d, d small, becomes one of length 1 - 3/2 d^2. After each product it keeps the length
/// within 2 ulp of 1 for ever; it does not bring one back whose length is beyond sqrt(3), nor
/// one whose squared length leaves the range.
template <class Number>
typename Renormalised<Number>::Quaternion renormalised(const Quaternion<Number>& a) {
    using N = BlockNumber<Number>;
    const Number correction = N::half_of(N::one() - dot4(a.part, a.part));
    Quaternion<Number> result;
    for (uint8_t i = 0; i < 4; ++i)
        result.part[i] = N::multiply_add(a.part[i], correction, a.part[i]);
    return result;
}

/// \cond internal
template <class Number>
typename Renormalised<Number>::QuaternionByKernel renormalised(const Quaternion<Number>& a) {
    using N = BlockNumber<Number>;
    const Number correction = N::half_of(N::one() - dot4(a.part, a.part));
    Quaternion<Number> result = {{a.part[0], a.part[1], a.part[2], a.part[3]}};
    Amplify4Kernel<Number::fraction_bits>::apply(raws(result.part), correction.raw());
    return result;
}
/// \endcond

/// The vector v, rotated by q of length 1: v + w t + u x t, where t = 2 u x v and u is (x, y, z) of
/// q. Each component is within 2.3 ulp and what q lacks in length, in the default arithmetic of 32
/// bits within 1.4 ulp; the format needs to hold 4 |v|. `result` may be `v`.
template <class Number>
void rotate(const Quaternion<Number>& q, const Number (&v)[3], Number (&result)[3]) {
    SpaceProduct<Number>::rotate(q.part, v, result);
}

}  // namespace fixedpoint
