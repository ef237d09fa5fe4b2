// SPDX-License-Identifier: MIT
// dot2, dot3: floor(sum a_i b_i / 2^F + 1/2) modulo 2^W over 2 or 3 components: the sum is exact
// and rounded once. transform computes these sums for every row of a matrix, matrix_product for
// every row and column, and matrix_product_2 for two of each.
#pragma once

#include <fixedpoint/portable/product_sum.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw dot(const Raw* a, const Raw* b, int n, int step = 1) {
    DoubleWord<Raw> sum = exact_product(a[0], b[0]);
    for (int i = 1; i < n; ++i) {
        sum = static_cast<DoubleWord<Raw>>(sum + exact_product(a[i], b[i * step]));
    }
    return round_product_sum<Raw, F>(sum);
}

template <class Raw, int F>
constexpr Raw dot2(const Raw* a, const Raw* b) {
    return dot<Raw, F>(a, b, 2);
}
template <class Raw, int F>
constexpr Raw dot3(const Raw* a, const Raw* b) {
    return dot<Raw, F>(a, b, 3);
}

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void transform(Raw* result, const Raw* v, const Raw* m, uint8_t n) {
    for (uint8_t i = 0; i < n; ++i) result[i] = dot<Raw, F>(v, m + i * n, n);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void matrix_product(Raw* result, const Raw* a, const Raw* b, uint8_t n) {
    for (uint8_t i = 0; i < n; ++i)
        for (uint8_t j = 0; j < n; ++j) result[i * n + j] = dot<Raw, F>(a + i * n, b + j, n, n);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void matrix_product_2(Raw* result, const Raw* a, const Raw* b) {
    matrix_product<Raw, F>(result, a, b, 2);
}

}  // namespace portable
}  // namespace fixedpoint
