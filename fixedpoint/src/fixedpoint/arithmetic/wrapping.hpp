// SPDX-License-Identifier: MIT
// Wrapping: the operations that are exact modulo 2^W, whatever else an arithmetic does, and the
// division by a power of two.
#pragma once

#include <fixedpoint/portable/scale_down.hpp>

namespace fixedpoint {

struct Wrapping {
    // (a + b) mod 2^W.
    template <class Raw, int F>
    static constexpr Raw add(Raw a, Raw b) {
        return wrapping_add(a, b);
    }
    // (a - b) mod 2^W.
    template <class Raw, int F>
    static constexpr Raw subtract(Raw a, Raw b) {
        return wrapping_subtract(a, b);
    }
    // -a mod 2^W: the smallest number is its own negative.
    template <class Raw, int F>
    static constexpr Raw negate(Raw a) {
        return wrapping_negate(a);
    }
    // a 2^count mod 2^W; 0 from count = W on.
    template <class Raw, int F>
    static constexpr Raw shift_left(Raw a, unsigned char count) {
        return wrapping_shift_left(a, count);
    }
    // a / 2^K rounded to nearest, ties upward.
    template <int K, class Raw>
    static constexpr Raw scale_down(Raw a) {
        return portable::scale_down<K>(a);
    }
};

}  // namespace fixedpoint
