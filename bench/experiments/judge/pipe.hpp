// SPDX-License-Identifier: GPL-3.0-or-later
// Operands and results as text, for programs in any language:
//
//     fixbench operands --as divide:q8_24 --class boundary | ./mine | fixbench judge --pipe --as
//     divide:q8_24
//
// A line is one call: the operands and, if it is to be judged, the results after them, as decimal
// raw numbers separated by spaces. The components of vectors, and several results, follow one after
// the other. An IEEE single is its pattern as an int32. `#` starts a comment to the end of the
// line; a line without numbers is ignored.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

#include "bench/experiments/judge/claim.hpp"

namespace judge {

// Writes operands of a class: one of operand_class.hpp, "boundary", with a description of each, or
// "all". Throws std::invalid_argument for any other class, and for "all" of more than 32 bits.
void write_operands(const Claim& claim, const std::string& operand_class, std::uint64_t samples,
                    std::uint64_t seed, std::FILE* out);

struct Piped {
    std::uint64_t calls = 0;
    reference::ErrorStatistics errors;
};

// Judges all lines. Throws std::invalid_argument that names the line if it is not a call, or if
// there is no call at all.
Piped judge_lines(const Claim& claim, std::FILE* in);

}  // namespace judge
