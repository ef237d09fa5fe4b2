// SPDX-License-Identifier: MIT
// sqrt: floor(sqrt(a 2^F)), bit by bit. a < 0: 0.
// Ken Turkowski, "Fixed Point Square Root", Apple Technical Report 96, 1994.
#pragma once

#include <fixedpoint/integer.hpp>

namespace fixedpoint {
namespace published {

// Two bits of the radicand give one bit of the root: W/2 iterations for the bits of a, F/2 for the
// zeros that follow them (16 + 8 for Q16.16). The device does not have an instruction for the shift
// by W - 2, so it is a loop within each iteration: that is most of the cost. Corrected: a negative
// radicand has a result.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw sqrt(Raw a) {
    static_assert(F % 2 == 0,
                  "The published square root takes two bits of the radicand per iteration: "
                  "the number of fraction bits must be even.");
    static_assert(F <= RawLimits<Raw>::width - 4,
                  "The remainder of the published square root, at most 4 times the root, must fit: "
                  "at least four integer bits are needed.");
    using U = Unsigned<Raw>;
    if (a <= 0) return 0;
    U root = 0;
    U remainder = 0;
    U radicand = static_cast<U>(a);
    uint8_t rounds = RawLimits<Raw>::width / 2 + F / 2;
    do {
        remainder = static_cast<U>(static_cast<U>(remainder << 2) |
                                   static_cast<U>(radicand >> (RawLimits<Raw>::width - 2)));
        radicand = static_cast<U>(radicand << 2);
        root = static_cast<U>(root << 1);
        const U trial = static_cast<U>(static_cast<U>(root << 1) | 1);
        if (remainder >= trial) {
            remainder = static_cast<U>(remainder - trial);
            root = static_cast<U>(root | 1);
        }
    } while (--rounds != 0);
    return static_cast<Raw>(root);
}

}  // namespace published
}  // namespace fixedpoint
