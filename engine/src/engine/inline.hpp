// SPDX-License-Identifier: MIT
// ENGINE_INLINE and, behind the parameters of a lambda, ENGINE_INLINE_LAMBDA: short functions that
// the device's compiler must not call out of line, even where it optimises for size: a call by
// reference costs more than what they do.
#pragma once

#define ENGINE_INLINE inline __attribute__((always_inline))
#define ENGINE_INLINE_LAMBDA __attribute__((always_inline))

namespace engine {

// n, of which the compiler knows no value: a loop to it is not unrolled, where flash is what
// counts.
template <class Number>
inline Number unknown(Number n) {
    __asm__("" : "+r"(n));
    return n;
}

}  // namespace engine
