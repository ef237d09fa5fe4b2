// SPDX-License-Identifier: MIT
// The seam of atan: which code a format's arc tangent runs through.
#pragma once

#include <fixedpoint/portable/atan.hpp>

#ifdef __AVR__
// In constant expressions the body; at run time always a call, which the assembly kernel answers,
// as gnu_inline emits no code for the body.
extern "C" __attribute__((gnu_inline, noinline, noclone)) constexpr inline int32_t
fixedpoint_atan_q16_16(int32_t a) {
    return fixedpoint::portable::atan_q16_16(a);
}
extern "C" __attribute__((gnu_inline, noinline, noclone)) constexpr inline int32_t
fixedpoint_atan_small_q16_16(int32_t a) {
    return fixedpoint::portable::atan_small_q16_16(a);
}
#endif

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw atan(Raw a) {
    return portable::atan<Raw, F>(a);
}
// Less flash, more cycles.
template <class Raw, int F>
constexpr Raw atan_small(Raw a) {
    return portable::atan_small<Raw, F>(a);
}

#ifdef __AVR__
template <>
constexpr int32_t atan<int32_t, 16>(int32_t a) {
    return fixedpoint_atan_q16_16(a);
}
template <>
constexpr int32_t atan_small<int32_t, 16>(int32_t a) {
    return fixedpoint_atan_small_q16_16(a);
}
#endif

}  // namespace kernel
}  // namespace fixedpoint
