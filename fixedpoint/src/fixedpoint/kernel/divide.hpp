// SPDX-License-Identifier: MIT
// The seam of divide: which code a format's quotient runs through.
#pragma once

#include <fixedpoint/portable/divide.hpp>

#ifdef __AVR__
// In constant expressions the body; at run time always a call, which the assembly kernel answers,
// as gnu_inline emits no code for the body.
extern "C" __attribute__((gnu_inline, noinline, noclone)) constexpr inline int32_t
fixedpoint_divide_q16_16(int32_t a, int32_t b) {
    return fixedpoint::portable::divide<int32_t, 16>(a, b);
}
#endif

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw divide(Raw a, Raw b) {
    return portable::divide<Raw, F>(a, b);
}

#ifdef __AVR__
template <>
constexpr int32_t divide<int32_t, 16>(int32_t a, int32_t b) {
    return fixedpoint_divide_q16_16(a, b);
}
#endif

}  // namespace kernel
}  // namespace fixedpoint
