// SPDX-License-Identifier: MIT
// The dispatch of cos, and of its variant without tables: which code a format runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/kernel/through_q16_16.hpp>
#include <fixedpoint/portable/sin.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw cos(Raw angle) {
    return through_q16_16<Raw, F> ? from_q16_16<Raw, F>(cos<int32_t, 16>(to_q16_16<Raw, F>(angle)))
                                  : portable::cos<Raw, F>(angle);
}
template <class Raw, int F>
constexpr Raw cos_small(Raw angle) {
    return through_q16_16<Raw, F>
               ? from_q16_16<Raw, F>(cos_small<int32_t, 16>(to_q16_16<Raw, F>(angle)))
               : portable::cos_small<Raw, F>(angle);
}

}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, cos, int32_t, 16, fixedpoint_cos_q16_16, cos, (int32_t angle),
                           (angle))
FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, cos_small, int32_t, 16, fixedpoint_cos_q16_16_small, cos_small,
                           (int32_t angle), (angle))
