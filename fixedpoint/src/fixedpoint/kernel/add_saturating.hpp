// SPDX-License-Identifier: MIT
// The dispatch of add_saturating and subtract_saturating. On the device, those of 16 to 32 bits
// test the processor's overflow flag inline; the compiler's code for the portable test takes
// several times as long.
#pragma once

#include <fixedpoint/portable/add_saturating.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw>
constexpr Raw add_saturating(Raw a, Raw b) {
    return portable::add_saturating(a, b);
}
template <class Raw>
constexpr Raw subtract_saturating(Raw a, Raw b) {
    return portable::subtract_saturating(a, b);
}

// clang does not support asm operands of four registers.
#if defined(__AVR__) && !defined(__clang__) && !defined(FIXEDPOINT_NO_ASSEMBLY)
// If a + b overflows, a and b both have the sign of the exact sum, and the wrapped sum has the
// wrong one. The result is the sign of b (`bst`) on top of copies of the wrong sign.
inline int16_t saturated_sum(int16_t a, int16_t b) {
    asm("add %A0, %A1\n\t"
        "adc %B0, %B1\n\t"
        "brvc 1f\n\t"
        "bst %B1, 7\n\t"
        "lsl %B0\n\t"
        "sbc %B0, %B0\n\t"
        "mov %A0, %B0\n\t"
        "bld %B0, 7\n"
        "1:"
        : "+&r"(a)
        : "r"(b));
    return a;
}
inline Int24 saturated_sum(Int24 a, Int24 b) {
    asm("add %A0, %A1\n\t"
        "adc %B0, %B1\n\t"
        "adc %C0, %C1\n\t"
        "brvc 1f\n\t"
        "bst %C1, 7\n\t"
        "lsl %C0\n\t"
        "sbc %C0, %C0\n\t"
        "mov %A0, %C0\n\t"
        "mov %B0, %C0\n\t"
        "bld %C0, 7\n"
        "1:"
        : "+&r"(a)
        : "r"(b));
    return a;
}
inline int32_t saturated_sum(int32_t a, int32_t b) {
    asm("add %A0, %A1\n\t"
        "adc %B0, %B1\n\t"
        "adc %C0, %C1\n\t"
        "adc %D0, %D1\n\t"
        "brvc 1f\n\t"
        "bst %D1, 7\n\t"
        "lsl %D0\n\t"
        "sbc %D0, %D0\n\t"
        "mov %A0, %D0\n\t"
        "mov %B0, %D0\n\t"
        "mov %C0, %D0\n\t"
        "bld %D0, 7\n"
        "1:"
        : "+&r"(a)
        : "r"(b));
    return a;
}
// If a - b overflows, b has the wrong sign, that of the wrapped difference; there is a borrow if
// that is negative.
inline int16_t saturated_difference(int16_t a, int16_t b) {
    asm("sub %A0, %A1\n\t"
        "sbc %B0, %B1\n\t"
        "brvc 1f\n\t"
        "bst %B1, 7\n\t"
        "sbc %A0, %A0\n\t"
        "mov %B0, %A0\n\t"
        "com %B0\n\t"
        "bld %B0, 7\n\t"
        "com %B0\n"
        "1:"
        : "+&r"(a)
        : "r"(b));
    return a;
}
inline Int24 saturated_difference(Int24 a, Int24 b) {
    asm("sub %A0, %A1\n\t"
        "sbc %B0, %B1\n\t"
        "sbc %C0, %C1\n\t"
        "brvc 1f\n\t"
        "bst %C1, 7\n\t"
        "sbc %A0, %A0\n\t"
        "mov %B0, %A0\n\t"
        "mov %C0, %A0\n\t"
        "com %C0\n\t"
        "bld %C0, 7\n\t"
        "com %C0\n"
        "1:"
        : "+&r"(a)
        : "r"(b));
    return a;
}
inline int32_t saturated_difference(int32_t a, int32_t b) {
    asm("sub %A0, %A1\n\t"
        "sbc %B0, %B1\n\t"
        "sbc %C0, %C1\n\t"
        "sbc %D0, %D1\n\t"
        "brvc 1f\n\t"
        "bst %D1, 7\n\t"
        "sbc %A0, %A0\n\t"
        "mov %B0, %A0\n\t"
        "mov %C0, %A0\n\t"
        "mov %D0, %A0\n\t"
        "com %D0\n\t"
        "bld %D0, 7\n\t"
        "com %D0\n"
        "1:"
        : "+&r"(a)
        : "r"(b));
    return a;
}

#define FIXEDPOINT_SATURATING_SUMS(Raw)                                                            \
    template <>                                                                                    \
    FIXEDPOINT_CONSTEXPR Raw add_saturating(Raw a, Raw b) {                                        \
        return __builtin_constant_p(a) && __builtin_constant_p(b) ? portable::add_saturating(a, b) \
                                                                  : saturated_sum(a, b);           \
    }                                                                                              \
    template <>                                                                                    \
    FIXEDPOINT_CONSTEXPR Raw subtract_saturating(Raw a, Raw b) {                                   \
        return __builtin_constant_p(a) && __builtin_constant_p(b)                                  \
                   ? portable::subtract_saturating(a, b)                                           \
                   : saturated_difference(a, b);                                                   \
    }
FIXEDPOINT_SATURATING_SUMS(int16_t)
FIXEDPOINT_SATURATING_SUMS(Int24)
FIXEDPOINT_SATURATING_SUMS(int32_t)
#undef FIXEDPOINT_SATURATING_SUMS
#endif

}  // namespace kernel
}  // namespace fixedpoint
