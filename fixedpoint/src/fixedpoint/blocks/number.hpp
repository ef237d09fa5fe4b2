// SPDX-License-Identifier: MIT
// BlockNumber<Number>: the operations that the blocks need from a number. For Fixed they are the
// library's operations that round once, for float and double the operators, so one block serves
// both.
#pragma once

#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/conversion.hpp>
#include <fixedpoint/math.hpp>
#include <fixedpoint/vector.hpp>

namespace fixedpoint {

// float and double.
template <class Number>
struct BlockNumber {
    using Saturated = Number;
    static constexpr Number saturated(Number a) { return a; }
    static constexpr Number plain(Number a) { return a; }
    static constexpr Number one() { return 1; }
    static constexpr Number half_of(Number a) { return a / 2; }
    static constexpr Number multiply_add(Number a, Number b, Number c) { return a * b + c; }
    static constexpr Number dot2(const Number* a, const Number* b) {
        return a[0] * b[0] + a[1] * b[1];
    }
    static constexpr Number dot3(const Number* a, const Number* b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
    template <class Other>
    static constexpr Number from(Other a) {
        return static_cast<Number>(a);
    }
};

// The blocks' bounds and limit cycles are those of rounding to nearest, half up.
enum class Rounding : unsigned char;
template <Rounding rounding>
struct Rounded;
struct Published;
template <class A>
struct RoundsHalfUp {
    static constexpr bool value = true;
};
template <Rounding rounding>
struct RoundsHalfUp<Rounded<rounding>> {
    static constexpr bool value = false;
};
template <>
struct RoundsHalfUp<Published> {
    static constexpr bool value = false;
};

template <int IntegerBits, int F, class A>
struct BlockNumber<Fixed<IntegerBits, F, A>> {
    static_assert(RoundsHalfUp<A>::value,
                  "A block takes an arithmetic that rounds to nearest, half up.");
    using Number = Fixed<IntegerBits, F, A>;
    using Raw = typename Number::Raw;
    static_assert(RawLimits<Raw>::is_signed, "A block takes a number with a sign.");
    // For values that must saturate instead of changing their sign, whatever the arithmetic.
    using Saturated = Fixed<IntegerBits, F, Saturating>;
    static constexpr Saturated saturated(Number a) { return Saturated::from_raw(a.raw()); }
    static constexpr Number plain(Saturated a) { return Number::from_raw(a.raw()); }

