// SPDX-License-Identifier: GPL-3.0-or-later
// What a program holds, told from its symbols, against what its scene uses: the proof that what is
// not used is not linked.
#pragma once

#include <string>
#include <vector>

#include "bench/chip/simulator/elf.hpp"
#include "bench/experiments/cost/features/programs.hpp"

namespace features {

// Functions and tables in the program that nothing which the scene uses has need of, with what
// they belong to: "sqrt_table of square roots". Empty for a program as it should be.
std::vector<std::string> unneeded(const simulator::Elf& elf, const Uses& uses);

// What the scene uses and the program does not show. In a program whose functions are not inlined,
// it is empty; else the rules of unneeded() look for the wrong names.
std::vector<std::string> missing(const simulator::Elf& elf, const Uses& uses);

}  // namespace features
