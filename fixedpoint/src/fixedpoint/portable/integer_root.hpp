// SPDX-License-Identifier: MIT
// floor(sqrt(n)) of an unsigned integer, without a multiplication.
#pragma once

#include <fixedpoint/integer.hpp>

namespace fixedpoint {
namespace portable {

// Bit by bit: root^2 <= n, and rest = n - root^2 up to powers of four.
template <class Word>
FIXEDPOINT_CONSTEXPR Word integer_root(Word n) {
    Word rest = n, root = 0;
    for (Word bit = static_cast<Word>(Word(1) << (8 * sizeof(Word) - 2)); bit != 0;
         bit = static_cast<Word>(bit >> 2)) {
        const Word trial = static_cast<Word>(root + bit);
        root = static_cast<Word>(root >> 1);
        if (rest >= trial) {
            rest = static_cast<Word>(rest - trial);
            root = static_cast<Word>(root + bit);
        }
    }
    return root;
}

}  // namespace portable
}  // namespace fixedpoint
