// SPDX-License-Identifier: MIT
// The dispatch of atan2, and of its variant without tables: which code a format runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/kernel/through_q16_16.hpp>
#include <fixedpoint/portable/atan2.hpp>

namespace fixedpoint {
namespace kernel {

// Q8.8 has a kernel of its own.
template <class Raw, int F>
constexpr Raw atan2(Raw y, Raw x) {
    return through_q16_16<Raw, F> && !(sizeof(Raw) == 2 && F == 8)
               ? from_q16_16<Raw, F>(atan2<int32_t, 16>(to_q16_16<Raw, F>(y), to_q16_16<Raw, F>(x)))
               : portable::atan2<Raw, F>(y, x);
}
template <class Raw, int F>
constexpr Raw atan2_small(Raw y, Raw x) {
    return through_q16_16<Raw, F> ? from_q16_16<Raw, F>(atan2_small<int32_t, 16>(
                                        to_q16_16<Raw, F>(y), to_q16_16<Raw, F>(x)))
                                  : portable::atan2_small<Raw, F>(y, x);
}

}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_ASSEMBLY_KERNEL(int16_t, atan2, int16_t, 8, fixedpoint_atan2_q8_8, atan2,
                           (int16_t y, int16_t x), (y, x))
FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, atan2, int32_t, 16, fixedpoint_atan2_q16_16, atan2,
                           (int32_t y, int32_t x), (y, x))
FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, atan2_small, int32_t, 16, fixedpoint_atan2_q16_16_small,
                           atan2_small, (int32_t y, int32_t x), (y, x))
