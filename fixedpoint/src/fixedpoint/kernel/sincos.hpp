// SPDX-License-Identifier: MIT
// The dispatch of sincos: which code a format runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/kernel/through_q16_16.hpp>
#include <fixedpoint/portable/sin.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr void sincos(Raw angle, Raw* sine_and_cosine) {
    if (through_q16_16<Raw, F>) {
        int32_t wide[2] = {};
        sincos<int32_t, 16>(to_q16_16<Raw, F>(angle), wide);
        sine_and_cosine[0] = from_q16_16<Raw, F>(wide[0]);
        sine_and_cosine[1] = from_q16_16<Raw, F>(wide[1]);
    } else {
        portable::sincos<Raw, F>(angle, sine_and_cosine);
    }
}

}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_ASSEMBLY_KERNEL(void, sincos, int32_t, 16, fixedpoint_sincos_q16_16, sincos,
                           (int32_t angle, int32_t* sine_and_cosine), (angle, sine_and_cosine))
