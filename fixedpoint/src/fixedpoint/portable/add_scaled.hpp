// SPDX-License-Identifier: MIT
// Steps of vectors of 2 or 3 components in place, each component rounded once, modulo 2^W:
// add_scaled: sum_i += floor(v_i factor / 2^F + 1/2).
// exchange:   the same product is added to a_i and subtracted from b_i, so a_i + b_i is preserved.
// dot_difference: dot(n, d) with d_i = u_i - v_i modulo 2^W, signed.
// square: dot(v, v).
#pragma once

#include <fixedpoint/portable/dot.hpp>
#include <fixedpoint/portable/multiply_add.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void add_scaled(Raw* sum, const Raw* v, Raw factor, int n) {
    for (int i = 0; i < n; ++i) sum[i] = multiply_add<Raw, F>(v[i], factor, sum[i]);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void add_scaled2(Raw* sum, const Raw* v, Raw factor) {
    add_scaled<Raw, F>(sum, v, factor, 2);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void add_scaled3(Raw* sum, const Raw* v, Raw factor) {
    add_scaled<Raw, F>(sum, v, factor, 3);
}

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void exchange(Raw* a, Raw* b, const Raw* v, Raw factor, int n) {
    for (int i = 0; i < n; ++i) {
        const Raw product = multiply<Raw, F>(v[i], factor);
        a[i] = wrapping_add(a[i], product);
        b[i] = wrapping_subtract(b[i], product);
    }
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void exchange2(Raw* a, Raw* b, const Raw* v, Raw factor) {
    exchange<Raw, F>(a, b, v, factor, 2);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void exchange3(Raw* a, Raw* b, const Raw* v, Raw factor) {
    exchange<Raw, F>(a, b, v, factor, 3);
}

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw dot_difference(const Raw* n, const Raw* u, const Raw* v, int size) {
    Raw difference[3] = {};
    for (int i = 0; i < size; ++i) difference[i] = wrapping_subtract(u[i], v[i]);
    return dot<Raw, F>(difference, n, size);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw dot_difference2(const Raw* n, const Raw* u, const Raw* v) {
    return dot_difference<Raw, F>(n, u, v, 2);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw dot_difference3(const Raw* n, const Raw* u, const Raw* v) {
    return dot_difference<Raw, F>(n, u, v, 3);
}

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw square2(const Raw* v) {
    return dot<Raw, F>(v, v, 2);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw square3(const Raw* v) {
    return dot<Raw, F>(v, v, 3);
}

}  // namespace portable
}  // namespace fixedpoint
