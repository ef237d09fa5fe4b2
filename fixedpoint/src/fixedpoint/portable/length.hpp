// SPDX-License-Identifier: MIT
// length2, length3: the square root of the sum of the squares of 2 or 3 components, rounded to
// nearest (never a tie) and saturated. No intermediate square overflows.
#pragma once

#include <fixedpoint/portable/nearest_root.hpp>

namespace fixedpoint {
namespace portable {

// The fraction bits cancel: the length of the raws is the raw of the length.
template <class Raw, int F>
constexpr Raw length2(const Raw* v) {
    return nearest_root<Raw>(sum_of_squares(v, 2));
}
template <class Raw, int F>
constexpr Raw length3(const Raw* v) {
    return nearest_root<Raw>(sum_of_squares(v, 3));
}

}  // namespace portable
}  // namespace fixedpoint
