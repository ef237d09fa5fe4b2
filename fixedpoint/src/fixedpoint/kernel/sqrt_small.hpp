// SPDX-License-Identifier: MIT
// The seam of sqrt_small: sqrt with no table, the same results. On the device Q16.16 has a kernel
// of its own for it, every other format the portable code.
#pragma once

#include <fixedpoint/portable/sqrt.hpp>

#ifdef __AVR__
// In constant expressions the body; at run time always a call, which the assembly kernel answers,
// as gnu_inline emits no code for the body.
extern "C" __attribute__((gnu_inline, noinline)) constexpr inline int32_t
fixedpoint_sqrt_small_q16_16(int32_t a) {
    return fixedpoint::portable::sqrt<int32_t, 16>(a);
}
#endif

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw sqrt_small(Raw a) {
    return portable::sqrt<Raw, F>(a);
}

#ifdef __AVR__
template <>
constexpr int32_t sqrt_small<int32_t, 16>(int32_t a) {
    return fixedpoint_sqrt_small_q16_16(a);
}
#endif

}  // namespace kernel
}  // namespace fixedpoint
