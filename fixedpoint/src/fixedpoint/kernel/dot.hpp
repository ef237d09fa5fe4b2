// SPDX-License-Identifier: MIT
// The seam of dot2 and dot3: which code the dot product of a format's vectors runs through.
#pragma once

#include <fixedpoint/portable/dot.hpp>

#ifdef __AVR__
// In constant expressions the body; at run time always a call, which the assembly kernel answers,
// as gnu_inline emits no code for the body.
extern "C" __attribute__((gnu_inline, noinline, noclone)) constexpr inline int32_t
fixedpoint_dot2_q16_16(const int32_t* a, const int32_t* b) {
    return fixedpoint::portable::dot2<int32_t, 16>(a, b);
}
extern "C" __attribute__((gnu_inline, noinline, noclone)) constexpr inline int32_t
fixedpoint_dot3_q16_16(const int32_t* a, const int32_t* b) {
    return fixedpoint::portable::dot3<int32_t, 16>(a, b);
}
#endif

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw dot2(const Raw* a, const Raw* b) {
    return portable::dot2<Raw, F>(a, b);
}
template <class Raw, int F>
constexpr Raw dot3(const Raw* a, const Raw* b) {
    return portable::dot3<Raw, F>(a, b);
}

#ifdef __AVR__
template <>
constexpr int32_t dot2<int32_t, 16>(const int32_t* a, const int32_t* b) {
    return fixedpoint_dot2_q16_16(a, b);
}
template <>
constexpr int32_t dot3<int32_t, 16>(const int32_t* a, const int32_t* b) {
    return fixedpoint_dot3_q16_16(a, b);
}
#endif

}  // namespace kernel
}  // namespace fixedpoint
