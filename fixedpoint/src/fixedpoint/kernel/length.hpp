// SPDX-License-Identifier: MIT
// The seam of length2 and length3: which code a format runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/kernel/through_q16_16.hpp>
#include <fixedpoint/portable/length.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw length2(const Raw* v) {
    if (!through_q16_16<Raw, F>) return portable::length2<Raw, F>(v);
    const int32_t wide[2] = {to_q16_16<Raw, F>(v[0]), to_q16_16<Raw, F>(v[1])};
    return from_q16_16<Raw, F>(length2<int32_t, 16>(wide));
}
template <class Raw, int F>
constexpr Raw length3(const Raw* v) {
    if (!through_q16_16<Raw, F>) return portable::length3<Raw, F>(v);
    const int32_t wide[3] = {to_q16_16<Raw, F>(v[0]), to_q16_16<Raw, F>(v[1]),
                             to_q16_16<Raw, F>(v[2])};
    return from_q16_16<Raw, F>(length3<int32_t, 16>(wide));
}

}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, length2, int32_t, 16, fixedpoint_length2_q16_16, length2,
                           (const int32_t* v), (v))
FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, length3, int32_t, 16, fixedpoint_length3_q16_16, length3,
                           (const int32_t* v), (v))
