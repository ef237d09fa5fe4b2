// SPDX-License-Identifier: MIT
// The seam of multiply_saturating.
#pragma once

#include <fixedpoint/portable/multiply_saturating.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw multiply_saturating(Raw a, Raw b) {
    return portable::multiply_saturating<Raw, F>(a, b);
}

}  // namespace kernel
}  // namespace fixedpoint
