// SPDX-License-Identifier: MIT
// The seam of reciprocal_sqrt, and of its variant without tables: which code a format runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/kernel/through_q16_16.hpp>
#include <fixedpoint/portable/reciprocal_sqrt.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw reciprocal_sqrt(Raw a) {
    return through_q16_16<Raw, F>
               ? from_q16_16<Raw, F>(reciprocal_sqrt<int32_t, 16>(to_q16_16<Raw, F>(a)))
               : portable::reciprocal_sqrt<Raw, F>(a);
}
template <class Raw, int F>
constexpr Raw reciprocal_sqrt_small(Raw a) {
    return through_q16_16<Raw, F>
               ? from_q16_16<Raw, F>(reciprocal_sqrt_small<int32_t, 16>(to_q16_16<Raw, F>(a)))
               : portable::nearest_reciprocal_sqrt<Raw, F>(a);
}

}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, reciprocal_sqrt, int32_t, 16, fixedpoint_reciprocal_sqrt_q16_16,
                           reciprocal_sqrt, (int32_t a), (a))
FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, reciprocal_sqrt_small, int32_t, 16,
                           fixedpoint_reciprocal_sqrt_q16_16_small, nearest_reciprocal_sqrt,
                           (int32_t a), (a))
