// SPDX-License-Identifier: MIT
// The dispatch of multiply: which code a format runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/kernel/splits_16.hpp>
#include <fixedpoint/kernel/splits_32.hpp>
#include <fixedpoint/portable/multiply.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw multiply(Raw a, Raw b) {
    return portable::multiply<Raw, F>(a, b);
}

}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_ASSEMBLY_KERNEL(int8_t, multiply, int8_t, 4, fixedpoint_multiply_q4_4, multiply,
                           (int8_t a, int8_t b), (a, b))
FIXEDPOINT_ASSEMBLY_KERNEL(int16_t, multiply, int16_t, 8, fixedpoint_multiply_q8_8, multiply,
                           (int16_t a, int16_t b), (a, b))
FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, multiply, int32_t, 16, fixedpoint_multiply_q16_16, multiply,
                           (int32_t a, int32_t b), (a, b))
FIXEDPOINT_ASSEMBLY_KERNEL(int64_t, multiply, int64_t, 32, fixedpoint_multiply_q32_32, multiply,
                           (int64_t a, int64_t b), (a, b))

#define FIXEDPOINT_MULTIPLY_16(I, F)                                                          \
    FIXEDPOINT_ASSEMBLY_KERNEL(int16_t, multiply, int16_t, F, fixedpoint_multiply_q##I##_##F, \
                               multiply, (int16_t a, int16_t b), (a, b))
FIXEDPOINT_SPLITS_16(FIXEDPOINT_MULTIPLY_16)
#undef FIXEDPOINT_MULTIPLY_16

#define FIXEDPOINT_MULTIPLY_32(I, F)                                                          \
    FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, multiply, int32_t, F, fixedpoint_multiply_q##I##_##F, \
                               multiply, (int32_t a, int32_t b), (a, b))
FIXEDPOINT_SPLITS_32(FIXEDPOINT_MULTIPLY_32)
#undef FIXEDPOINT_MULTIPLY_32
