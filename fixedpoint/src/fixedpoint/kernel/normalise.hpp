// SPDX-License-Identifier: MIT
// The seam of normalise3: which code a format runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/portable/normalise.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr void normalise3(const Raw* v, Raw* unit) {
    portable::normalise3<Raw, F>(v, unit);
}

}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_ASSEMBLY_KERNEL(void, normalise3, int32_t, 16, fixedpoint_normalise3_q16_16, normalise3,
                           (const int32_t* v, int32_t* unit), (v, unit))
