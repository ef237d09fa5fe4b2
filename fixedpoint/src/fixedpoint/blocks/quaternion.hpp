// SPDX-License-Identifier: MIT
/// \file
/// Quaternions for rotations in space, and the step that keeps their length at 1.
#pragma once

#include <fixedpoint/blocks/number.hpp>

namespace fixedpoint {

/// The quaternion w + i x + j y + k z. One of length 1 is a rotation: cos(a/2) + sin(a/2) (i u + j
/// v + k t) rotates by the angle a about the unit vector (u, v, t).
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

/// The product a b: the rotation by b, then by a. Each part is within 1 ulp, and rounded once in
/// the default arithmetic in 32 bits. If a part is out of range, the arithmetic decides. For two
/// quaternions of length 1 the format needs 3 integer bits, including the sign.
template <class Number>
Quaternion<Number> operator*(const Quaternion<Number>& a, const Quaternion<Number>& b) {
    Quaternion<Number> product;
    QuaternionProduct<Number>::apply(a.part, b.part, product.part);
    return product;
}

/// The conjugate, which is the inverse of a rotation. If a part is the smallest number, the
/// arithmetic decides on its negative.
template <class Number>
Quaternion<Number> conjugate(const Quaternion<Number>& a) {
    return {{a.part[0], -a.part[1], -a.part[2], -a.part[3]}};
}

/// \cond internal
// The kernel of every 32-bit format except Q16.16: a_i += a_i b, each product rounded once.
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
// Selects one of two overloads: a call from one into the other would cost the short formats.
template <class Number, bool in_kernel = SplitOf32<Number>::value>
struct Renormalised {
    using Quaternion = fixedpoint::Quaternion<Number>;
};
template <class Number>
struct Renormalised<Number, true> {
    using QuaternionByKernel = Quaternion<Number>;
};
/// \endcond

/// a scaled towards length 1 by one step of Newton's method: a + a (1 - |a|^2) / 2. For small d, a
/// length of 1 + d becomes 1 - 3/2 d^2. Applied after each product, it keeps the length within 2
/// ulp of 1 forever. It does not correct a length above sqrt(3), nor one whose square is out of
/// range.
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

/// Writes the vector v, rotated by q, to `result`: v + w t + u x t, where t = 2 u x v and u is (x,
/// y, z) of q. q must have length 1, and 4 |v| must be in range. Each component is within 2.3 ulp,
/// or 1.4 ulp in the default arithmetic in 32 bits, plus the error that the length of q causes.
/// `result` may be `v`.
template <class Number>
void rotate(const Quaternion<Number>& q, const Number (&v)[3], Number (&result)[3]) {
    SpaceProduct<Number>::rotate(q.part, v, result);
}

}  // namespace fixedpoint
