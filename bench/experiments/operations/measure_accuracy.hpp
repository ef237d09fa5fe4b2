// SPDX-License-Identifier: GPL-3.0-or-later
// The error of the library's portable code against the exact reference: over every input if there
// are at most 2^32, otherwise over boundary tables, random operands and a search for the worst.
#pragma once

#include <cstdint>
#include <filesystem>

#include "bench/lab/subjects/selection.hpp"

namespace operations {

struct AccuracyOptions {
    std::filesystem::path output;  // folder for accuracy.csv and its companions
    Selection selection;
    bool quick = false;  // sample the spaces of more than 2^16 inputs
    // The folder of the three files of an earlier run. If it is named, the spaces of more than 2^24
    // inputs are not exhausted again: their rows are kept after they have been checked against the
    // witness of the largest error and against samples.
    std::filesystem::path kept;
    unsigned threads = 1;
};

// Writes accuracy.csv, error_histograms.csv and error_along_input.csv. Returns how many results
// contradict their definition; the first of each subject is reported on stderr.
std::uint64_t measure_accuracy(const AccuracyOptions& options);

}  // namespace operations
