// SPDX-License-Identifier: GPL-3.0-or-later
// What a measurement of a function holds for: its own instructions and tables, wherever the linker
// puts them.
#pragma once

#include <string>
#include <string_view>

#include "bench/chip/instructions/translate.hpp"
#include "bench/chip/simulator/elf.hpp"

namespace instructions {

// SHA-256, in hexadecimal, over the instructions that the function's control flow can meet and the
// tables that they name, with addresses replaced by ordinal numbers. Two functions of equal
// fingerprints give equal results in equal cycles. Throws TranslationError where the program was
// linked without --emit-relocs: which constants are addresses is then not known.
std::string fingerprint(const simulator::Elf& elf, std::string_view symbol);

}  // namespace instructions
