// SPDX-License-Identifier: GPL-3.0-or-later
// Compares what a program contains, by its symbols, with what its scene uses: the proof that unused
// features are not linked.
#pragma once

#include <string>
#include <vector>

#include "bench/chip/simulator/elf.hpp"
#include "bench/experiments/cost/features/programs.hpp"

namespace features {

// Functions and tables in the program that nothing in the scene needs, with the feature that they
// belong to: "sqrt_table of square roots". Must be empty.
std::vector<std::string> unneeded(const simulator::Elf& elf, const Uses& uses);

// What the scene uses and the program does not contain. If this is not empty for a program whose
// functions are not inlined, the rules of unneeded() look for the wrong names.
std::vector<std::string> missing(const simulator::Elf& elf, const Uses& uses);

}  // namespace features
