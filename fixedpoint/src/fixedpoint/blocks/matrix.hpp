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

/// \cond internal
// The matrix of cofactors: the row i of three is the cross product of the rows behind row i.
template <class Number>
Matrix<Number, 2> cofactors(const Matrix<Number, 2>& a) {
    return {{{a.element[1][1], -a.element[1][0]}, {-a.element[0][1], a.element[0][0]}}};
}
template <class Number>
Matrix<Number, 3> cofactors(const Matrix<Number, 3>& a) {
    Matrix<Number, 3> result;
    for (uint8_t i = 0; i < 3; ++i)
        SpaceProduct<Number>::cross(a.element[next_axis(i)], a.element[last_axis(i)],
                                    result.element[i]);
    return result;
}
template <class Number, uint8_t N>
Number determinant_of(const Matrix<Number, N>& a, const Matrix<Number, N>& cofactors) {
    return dot_of(a.element[0], cofactors.element[0]);
}
/// \endcond

/// The matrix of cofactors, transposed: a adjugate(a) is determinant(a) times the unit matrix. Each
/// element is rounded once; out of the range, and the negative of the smallest number, as the
/// arithmetic has it.
template <class Number, uint8_t N>
Matrix<Number, N> adjugate(const Matrix<Number, N>& a) {
    const Matrix<Number, N> c = cofactors(a);
    Matrix<Number, N> result;
    for (uint8_t i = 0; i < N; ++i)
        for (uint8_t j = 0; j < N; ++j) result.element[j][i] = c.element[i][j];
    return result;
}

/// The determinant. Of two rows it is rounded once; of three, its cofactors are too: with elements
/// up to m it is within (1 + 3 m) / 2 ulp. Out of the range as the arithmetic has it.
template <class Number, uint8_t N>
Number determinant(const Matrix<Number, N>& a) {
    return determinant_of(a, cofactors(a));
}

/// Computes the inverse and says whether there is one; where the determinant, rounded, is 0,
/// `inverse` stays as it was. Each element is the quotient of a cofactor and the determinant, both
/// rounded, and saturated: an error of e ulp in the determinant d makes one of e / |d| parts in
/// 2^F of the element, so that d should not be small. `inverse` may be `a`.
template <class Number, uint8_t N>
bool invert(const Matrix<Number, N>& a, Matrix<Number, N>& inverse) {
    const Matrix<Number, N> c = cofactors(a);
    const Number d = determinant_of(a, c);
    if (d == Number()) return false;
    for (uint8_t i = 0; i < N; ++i)
        for (uint8_t j = 0; j < N; ++j) inverse.element[i][j] = c.element[j][i] / d;
    return true;
}

}  // namespace fixedpoint
