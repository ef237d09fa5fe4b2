// SPDX-License-Identifier: MIT
/// \file
/// 2x2 and 3x3 matrices. Each element of a product is rounded once.
#pragma once

#include <fixedpoint/blocks/number.hpp>

extern "C" uint8_t fixedpoint_invert2_q16_16(const int32_t* a, int32_t* inverse);

namespace fixedpoint {

/// A square matrix of N rows; N must be 2 or 3.
template <class Number, uint8_t N>
struct Matrix {
    static_assert(N == 2 || N == 3, "A matrix must have two or three rows.");
    /// element[i][j] is in row i and column j.
    Number element[N][N];
};

/// result = a v, the product of a matrix and a column vector, each element rounded once. If an
/// element is out of range, the arithmetic decides. `result` must not be `v`.
template <class Number, uint8_t N>
void multiply(const Matrix<Number, N>& a, const Number (&v)[N], Number (&result)[N]) {
    MatrixProduct<Number>::apply(a.element, v, result);
}
/// result = a b, each element rounded once. If an element is out of range, the arithmetic decides.
/// `result` must not be `a` or `b`.
template <class Number, uint8_t N>
void multiply(const Matrix<Number, N>& a, const Matrix<Number, N>& b, Matrix<Number, N>& result) {
    MatrixProduct<Number>::apply(a.element, b.element, result.element);
}
/// The product of two matrices, each element rounded once. If an element is out of range, the
/// arithmetic decides. `multiply` avoids the copy of an assignment.
template <class Number, uint8_t N>
Matrix<Number, N> operator*(const Matrix<Number, N>& a, const Matrix<Number, N>& b) {
    Matrix<Number, N> product;
    multiply(a, b, product);
    return product;
}

/// \cond internal
template <class Number>
void cofactors(const Matrix<Number, 2>& a, Matrix<Number, 2>& result) {
    result.element[0][0] = a.element[1][1];
    result.element[0][1] = -a.element[1][0];
    result.element[1][0] = -a.element[0][1];
    result.element[1][1] = a.element[0][0];
}
template <class Number>
void cofactors(const Matrix<Number, 3>& a, Matrix<Number, 3>& result) {
    SpaceProduct<Number>::cofactors(a.element, result.element);
}
// The cofactors of a. A union, since the numbers of a Matrix would first be set to 0.
template <class Number, uint8_t N>
union Cofactors {
    explicit Cofactors(const Matrix<Number, N>& a) { cofactors(a, matrix); }
    Matrix<Number, N> matrix;

    Number determinant(const Matrix<Number, N>& a) const {
        return dot_of(a.element[0], matrix.element[0]);
    }
};
/// \endcond

/// The transposed matrix of cofactors: a adjugate(a) is determinant(a) times the identity matrix.
/// Each element is rounded once. If an element, or the negative of one, is out of range, the
/// arithmetic decides.
template <class Number, uint8_t N>
Matrix<Number, N> adjugate(const Matrix<Number, N>& a) {
    const Cofactors<Number, N> c(a);
    Matrix<Number, N> result;
    for (uint8_t i = 0; i < N; ++i)
        for (uint8_t j = 0; j < N; ++j) result.element[j][i] = c.matrix.element[i][j];
    return result;
}

/// The determinant. For two rows it is rounded once. For three, the cofactors are rounded too: if
/// no element exceeds m in magnitude, the result is within (1 + 3 m) / 2 ulp. If it is out of
/// range, the arithmetic decides.
template <class Number, uint8_t N>
Number determinant(const Matrix<Number, N>& a) {
    return Cofactors<Number, N>(a).determinant(a);
}

/// \cond internal
// The kernels of every 32-bit format except Q16.16.
template <int F>
struct QuotientsKernel;
#define FIXEDPOINT_QUOTIENTS_KERNEL(KERNEL, shape, name, I, F)                               \
    extern "C" void fixedpoint_transposed_quotients_q##I##_##F(int32_t* q, const int32_t* a, \
                                                               int32_t d, uint8_t n);        \
    template <>                                                                              \
    struct QuotientsKernel<F> {                                                              \
        static void apply(int32_t* q, const int32_t* a, int32_t d, uint8_t n) {              \
            fixedpoint_transposed_quotients_q##I##_##F(q, a, d, n);                          \
        }                                                                                    \
    };
