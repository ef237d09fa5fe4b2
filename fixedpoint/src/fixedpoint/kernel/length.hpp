// SPDX-License-Identifier: MIT
// The seam of length: which code the length of a format's vectors runs through.
#pragma once

#include <fixedpoint/portable/length.hpp>

#ifdef __AVR__
// In constant expressions the body; at run time always a call, which the assembly kernel answers,
// as gnu_inline emits no code for the body.
extern "C" __attribute__((gnu_inline, noinline)) constexpr inline int32_t fixedpoint_length2_q16_16(
    const int32_t* v) {
    return fixedpoint::portable::length2<int32_t, 16>(v);
}
extern "C" __attribute__((gnu_inline, noinline)) constexpr inline int32_t fixedpoint_length3_q16_16(
    const int32_t* v) {
    return fixedpoint::portable::length3<int32_t, 16>(v);
}
#endif

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw length2(const Raw* v) {
    return portable::length2<Raw, F>(v);
}
template <class Raw, int F>
constexpr Raw length3(const Raw* v) {
    return portable::length3<Raw, F>(v);
}

#ifdef __AVR__
template <>
constexpr int32_t length2<int32_t, 16>(const int32_t* v) {
    return fixedpoint_length2_q16_16(v);
}
template <>
constexpr int32_t length3<int32_t, 16>(const int32_t* v) {
    return fixedpoint_length3_q16_16(v);
}
#endif

}  // namespace kernel
}  // namespace fixedpoint
