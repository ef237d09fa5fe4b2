// SPDX-License-Identifier: MIT
/// \file
/// The square root of an integer.
#pragma once

#include <fixedpoint/builtin.hpp>
#include <fixedpoint/integer.hpp>

namespace fixedpoint {

/// floor(sqrt(n)) of an integer of any type, exact; 0 where n < 0.
template <class Int>
FIXEDPOINT_CONSTEXPR Int isqrt(Int n) {
    static_assert(BuiltinNumber<Int>::kind == BuiltinKind::integer,
                  "isqrt takes an integer: sqrt is for a fixed-point number.");
    using Word = Unsigned<Int>;
    if (n < Int(1)) return 0;
    // Bit by bit: root^2 <= n, and rest = n - root^2 up to powers of four.
    Word rest = static_cast<Word>(n), root = 0;
    for (Word bit = static_cast<Word>(Word(1) << (RawLimits<Int>::width - 2)); bit != 0;
         bit = static_cast<Word>(bit >> 2)) {
        const Word trial = static_cast<Word>(root + bit);
        root = static_cast<Word>(root >> 1);
        if (rest >= trial) {
            rest = static_cast<Word>(rest - trial);
            root = static_cast<Word>(root + bit);
        }
    }
    return static_cast<Int>(root);
}

}  // namespace fixedpoint