FIXEDPOINT_SPLITS_32(FIXEDPOINT_QUOTIENTS_KERNEL, , , )
#undef FIXEDPOINT_QUOTIENTS_KERNEL

// result_ij = a_ji / d. d must not be 0.
template <class Number, bool in_kernel = SplitOf32<Number>::value>
struct TransposedQuotients {
    template <uint8_t N>
    static void apply(const Matrix<Number, N>& a, Number d, Matrix<Number, N>& result) {
        const Number* const first = a.element[0];
        const Number* from = first;
        Number *to = result.element[0], *const end = to + N * N;
        do {
            *to = *from / d;
            from += N;
            if (from >= first + N * N) from -= N * N - 1;
        } while (++to != end);
    }
};
// In one call, which computes the reciprocal of d once.
template <int F>
struct TransposedQuotients<Fixed<32 - F, F>, true> {
    using Number = Fixed<32 - F, F>;
    template <uint8_t N>
    static void apply(const Matrix<Number, N>& a, Number d, Matrix<Number, N>& result) {
        QuotientsKernel<F>::apply(raws(result.element[0]), raws(a.element[0]), d.raw(), N);
    }
};
/// \endcond

/// Computes the inverse and returns whether there is one; if the rounded determinant is 0,
/// `inverse` is left unchanged. Each element is the quotient of a cofactor and the determinant,
/// both rounded; the quotient saturates. An error of e ulp in the determinant d causes a relative
/// error of e / |d| parts in 2^F in each element, so d should not be small. `inverse` may be `a`.
template <class Number, uint8_t N>
bool invert(const Matrix<Number, N>& a, Matrix<Number, N>& inverse) {
    const Cofactors<Number, N> c(a);
    const Number d = c.determinant(a);
    if (d == Number()) return false;
    TransposedQuotients<Number>::apply(c.matrix, d, inverse);
    return true;
}
/// \cond internal
// Unrolled: for four elements a loop costs more than it saves.
template <int F>
struct Invert2Kernel;
#define FIXEDPOINT_INVERT2_KERNEL(KERNEL, shape, name, I, F)                              \
    extern "C" uint8_t fixedpoint_invert2_q##I##_##F(const int32_t* a, int32_t* inverse); \
    template <>                                                                           \
    struct Invert2Kernel<F> {                                                             \
        static bool apply(const int32_t* a, int32_t* inverse) {                           \
            return fixedpoint_invert2_q##I##_##F(a, inverse);                             \
        }                                                                                 \
    };
FIXEDPOINT_SPLITS_32(FIXEDPOINT_INVERT2_KERNEL, , , )
#undef FIXEDPOINT_INVERT2_KERNEL
template <class Number, bool in_kernel = kernel::has_assembly && sizeof(Number) == 4>
struct Inverse2 {
    static bool apply(const Matrix<Number, 2>& a, Matrix<Number, 2>& inverse) {
        const Cofactors<Number, 2> c(a);
        const Number d = c.determinant(a);
        if (d == Number()) return false;
        inverse.element[0][0] = c.matrix.element[0][0] / d;
        inverse.element[0][1] = c.matrix.element[1][0] / d;
        inverse.element[1][0] = c.matrix.element[0][1] / d;
        inverse.element[1][1] = c.matrix.element[1][1] / d;
        return true;
    }
};
template <int F>
struct Inverse2<Fixed<32 - F, F>, true> {
    using Matrix2 = Matrix<Fixed<32 - F, F>, 2>;
    static bool apply(const Matrix2& a, Matrix2& inverse) {
        if (&a == &inverse) return apply(Matrix2(a), inverse);
        return Invert2Kernel<F>::apply(raws(a.element[0]), raws(inverse.element[0]));
    }
};
template <>
struct Inverse2<Fixed<16, 16>, true> {
    using Matrix2 = Matrix<Fixed<16, 16>, 2>;
    static bool apply(const Matrix2& a, Matrix2& inverse) {
        return fixedpoint_invert2_q16_16(raws(a.element[0]), raws(inverse.element[0]));
    }
};
template <class Number>
bool invert(const Matrix<Number, 2>& a, Matrix<Number, 2>& inverse) {
    return Inverse2<Number>::apply(a, inverse);
}
/// \endcond

}  // namespace fixedpoint
