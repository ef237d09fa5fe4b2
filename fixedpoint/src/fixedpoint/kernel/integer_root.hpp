// SPDX-License-Identifier: MIT
// floor(sqrt(n)) of an integer, by the square root of a fixed-point format.
#pragma once

#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/portable/integer_root.hpp>

namespace fixedpoint {
namespace kernel {

// root, or one less if its square exceeds n; 0 if root is 0. root must be at most 2^(W/2), whose
// square wraps to 0.
template <class Word>
FIXEDPOINT_CONSTEXPR __attribute__((noinline)) Word root_not_above(Word root, Word n) {
    using Half = UnsignedInteger<(sizeof(Word) > 4 ? 32 : sizeof(Word) > 2 ? 16 : 8)>;
    if (root == 0) return 0;
    const Half half = static_cast<Half>(root);
    const Word square = static_cast<Word>(static_cast<Word>(half) * half);
    return static_cast<Word>(square - 1) >= n ? static_cast<Word>(root - 1) : root;
}

// floor(sqrt(n)); 0 if n < 0. The format with equal integer and fraction bits gives the root in
// units of 2^-(W/4), rounded to nearest. If that is an integer, it is the root or one more. n from
// 2^(W-1) on is not a number of the format; its root is twice that of n / 4, whose dropped bits are
// below the rounding.
template <class Int>
FIXEDPOINT_CONSTEXPR Unsigned<Int> integer_root(Int n) {
    using Word = Unsigned<Int>;
    using Raw = Integer<RawLimits<Int>::width>;
    constexpr int fraction = RawLimits<Int>::width / 2, below = fraction / 2;
    const bool is_large = Int(0) < static_cast<Int>(-1) && static_cast<Raw>(n) < 0;
    const Word scaled = static_cast<Word>(
        sqrt<Raw, fraction>(static_cast<Raw>(is_large ? static_cast<Int>(n >> 2) : n)));
    const Word root = static_cast<Word>(scaled >> (is_large ? below - 1 : below));
    return (static_cast<uint16_t>(scaled) & ((1u << (below - 1)) - 1)) != 0
               ? root
               : root_not_above(root, static_cast<Word>(n));
}

}  // namespace kernel
}  // namespace fixedpoint
