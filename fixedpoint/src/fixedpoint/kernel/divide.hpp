// SPDX-License-Identifier: MIT
// The dispatch of divide: which code a format's quotient runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/kernel/splits_32.hpp>
#include <fixedpoint/portable/divide.hpp>

namespace fixedpoint {
namespace kernel {

// Formats of 8 and 16 bits have the quotient a 2^16 / (b 2^(16 - F)) of Q16.16, rounded once.
template <class Raw, int F>
constexpr Raw divide(Raw a, Raw b) {
    return has_assembly && sizeof(Raw) <= 2
               ? clamped<Raw>(divide<int32_t, 16>(
                     static_cast<int32_t>(a),
                     static_cast<int32_t>(b) * (int32_t(1) << (F < 16 ? 16 - F : 0))))
               : portable::divide<Raw, F>(a, b);
}

}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_ASSEMBLY_KERNEL(int8_t, divide, int8_t, 4, fixedpoint_divide_q4_4, divide,
                           (int8_t a, int8_t b), (a, b))
FIXEDPOINT_ASSEMBLY_KERNEL(int16_t, divide, int16_t, 8, fixedpoint_divide_q8_8, divide,
                           (int16_t a, int16_t b), (a, b))
FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, divide, int32_t, 16, fixedpoint_divide_q16_16, divide,
                           (int32_t a, int32_t b), (a, b))
FIXEDPOINT_ASSEMBLY_KERNEL(int64_t, divide, int64_t, 32, fixedpoint_divide_q32_32, divide,
                           (int64_t a, int64_t b), (a, b))

#define FIXEDPOINT_DIVIDE(I, F)                                                                   \
    FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, divide, int32_t, F, fixedpoint_divide_q##I##_##F, divide, \
                               (int32_t a, int32_t b), (a, b))
FIXEDPOINT_SPLITS_32(FIXEDPOINT_DIVIDE)
#undef FIXEDPOINT_DIVIDE
