// SPDX-License-Identifier: MIT
// The dispatch of dot2 and dot3: which code a format runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/kernel/splits_32.hpp>
#include <fixedpoint/portable/dot.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw dot2(const Raw* a, const Raw* b) {
    return portable::dot2<Raw, F>(a, b);
}
template <class Raw, int F>
constexpr Raw dot3(const Raw* a, const Raw* b) {
    return portable::dot3<Raw, F>(a, b);
}

}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, dot2, int32_t, 16, fixedpoint_dot2_q16_16, dot2,
                           (const int32_t* a, const int32_t* b), (a, b))
FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, dot3, int32_t, 16, fixedpoint_dot3_q16_16, dot3,
                           (const int32_t* a, const int32_t* b), (a, b))
FIXEDPOINT_ASSEMBLY_KERNEL(int64_t, dot2, int64_t, 32, fixedpoint_dot2_q32_32, dot2,
                           (const int64_t* a, const int64_t* b), (a, b))
FIXEDPOINT_ASSEMBLY_KERNEL(int64_t, dot3, int64_t, 32, fixedpoint_dot3_q32_32, dot3,
                           (const int64_t* a, const int64_t* b), (a, b))

#define FIXEDPOINT_DOT(I, F)                                                                \
    FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, dot2, int32_t, F, fixedpoint_dot2_q##I##_##F, dot2, \
                               (const int32_t* a, const int32_t* b), (a, b))                \
    FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, dot3, int32_t, F, fixedpoint_dot3_q##I##_##F, dot3, \
                               (const int32_t* a, const int32_t* b), (a, b))
FIXEDPOINT_SPLITS_32(FIXEDPOINT_DOT)
#undef FIXEDPOINT_DOT
