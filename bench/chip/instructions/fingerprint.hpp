// SPDX-License-Identifier: GPL-3.0-or-later
// Identifies the function that a measurement is valid for: its own instructions and tables,
// wherever the linker puts them.
#pragma once

#include <string>
#include <string_view>

#include "bench/chip/instructions/translate.hpp"
#include "bench/chip/simulator/elf.hpp"

namespace instructions {

// SHA-256, in hexadecimal, of the instructions that the function's control flow can reach and the
// tables that they name, with addresses replaced by ordinal numbers. Two functions with equal
// fingerprints give equal results in equal cycles. Throws TranslationError if the program was
// linked without --emit-relocs: it is then unknown which constants are addresses.
std::string fingerprint(const simulator::Elf& elf, std::string_view symbol);

}  // namespace instructions
