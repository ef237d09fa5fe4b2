// SPDX-License-Identifier: GPL-3.0-or-later
// Runs subjects of the device program on classes of operands: cycles, stack and error of each, and
// whether every result follows its definition.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "bench/lab/subjects/selection.hpp"

namespace operations {

struct CycleOptions {
    // Device programs. Next to each there may be a table <name>.footprints.csv (subject,
    // flash_bytes, ram_bytes) with its footprints.
    std::vector<std::filesystem::path> programs;
    std::filesystem::path output;  // folder for operations.csv, flash.csv and operations.json
    Selection selection;
    std::uint64_t samples =
        20000;  // of each random class; fewer if they take over measurement_cycles
    unsigned threads = 1;
};

// Writes operations.csv, flash.csv and operations.json. Returns how many results contradict their
// definition; the first of each subject is reported on stderr. Throws std::invalid_argument if
// nothing is selected or a name is unknown. A subject that does not return, breaks the calling
// convention or writes where it must not counts as one such result, is reported on stderr and left
// out of the files.
std::uint64_t measure_cycles(const CycleOptions& options);

}  // namespace operations
