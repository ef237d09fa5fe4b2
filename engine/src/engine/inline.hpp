// SPDX-License-Identifier: MIT
// ENGINE_INLINE and, after the parameters of a lambda, ENGINE_INLINE_LAMBDA mark short functions
// that the device's compiler must inline even when it optimises for size: a call that passes
// references costs more than they do.
#pragma once

#define ENGINE_INLINE inline __attribute__((always_inline))
#define ENGINE_INLINE_LAMBDA __attribute__((always_inline))

namespace engine {

// The number, with its value hidden from the compiler, for code where flash matters most: a loop of
// that many rounds is not unrolled, and no code is specialised for that value.
template <class Number>
inline Number unknown(Number number) {
    __asm__("" : "+r"(number));
    return number;
}

}  // namespace engine
