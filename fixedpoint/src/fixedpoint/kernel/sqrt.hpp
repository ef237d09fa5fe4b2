// SPDX-License-Identifier: MIT
// The dispatch of sqrt, and of its variant without tables: which code a format runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/kernel/splits_32.hpp>
#include <fixedpoint/portable/sqrt.hpp>

namespace fixedpoint {
namespace kernel {

// Formats of 8 and 16 bits have the root of the integer a 2^F, rounded once.
template <class Raw, int F>
constexpr Raw sqrt(Raw a) {
    return has_assembly && sizeof(Raw) <= 2
               ? clamped<Raw>(
                     sqrt<int32_t, 0>(static_cast<int32_t>(a) * (int32_t(1) << (F < 16 ? F : 16))))
               : portable::sqrt<Raw, F>(a);
}
template <class Raw, int F>
constexpr Raw sqrt_small(Raw a) {
    return portable::sqrt<Raw, F>(a);
}

}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_ASSEMBLY_KERNEL(int8_t, sqrt, int8_t, 4, fixedpoint_sqrt_q4_4, sqrt, (int8_t a), (a))
FIXEDPOINT_ASSEMBLY_KERNEL(int16_t, sqrt, int16_t, 8, fixedpoint_sqrt_q8_8, sqrt, (int16_t a), (a))
FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, sqrt, int32_t, 16, fixedpoint_sqrt_q16_16, sqrt, (int32_t a),
                           (a))
FIXEDPOINT_ASSEMBLY_KERNEL(int64_t, sqrt, int64_t, 32, fixedpoint_sqrt_q32_32, sqrt, (int64_t a),
                           (a))
FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, sqrt_small, int32_t, 16, fixedpoint_sqrt_q16_16_small, sqrt,
                           (int32_t a), (a))

#define FIXEDPOINT_SQRT(I, F)                                                               \
    FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, sqrt, int32_t, F, fixedpoint_sqrt_q##I##_##F, sqrt, \
                               (int32_t a), (a))
FIXEDPOINT_SPLITS_32(FIXEDPOINT_SQRT)
#undef FIXEDPOINT_SQRT
