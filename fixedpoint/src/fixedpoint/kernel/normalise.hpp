// SPDX-License-Identifier: MIT
// The seam of normalise: which code a format's unit vectors run through.
#pragma once

#include <fixedpoint/portable/normalise.hpp>

#ifdef __AVR__
// In constant expressions the body; at run time always a call, which the assembly kernel answers,
// as gnu_inline emits no code for the body.
extern "C" __attribute__((gnu_inline, noinline)) constexpr inline void fixedpoint_normalise3_q16_16(
    const int32_t* v, int32_t* unit) {
    fixedpoint::portable::normalise3<int32_t, 16>(v, unit);
}
#endif

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr void normalise3(const Raw* v, Raw* unit) {
    portable::normalise3<Raw, F>(v, unit);
}

#ifdef __AVR__
template <>
constexpr void normalise3<int32_t, 16>(const int32_t* v, int32_t* unit) {
    fixedpoint_normalise3_q16_16(v, unit);
}
#endif

}  // namespace kernel
}  // namespace fixedpoint
