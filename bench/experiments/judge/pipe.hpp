// SPDX-License-Identifier: GPL-3.0-or-later
// Operands and results as text, for programs in any language:
//
//     fixbench operands --as divide:q8_24 --class boundary | ./mine | fixbench judge --pipe --as
//     divide:q8_24
//
// A line is one call: the operands, and in what is judged the results behind them, as decimal raw
// numbers with blanks between. Of vectors and several results one component follows the other; an
// IEEE single is its pattern as an int32. `#` begins a comment up to the end of the line; a line
// without numbers means nothing.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

#include "bench/experiments/judge/claim.hpp"

namespace judge {

// Writes operands of a class: those of operand_class.hpp, "boundary", of which each says what it
// is, or "all". Throws std::invalid_argument for another class, and for "all" of more than 32 bits.
void write_operands(const Claim& claim, const std::string& operand_class, std::uint64_t samples,
                    std::uint64_t seed, std::FILE* out);

struct Piped {
    std::uint64_t calls = 0;
    reference::ErrorStatistics errors;
};

// Judges all lines. Throws std::invalid_argument that names the line where it is none of a call,
// and where there is no call at all.
Piped judge_lines(const Claim& claim, std::FILE* in);

}  // namespace judge
