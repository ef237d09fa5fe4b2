// SPDX-License-Identifier: MIT
// The working word of the shift-and-add rotations (Jack Volder, "The CORDIC trigonometric computing
// technique", 1959): the narrowest one with at least twelve bits more than the fraction of the
// result, for guard bits and the growth of the vector. Angles have Bits - 2 fraction bits.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/cordic_table.hpp>

namespace fixedpoint {
namespace portable {

template <int F, bool Fits32 = (F <= CordicConstants<uint32_t>::largest_fraction_bits),
          bool Fits64 = (F <= CordicConstants<uint64_t>::largest_fraction_bits)>
struct CordicWordOf {
    using Type = Word128;
};
template <int F>
struct CordicWordOf<F, false, true> {
    using Type = uint64_t;
};
template <int F>
struct CordicWordOf<F, true, true> {
    using Type = uint32_t;
};
template <int F>
using CordicWord = typename CordicWordOf<F>::Type;

template <class Word>
constexpr int cordic_bits() {
    return static_cast<int>(8 * sizeof(Word));
}

// An unsigned integer with its top bit moved to bit Bits - 3 of the word; lower bits are truncated.
template <class Word, class Coordinate>
FIXEDPOINT_CONSTEXPR Word cordic_coordinate(Coordinate a) {
    constexpr int surplus = RawLimits<Coordinate>::width - (cordic_bits<Word>() - 2);
    return surplus > 0 ? Word(a >> (surplus > 0 ? surplus : 0))
                       : Word(a) << (surplus > 0 ? 0 : -surplus);
}

// An angle or coordinate with Bits - 2 fraction bits, rounded to F bits, signed and saturated.
template <class Raw, int F, class Word>
FIXEDPOINT_CONSTEXPR Raw round_from_cordic(Word magnitude, bool negative) {
    constexpr int surplus = cordic_bits<Word>() - 2 - F;
    return saturated_with_sign<Raw>((magnitude + (Word(1) << (surplus - 1))) >> surplus, negative);
}

}  // namespace portable
}  // namespace fixedpoint
