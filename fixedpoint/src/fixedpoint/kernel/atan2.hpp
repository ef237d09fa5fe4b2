// SPDX-License-Identifier: MIT
// The seam of atan2: which code a format's angle of a vector runs through.
#pragma once

#include <fixedpoint/portable/atan2.hpp>

#ifdef __AVR__
// In constant expressions the body; at run time always a call, which the assembly kernel answers,
// as gnu_inline emits no code for the body.
extern "C" __attribute__((gnu_inline, noinline, noclone)) constexpr inline int32_t
fixedpoint_atan2_q16_16(int32_t y, int32_t x) {
    return fixedpoint::portable::atan2_q16_16(y, x);
}
extern "C" __attribute__((gnu_inline, noinline, noclone)) constexpr inline int32_t
fixedpoint_atan2_small_q16_16(int32_t y, int32_t x) {
    return fixedpoint::portable::atan2_small_q16_16(y, x);
}
#endif

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw atan2(Raw y, Raw x) {
    return portable::atan2<Raw, F>(y, x);
}
// Less flash, more cycles.
template <class Raw, int F>
constexpr Raw atan2_small(Raw y, Raw x) {
    return portable::atan2_small<Raw, F>(y, x);
}

#ifdef __AVR__
template <>
constexpr int32_t atan2<int32_t, 16>(int32_t y, int32_t x) {
    return fixedpoint_atan2_q16_16(y, x);
}
template <>
constexpr int32_t atan2_small<int32_t, 16>(int32_t y, int32_t x) {
    return fixedpoint_atan2_small_q16_16(y, x);
}
#endif

}  // namespace kernel
}  // namespace fixedpoint
