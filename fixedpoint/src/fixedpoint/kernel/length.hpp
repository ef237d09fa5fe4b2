// SPDX-License-Identifier: MIT
// The seam of length2 and length3: which code a format runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/portable/length.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw length2(const Raw* v) {
    return portable::length2<Raw, F>(v);
}
template <class Raw, int F>
constexpr Raw length3(const Raw* v) {
    return portable::length3<Raw, F>(v);
}

}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, length2, int32_t, 16, fixedpoint_length2_q16_16, length2,
                           (const int32_t* v), (v))
FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, length3, int32_t, 16, fixedpoint_length3_q16_16, length3,
                           (const int32_t* v), (v))
