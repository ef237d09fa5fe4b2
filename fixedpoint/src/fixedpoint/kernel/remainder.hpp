// SPDX-License-Identifier: MIT
// The dispatch of remainder: which code a format runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/portable/remainder.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw remainder(Raw a, Raw b) {
    return portable::remainder<Raw, F>(a, b);
}

}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, remainder, int32_t, 16, fixedpoint_remainder_q16_16, remainder,
                           (int32_t a, int32_t b), (a, b))
