// SPDX-License-Identifier: MIT
/// \file
/// Matrices of two and three rows, whose products round once an element.
#pragma once

#include <fixedpoint/blocks/number.hpp>

namespace fixedpoint {

/// A square matrix of N rows, N 2 or 3.
template <class Number, uint8_t N>
struct Matrix {
    static_assert(N == 2 || N == 3, "A matrix has two or three rows.");
    /// element[i][j] stands in row i and column j.
    Number element[N][N];
};

/// \cond internal
// a d - b c, rounded once.
template <class Number>
Number minor_of(Number a, Number b, Number c, Number d) {
    const Number row[2] = {a, b}, column[2] = {d, -c};
    return BlockNumber<Number>::dot2(row, column);
}
/// \endcond

/// The product of a matrix and a column, each element rounded once; out of the range as the
/// arithmetic has it. `result` must not be `v`.
template <class Number, uint8_t N>
void multiply(const Matrix<Number, N>& a, const Number (&v)[N], Number (&result)[N]) {
    MatrixProduct<Number>::apply(a.element, v, result);
}
/// The product of two matrices, each element rounded once; out of the range as the arithmetic has
/// it.
template <class Number, uint8_t N>
Matrix<Number, N> operator*(const Matrix<Number, N>& a, const Matrix<Number, N>& b) {
    Matrix<Number, N> product;
    MatrixProduct<Number>::apply(a.element, b.element, product.element);
    return product;
}

/// The matrix of cofactors, transposed: a adjugate(a) is determinant(a) times the unit matrix. Each
/// element is rounded once; out of the range, and the negative of the smallest number, as the
/// arithmetic has it.
/// @{
template <class Number>
Matrix<Number, 2> adjugate(const Matrix<Number, 2>& a) {
    return {{{a.element[1][1], -a.element[0][1]}, {-a.element[1][0], a.element[0][0]}}};
}
template <class Number>
Matrix<Number, 3> adjugate(const Matrix<Number, 3>& a) {
    Matrix<Number, 3> result;
    for (uint8_t i = 0; i < 3; ++i) {
        // The cyclic order of the rows and columns that are left gives each cofactor its sign.
        const Number(&p)[3] = a.element[next_axis(i)];
        const Number(&q)[3] = a.element[last_axis(i)];
        for (uint8_t j = 0; j < 3; ++j) {
            const uint8_t k = next_axis(j), l = last_axis(j);
            result.element[j][i] = minor_of(p[k], p[l], q[k], q[l]);
        }
    }
    return result;
}
/// @}

/// \cond internal
template <class Number>
Number determinant_of(const Matrix<Number, 2>& a, const Matrix<Number, 2>&) {
    return minor_of(a.element[0][0], a.element[0][1], a.element[1][0], a.element[1][1]);
}
template <class Number>
Number determinant_of(const Matrix<Number, 3>& a, const Matrix<Number, 3>& adjugate) {
    const Number column[3] = {adjugate.element[0][0], adjugate.element[1][0],
                              adjugate.element[2][0]};
    return dot_of(a.element[0], column);
}
/// \endcond

/// The determinant. Of two rows it is rounded once; of three, its cofactors are too: with elements
/// up to m it is within (1 + 3 m) / 2 ulp. Out of the range as the arithmetic has it.
template <class Number, uint8_t N>
Number determinant(const Matrix<Number, N>& a) {
    return determinant_of(a, adjugate(a));
}

/// Computes the inverse and says whether there is one; where the determinant, rounded, is 0,
/// `inverse` stays as it was. Each element is the quotient of a cofactor and the determinant, both
/// rounded, and saturated: an error of e ulp in the determinant d makes one of e / |d| parts in
/// 2^F of the element, so that d should not be small. `inverse` may be `a`.
template <class Number, uint8_t N>
bool invert(const Matrix<Number, N>& a, Matrix<Number, N>& inverse) {
    const Matrix<Number, N> cofactors = adjugate(a);
    const Number d = determinant_of(a, cofactors);
    if (d == Number()) return false;
    for (uint8_t i = 0; i < N; ++i)
        for (uint8_t j = 0; j < N; ++j) inverse.element[i][j] = cofactors.element[i][j] / d;
    return true;
}

}  // namespace fixedpoint
