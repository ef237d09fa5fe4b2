// SPDX-License-Identifier: GPL-3.0-or-later
// Cycles of the library's functions, built for other chips than the ATmega328P.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/lab/subjects/selection.hpp"

namespace operations {

// The classes of operands that are measured.
inline const std::vector<std::string> other_chip_operands = {"physics", "full", "boundary"};

struct OtherChipOptions {
    std::vector<std::string> chips;
    // Contains <chip>/<format>/<subject>.elf and programs.csv, as written by
    // bench/device/other_chip.py.
    std::filesystem::path programs;
    std::filesystem::path output;  // folder for other_chips.csv
    Selection selection;           // must name its formats
    std::uint64_t samples = 1000;  // of each class
    unsigned threads = 1;
};

// Writes other_chips.csv. Returns how many results contradict their definition. A subject that does
// not return or breaks the calling convention counts as one, is reported on stderr and left out.
// Throws std::invalid_argument if nothing is selected.
std::uint64_t measure_other_chips(const OtherChipOptions& options);

}  // namespace operations
