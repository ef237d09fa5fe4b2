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

/// The product a b: the rotation by b, then by a. Each part within 1 ulp; out of the range as the
/// arithmetic has it. The format needs 3 integer bits, the sign among them, for two of length 1.
template <class Number>
Quaternion<Number> operator*(const Quaternion<Number>& a, const Quaternion<Number>& b) {
    const Number w = b.part[0], x = b.part[1], y = b.part[2], z = b.part[3];
    const Number of_w[4] = {w, -x, -y, -z}, of_x[4] = {x, w, z, -y};
    const Number of_y[4] = {y, -z, w, x}, of_z[4] = {z, y, -x, w};
    return {{dot4(a.part, of_w), dot4(a.part, of_x), dot4(a.part, of_y), dot4(a.part, of_z)}};
}

/// The conjugate, of a rotation the inverse; negatives of the smallest number as the arithmetic has
/// them.
template <class Number>
Quaternion<Number> conjugate(const Quaternion<Number>& a) {
    return {{a.part[0], -a.part[1], -a.part[2], -a.part[3]}};
}

/// a as a quaternion of length 1, by one step of Newton's method: a + a (1 - |a|^2) / 2. One of
/// length 1 + d, d small, becomes one of length 1 - 3/2 d^2. After each product it keeps the length
/// within 2 ulp of 1 for ever; it does not bring one back whose length is beyond sqrt(3), nor
/// one whose squared length leaves the range.
template <class Number>
Quaternion<Number> renormalised(const Quaternion<Number>& a) {
    using N = BlockNumber<Number>;
    const Number correction = N::half_of(N::one() - dot4(a.part, a.part));
    Quaternion<Number> result;
    for (uint8_t i = 0; i < 4; ++i)
        result.part[i] = N::multiply_add(a.part[i], correction, a.part[i]);
    return result;
}

/// The vector v, rotated by q of length 1: v + w t + u x t, where t = 2 u x v and u is (x, y, z) of
/// q. Each component is within 2.3 ulp and what q lacks in length; the format needs to hold 4 |v|.
/// `result` may be `v`.
template <class Number>
void rotate(const Quaternion<Number>& q, const Number (&v)[3], Number (&result)[3]) {
    using N = BlockNumber<Number>;
    const Number* const u = q.part + 1;
    Number t[3], rotated[3];
    for (uint8_t i = 0; i < 3; ++i) {
        const uint8_t j = next_axis(i), k = last_axis(i);
        const Number a[2] = {u[j], u[k]}, b[2] = {v[k], -v[j]};
        const Number half = N::dot2(a, b);
        t[i] = half + half;
    }
    for (uint8_t i = 0; i < 3; ++i) {
        const uint8_t j = next_axis(i), k = last_axis(i);
        const Number a[3] = {q.part[0], u[j], u[k]}, b[3] = {t[i], t[k], -t[j]};
        rotated[i] = v[i] + N::dot3(a, b);
    }
    for (uint8_t i = 0; i < 3; ++i) result[i] = rotated[i];
}

}  // namespace fixedpoint
