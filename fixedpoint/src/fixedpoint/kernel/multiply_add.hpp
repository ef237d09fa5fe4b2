// SPDX-License-Identifier: MIT
// The dispatch of multiply_add: which code a format runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/kernel/multiply.hpp>
#include <fixedpoint/portable/multiply_add.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw multiply_add(Raw a, Raw b, Raw c) {
    return wrapping_add(multiply<Raw, F>(a, b), c);
}

}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, multiply_add, int32_t, 16, fixedpoint_multiply_add_q16_16,
                           multiply_add, (int32_t a, int32_t b, int32_t c), (a, b, c))

#define FIXEDPOINT_MULTIPLY_ADD(I, F)                                            \
    FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, multiply_add, int32_t, F,                \
                               fixedpoint_multiply_add_q##I##_##F, multiply_add, \
                               (int32_t a, int32_t b, int32_t c), (a, b, c))
FIXEDPOINT_SPLITS_32(FIXEDPOINT_MULTIPLY_ADD)
#undef FIXEDPOINT_MULTIPLY_ADD
