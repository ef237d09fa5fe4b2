// SPDX-License-Identifier: MIT
// The steps of pseudo-division and pseudo-multiplication, for logarithms and exponentials.
#pragma once

#include <fixedpoint/portable/cordic.hpp>
#include <fixedpoint/portable/pseudo_division_table.hpp>

namespace fixedpoint {
namespace portable {

// ln(1 + 2^-i) with Bits - 6 fraction bits. After the end of the table it is 2^-i - 2^-2i / 2,
// within 2^-3i / 3; formats with up to 63 fraction bits do not go that far.
template <class Word, int most>
FIXEDPOINT_CONSTEXPR Word logarithm_of_factor(int i) {
    using Constants = PseudoDivisionConstants<Word>;
    constexpr int count = static_cast<int>(sizeof Constants::logarithm / sizeof(Word));
    constexpr int bits = cordic_bits<Word>();
    return most <= count || i <= count
               ? read_program_memory(Constants::logarithm[i - 1])
               : (Word(1) << (bits - 6 - i)) - (Word(1) << (bits - 7 - 2 * i));
}

}  // namespace portable
}  // namespace fixedpoint
