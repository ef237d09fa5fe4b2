// SPDX-License-Identifier: MIT
// The dispatch of sin, and of its variant without tables: which code a format runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/kernel/through_q16_16.hpp>
#include <fixedpoint/portable/sin.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw sin(Raw angle) {
    return through_q16_16<Raw, F> ? from_q16_16<Raw, F>(sin<int32_t, 16>(to_q16_16<Raw, F>(angle)))
                                  : portable::sin<Raw, F>(angle);
}
template <class Raw, int F>
constexpr Raw sin_small(Raw angle) {
    return through_q16_16<Raw, F>
               ? from_q16_16<Raw, F>(sin_small<int32_t, 16>(to_q16_16<Raw, F>(angle)))
               : portable::sin_small<Raw, F>(angle);
}

}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, sin, int32_t, 16, fixedpoint_sin_q16_16, sin, (int32_t angle),
                           (angle))
FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, sin_small, int32_t, 16, fixedpoint_sin_q16_16_small, sin_small,
                           (int32_t angle), (angle))
