// SPDX-License-Identifier: MIT
// multiply: floor(a b / 2^F + 1/2) modulo 2^W, the product rounded to nearest, half up.
#pragma once

#include <fixedpoint/portable/product_sum.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw, int F>
constexpr Raw multiply(Raw a, Raw b) {
    return round_product_sum<Raw, F>(exact_product(a, b));
}

}  // namespace portable
}  // namespace fixedpoint