    // The largest number if the format cannot represent 1.
    static constexpr Number one() {
        return Number::from_raw(IntegerBits == 1 ? RawLimits<Raw>::max
                                                 : static_cast<Raw>(Unsigned<Raw>(1) << F));
    }
    static constexpr Number half_of(Number a) { return scale_down<1>(a); }
    static constexpr Number multiply_add(Number a, Number b, Number c) {
        return fixedpoint::multiply_add(a, b, c);
    }
    static Number dot2(const Number* a, const Number* b) { return fixedpoint::dot2(a, b); }
    static Number dot3(const Number* a, const Number* b) { return fixedpoint::dot3(a, b); }
    template <class Other>
    static constexpr Number from(Other a) {
        return convert<Number>(a);
    }
};

// Whether blocks have kernels of their own for every 32-bit format except Q16.16.
template <class Number>
struct SplitOf32 {
    static constexpr bool value = false;
};
template <int F>
struct SplitOf32<Fixed<32 - F, F>> {
    static constexpr bool value = kernel::has_assembly && F != 16;
};

template <class Number>
Number dot_of(const Number* a, const Number (&b)[2]) {
    return BlockNumber<Number>::dot2(a, b);
}
template <class Number>
Number dot_of(const Number* a, const Number (&b)[3]) {
    return BlockNumber<Number>::dot3(a, b);
}

// A matrix of N rows times the column v, and times another matrix, each element rounded once. N
// must be 2 or 3, and `result` must not be a factor.
template <class Number, bool in_kernel = kernel::has_assembly && sizeof(Number) == 4>
struct MatrixProduct {
    template <uint8_t N>
    static void apply(const Number (&m)[N][N], const Number (&v)[N], Number (&result)[N]) {
        for (uint8_t i = 0; i < N; ++i) result[i] = dot_of(m[i], v);
    }
    template <uint8_t N>
    static void apply(const Number (&a)[N][N], const Number (&b)[N][N], Number (&result)[N][N]) {
        for (uint8_t j = 0; j < N; ++j) {
            Number column[N];
            for (uint8_t i = 0; i < N; ++i) column[i] = b[i][j];
            for (uint8_t i = 0; i < N; ++i) result[i][j] = dot_of(a[i], column);
        }
    }
};
// In one call of a kernel for all elements; 2x2 products have a kernel of their own.
template <int IntegerBits, int F>
struct MatrixProduct<Fixed<IntegerBits, F>, true> {
    using Number = Fixed<IntegerBits, F>;
    using Raw = typename Number::Raw;
    template <uint8_t N>
    static void apply(const Number (&m)[N][N], const Number (&v)[N], Number (&result)[N]) {
        kernel::transform<Raw, F>(raws(result), raws(v), raws(m[0]), N);
    }
    template <uint8_t N>
    static void apply(const Number (&a)[N][N], const Number (&b)[N][N], Number (&result)[N][N]) {
        kernel::matrix_product<Raw, F>(raws(result[0]), raws(a[0]), raws(b[0]), N);
    }
    static void apply(const Number (&a)[2][2], const Number (&b)[2][2], Number (&result)[2][2]) {
        kernel::matrix_product_2<Raw, F>(raws(result[0]), raws(a[0]), raws(b[0]));
    }
};

// The axes of space after and before i = 0, 1, 2 in cyclic order.
constexpr uint8_t next_axis(uint8_t i) { return i == 2 ? uint8_t(0) : static_cast<uint8_t>(i + 1); }
constexpr uint8_t last_axis(uint8_t i) { return i == 0 ? uint8_t(2) : static_cast<uint8_t>(i - 1); }

// The cross product of two vectors, each component rounded once; the cofactors of a matrix, whose
// row i is the cross product of the two rows that follow row i; and a rotation, v + w t + u x t,
// where t = 2 u x v and (w, u) = q. `cross` must not be a factor and `cofactors` must not be m;
// `rotated` may be v.
template <class Number>
struct SpaceProduct {
    static void cross(const Number* a, const Number* b, Number* cross) {
        for (uint8_t i = 0; i < 3; ++i) {
            const uint8_t j = next_axis(i), k = last_axis(i);
            const Number p[2] = {a[j], a[k]}, q[2] = {b[k], -b[j]};
            cross[i] = BlockNumber<Number>::dot2(p, q);
        }
    }
    static void cofactors(const Number (&m)[3][3], Number (&cofactors)[3][3]) {
        for (uint8_t i = 0; i < 3; ++i) cross(m[next_axis(i)], m[last_axis(i)], cofactors[i]);
    }
    static void rotate(const Number* q, const Number* v, Number* rotated) {
        const Number* const u = q + 1;
        Number t[3], turned[3];
        cross(u, v, t);
        for (uint8_t i = 0; i < 3; ++i) t[i] += t[i];
        for (uint8_t i = 0; i < 3; ++i) {
            const uint8_t j = next_axis(i), k = last_axis(i);
            const Number a[3] = {q[0], u[j], u[k]}, b[3] = {t[i], t[k], -t[j]};
            turned[i] = v[i] + BlockNumber<Number>::dot3(a, b);
        }
        for (uint8_t i = 0; i < 3; ++i) rotated[i] = turned[i];
    }
};
// With one kernel call for all three components. The arrays are of raws, since numbers would first
// be set to 0.
template <int F>
struct SpaceProduct<Fixed<32 - F, F>> {
    using Number = Fixed<32 - F, F>;
    static void cross(const Number* a, const Number* b, Number* cross) {
        kernel::cross<int32_t, F>(raws(cross), raws(a), raws(b));
    }
    static void cofactors(const Number (&m)[3][3], Number (&cofactors)[3][3]) {
        kernel::cofactors<int32_t, F>(raws(m[0]), raws(cofactors[0]));
    }
    static void rotate(const Number* q, const Number* v, Number* rotated) {
        int32_t t[3], turned[3];
        kernel::twice_cross<int32_t, F>(t, raws(q + 1), raws(v));
        kernel::quaternion_times_vector<int32_t, F>(turned, raws(q), t);
        rotated[0] = v[0] + Number::from_raw(turned[0]);
        rotated[1] = v[1] + Number::from_raw(turned[1]);
        rotated[2] = v[2] + Number::from_raw(turned[2]);
    }
};

}  // namespace fixedpoint
