// SPDX-License-Identifier: MIT
// The seam of sincos: which code a format's sine and cosine, computed together, run through.
// result[0] is the sine, result[1] the cosine.
#pragma once

#include <fixedpoint/kernel/cos.hpp>
#include <fixedpoint/kernel/sin.hpp>

#ifdef __AVR__
// In constant expressions the body; at run time always a call, which the assembly kernel answers,
// as gnu_inline emits no code for the body.
extern "C" __attribute__((gnu_inline, noinline, noclone)) constexpr inline void
fixedpoint_sincos_q16_16(int32_t angle, int32_t* result) {
    fixedpoint::portable::sincos<int32_t, 16>(angle, result);
}
#endif

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr void sincos(Raw angle, Raw* result) {
    portable::sincos<Raw, F>(angle, result);
}
// Less flash, more cycles.
template <class Raw, int F>
constexpr void sincos_small(Raw angle, Raw* result) {
    portable::sincos_small<Raw, F>(angle, result);
}

#ifdef __AVR__
template <>
constexpr void sincos<int32_t, 16>(int32_t angle, int32_t* result) {
    fixedpoint_sincos_q16_16(angle, result);
}
template <>
constexpr void sincos_small<int32_t, 16>(int32_t angle, int32_t* result) {
    result[0] = sin_small<int32_t, 16>(angle);
    result[1] = cos_small<int32_t, 16>(angle);
}
#endif

}  // namespace kernel
}  // namespace fixedpoint
