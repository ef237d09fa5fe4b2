// SPDX-License-Identifier: MIT
// cross, twice_cross, quaternion_times_vector, quaternion_product, complex_product, and the
// cofactors of a 3x3 matrix. Each component is floor(sum / 2^F + 1/2) modulo 2^W, where the sum of
// products, some of them negated, is exact.
#pragma once

#include <fixedpoint/portable/product_sum.hpp>

namespace fixedpoint {
namespace portable {

// sum + a b and sum - a b modulo 2^(2W).
template <class Raw>
FIXEDPOINT_CONSTEXPR DoubleWord<Raw> plus_product(DoubleWord<Raw> sum, Raw a, Raw b) {
    return static_cast<DoubleWord<Raw>>(sum + exact_product(a, b));
}
template <class Raw>
FIXEDPOINT_CONSTEXPR DoubleWord<Raw> minus_product(DoubleWord<Raw> sum, Raw a, Raw b) {
    return static_cast<DoubleWord<Raw>>(sum - exact_product(a, b));
}
// Component i of the cross product.
template <class Raw>
FIXEDPOINT_CONSTEXPR DoubleWord<Raw> cross_component(const Raw* a, const Raw* b, uint8_t i) {
    const uint8_t j = static_cast<uint8_t>(i == 2 ? 0 : i + 1);
    const uint8_t k = static_cast<uint8_t>(i == 0 ? 2 : i - 1);
    return minus_product(exact_product(a[j], b[k]), a[k], b[j]);
}

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void cross(Raw* result, const Raw* a, const Raw* b) {
    for (uint8_t i = 0; i < 3; ++i) result[i] = round_product_sum<Raw, F>(cross_component(a, b, i));
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void twice_cross(Raw* result, const Raw* a, const Raw* b) {
    for (uint8_t i = 0; i < 3; ++i) {
        const DoubleWord<Raw> once = cross_component(a, b, i);
        result[i] = round_product_sum<Raw, F>(static_cast<DoubleWord<Raw>>(once + once));
    }
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void quaternion_times_vector(Raw* result, const Raw* a, const Raw* b) {
    for (uint8_t i = 0; i < 3; ++i)
        result[i] =
            round_product_sum<Raw, F>(plus_product(cross_component(a + 1, b, i), a[0], b[i]));
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void quaternion_product(Raw* result, const Raw* a, const Raw* b) {
    DoubleWord<Raw> scalar = exact_product(a[0], b[0]);
    for (uint8_t i = 1; i < 4; ++i) scalar = minus_product(scalar, a[i], b[i]);
    result[0] = round_product_sum<Raw, F>(scalar);
    for (uint8_t i = 0; i < 3; ++i)
        result[i + 1] = round_product_sum<Raw, F>(plus_product(
            plus_product(cross_component(a + 1, b + 1, i), a[0], b[i + 1]), a[i + 1], b[0]));
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void complex_product(Raw* result, const Raw* a, const Raw* b) {
    result[0] = round_product_sum<Raw, F>(minus_product(exact_product(a[0], b[0]), a[1], b[1]));
    result[1] = round_product_sum<Raw, F>(plus_product(exact_product(a[0], b[1]), a[1], b[0]));
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void cofactors(const Raw* m, Raw* result) {
    cross<Raw, F>(result, m + 3, m + 6);
    cross<Raw, F>(result + 3, m + 6, m);
    cross<Raw, F>(result + 6, m, m + 3);
}

}  // namespace portable
}  // namespace fixedpoint
