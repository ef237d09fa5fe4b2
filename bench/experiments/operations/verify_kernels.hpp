// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the device's machine code with the host: every result bit for bit, the calling
// convention and stray writes in every call, and which instructions of each kernel were executed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "bench/lab/subjects/selection.hpp"

namespace operations {

struct VerifyOptions {
    std::vector<std::filesystem::path> programs;
    std::filesystem::path output;  // folder for kernels.csv
    Selection selection;           // operand classes are ignored
    std::uint64_t samples =
        1'000'000;  // random operands of each subject; fewer if they take over 10^9 cycles
    unsigned threads = 1;
};

// Runs each subject that the host has, too, on its boundary table, on random operands of the
// classes physics, full and uniform, and on all inputs if there are at most 65536. Writes
// kernels.csv and returns how many subjects differ from the host. A subject that does not return,
// breaks the calling convention or writes where it must not counts as different, is reported on
// stderr and left out.
std::uint64_t verify_kernels(const VerifyOptions& options);

}  // namespace operations
