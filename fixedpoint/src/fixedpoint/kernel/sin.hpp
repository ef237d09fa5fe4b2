// SPDX-License-Identifier: MIT
// The seam of sin: which code a format's sine runs through.
#pragma once

#include <fixedpoint/portable/sin.hpp>

#ifdef __AVR__
// In constant expressions the body; at run time always a call, which the assembly kernel answers,
// as gnu_inline emits no code for the body.
extern "C" __attribute__((gnu_inline, noinline, noclone)) constexpr inline int32_t
fixedpoint_sin_q16_16(int32_t angle) {
    return fixedpoint::portable::sin_q16_16(angle);
}
extern "C" __attribute__((gnu_inline, noinline, noclone)) constexpr inline int32_t
fixedpoint_sin_small_q16_16(int32_t angle) {
    return fixedpoint::portable::sin_small_q16_16(angle);
}
#endif

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw sin(Raw angle) {
    return portable::sin<Raw, F>(angle);
}
// Less flash, more cycles.
template <class Raw, int F>
constexpr Raw sin_small(Raw angle) {
    return portable::sin_small<Raw, F>(angle);
}

#ifdef __AVR__
template <>
constexpr int32_t sin<int32_t, 16>(int32_t angle) {
    return fixedpoint_sin_q16_16(angle);
}
template <>
constexpr int32_t sin_small<int32_t, 16>(int32_t angle) {
    return fixedpoint_sin_small_q16_16(angle);
}
#endif

}  // namespace kernel
}  // namespace fixedpoint
