// SPDX-License-Identifier: MIT
// scale_down: floor(a / 2^K + 1/2), for every a and K.
#pragma once

#include <fixedpoint/integer.hpp>

namespace fixedpoint {
namespace portable {

template <int K, class Raw>
FIXEDPOINT_CONSTEXPR Raw scale_down_plain(Raw a) {
    constexpr int shift = K == 0 || K >= RawLimits<Raw>::width ? 1 : K;
    return K == 0                       ? a
           : K >= RawLimits<Raw>::width ? Raw(0)
                                        : Raw((a >> shift) + (a >> (shift - 1) & 1));
}

#if defined(__AVR__) && !defined(__clang__)
// Whole bytes first, then bit by bit: by itself the compiler would shift in a loop of K iterations.
// If only whole bytes are shifted out, the top bit of the last one rounds.
template <int K, class Raw>
inline Raw scale_down_by_bytes(Raw a) {
    if (K % 8 == 0) {
        const bool up = (static_cast<uint8_t>(a >> (K < 8 ? 0 : K - 8)) & 0x80) != 0;
        a = static_cast<Raw>(a >> K);
        return up ? static_cast<Raw>(a + 1) : a;
    }
    if (sizeof a == 4) {
        a = static_cast<Raw>(a >> (K / 8 * 8));
        // Only the remaining bytes are shifted; the last bit shifted out is the carry, and rounds.
        // The compiler estimates the size of this code, and so the reach of its jumps over it, from
        // the number of lines: with more than four shifts it would underestimate it.
#define FIXEDPOINT_SHIFT_ROUNDED_IN_LINES(shift, lines)                   \
    __asm__(".rept %1\n\t" shift                                          \
            ".endr\n\tadc %A0, __zero_reg__\n\tadc %B0, __zero_reg__\n\t" \
            "adc %C0, __zero_reg__\n\tadc %D0, __zero_reg__" lines        \
            : "+r"(a)                                                     \
            : "n"(K % 8))
#define FIXEDPOINT_SHIFT_ROUNDED(shift)                               \
    if (K % 8 > 4) {                                                  \
        FIXEDPOINT_SHIFT_ROUNDED_IN_LINES(shift, "\n\n\n\n\n\n\n\n"); \
    } else {                                                          \
        FIXEDPOINT_SHIFT_ROUNDED_IN_LINES(shift, "");                 \
    }
        if (K < 8) {
            FIXEDPOINT_SHIFT_ROUNDED("asr %D0\n\tror %C0\n\tror %B0\n\tror %A0\n\t")
        } else if (K < 16) {
            FIXEDPOINT_SHIFT_ROUNDED("asr %C0\n\tror %B0\n\tror %A0\n\t")
        } else if (K < 24) {
            FIXEDPOINT_SHIFT_ROUNDED("asr %B0\n\tror %A0\n\t")
        } else {
            FIXEDPOINT_SHIFT_ROUNDED("asr %A0\n\t")
        }
#undef FIXEDPOINT_SHIFT_ROUNDED
#undef FIXEDPOINT_SHIFT_ROUNDED_IN_LINES
        return a;
    }
    constexpr unsigned char bits = K - 1;
    a = static_cast<Raw>(a >> (bits / 8 * 8));
    for (unsigned char i = 0; i < bits % 8; ++i) {
        a = static_cast<Raw>(a >> 1);
        __asm__("" : "+r"(a));
    }
    if (K == 1) return static_cast<Raw>((a >> 1) + (a & 1));  // a + 1 may overflow
    a = static_cast<Raw>(a + 1);
    __asm__("" : "+r"(a));
    return static_cast<Raw>(a >> 1);
}
template <int K, class Raw>
constexpr Raw scale_down(Raw a) {
    return K == 0 || K >= RawLimits<Raw>::width || !RawLimits<Raw>::is_signed ||
                   __builtin_constant_p(a)
               ? scale_down_plain<K>(a)
               : scale_down_by_bytes<(K == 0 || K >= RawLimits<Raw>::width ? 1 : K)>(a);
}
#else
template <int K, class Raw>
constexpr Raw scale_down(Raw a) {
    return scale_down_plain<K>(a);
}
#endif

}  // namespace portable
}  // namespace fixedpoint
