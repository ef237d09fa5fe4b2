// SPDX-License-Identifier: MIT
// The seam of cos: which code a format's cosine runs through.
#pragma once

#include <fixedpoint/portable/sin.hpp>

#ifdef __AVR__
// In constant expressions the body; at run time always a call, which the assembly kernel answers,
// as gnu_inline emits no code for the body.
extern "C" __attribute__((gnu_inline, noinline, noclone)) constexpr inline int32_t
fixedpoint_cos_q16_16(int32_t angle) {
    return fixedpoint::portable::cos_q16_16(angle);
}
extern "C" __attribute__((gnu_inline, noinline, noclone)) constexpr inline int32_t
fixedpoint_cos_small_q16_16(int32_t angle) {
    return fixedpoint::portable::cos_small_q16_16(angle);
}
#endif

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw cos(Raw angle) {
    return portable::cos<Raw, F>(angle);
}
// Less flash, more cycles.
template <class Raw, int F>
constexpr Raw cos_small(Raw angle) {
    return portable::cos_small<Raw, F>(angle);
}

#ifdef __AVR__
template <>
constexpr int32_t cos<int32_t, 16>(int32_t angle) {
    return fixedpoint_cos_q16_16(angle);
}
template <>
constexpr int32_t cos_small<int32_t, 16>(int32_t angle) {
    return fixedpoint_cos_small_q16_16(angle);
}
#endif

}  // namespace kernel
}  // namespace fixedpoint
