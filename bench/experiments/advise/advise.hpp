// SPDX-License-Identifier: GPL-3.0-or-later
// Which number format runs a user's code on the user's data within an error, and what it costs.
//
// The code is a file that defines
//
//     template <class Number> class Program { public: Number step(Number...); };
//
// for every Number that has operators and the functions of fixedpoint by their names. It is
// compiled with Recorded<double>, which reports the range of every variable and line and is the
// reference; then with the formats that can hold these ranges, on the host and for the simulated
// chip.
#pragma once

#include <filesystem>
#include <vector>

namespace advise {

struct Options {
    std::filesystem::path program;
    std::vector<std::filesystem::path> data;  // CSV: one file per run, one column per input of step
    double error = 0;                         // the largest error allowed in a result
    bool ranges_only = false;
    std::filesystem::path measured;  // operations.csv, for the estimate of cycles; may be missing
    std::filesystem::path output;    // folder for ranges.csv and advice.csv
    unsigned threads = 1;
};

// Writes ranges.csv and, unless only the ranges are wanted, advice.csv: the formats, those that
// meet the error first, the fastest of them first. Returns whether any meets it. Throws
// std::invalid_argument with one line if the program does not compile or the data are invalid.
bool advise_program(const Options& options);

}  // namespace advise
