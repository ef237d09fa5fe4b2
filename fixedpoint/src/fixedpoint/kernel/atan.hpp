// SPDX-License-Identifier: MIT
// The dispatch of atan, and of its variant without tables: which code a format runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/kernel/through_q16_16.hpp>
#include <fixedpoint/portable/atan.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw atan(Raw a) {
    return through_q16_16<Raw, F> ? from_q16_16<Raw, F>(atan<int32_t, 16>(to_q16_16<Raw, F>(a)))
                                  : portable::atan<Raw, F>(a);
}
template <class Raw, int F>
constexpr Raw atan_small(Raw a) {
    return through_q16_16<Raw, F>
               ? from_q16_16<Raw, F>(atan_small<int32_t, 16>(to_q16_16<Raw, F>(a)))
               : portable::atan_small<Raw, F>(a);
}

}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, atan, int32_t, 16, fixedpoint_atan_q16_16, atan, (int32_t a),
                           (a))
FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, atan_small, int32_t, 16, fixedpoint_atan_q16_16_small,
                           atan_small, (int32_t a), (a))
