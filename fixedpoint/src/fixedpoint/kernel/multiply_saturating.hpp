// SPDX-License-Identifier: MIT
// The dispatch of multiply_saturating: which code a format's clamped product runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/portable/multiply_saturating.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw multiply_saturating(Raw a, Raw b) {
    return portable::multiply_saturating<Raw, F>(a, b);
}

}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, multiply_saturating, int32_t, 16,
                           fixedpoint_multiply_q16_16_saturating, multiply_saturating,
                           (int32_t a, int32_t b), (a, b))
