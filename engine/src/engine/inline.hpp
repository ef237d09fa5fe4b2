// SPDX-License-Identifier: MIT
// ENGINE_INLINE and, behind the parameters of a lambda, ENGINE_INLINE_LAMBDA: short functions that
// the device's compiler must not call out of line, even where it optimises for size: a call by
// reference costs more than what they do.
#pragma once

#define ENGINE_INLINE inline __attribute__((always_inline))
#define ENGINE_INLINE_LAMBDA __attribute__((always_inline))

namespace engine {

// The number, with its value hidden from the compiler, where flash is what counts: no loop of that
// many rounds is unrolled, and no code is compiled once more for that value.
template <class Number>
inline Number unknown(Number number) {
    __asm__("" : "+r"(number));
    return number;
}

}  // namespace engine
