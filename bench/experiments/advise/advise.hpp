// SPDX-License-Identifier: GPL-3.0-or-later
// Which number format runs somebody's code on somebody's data within an error, and what it costs.
//
// The code is a file that defines
//
//     template <class Number> class Program { public: Number step(Number...); };
//
// for every Number with operators and the functions of fixedpoint by their names. It is compiled
// with Recorded<double>, which tells the range of every variable and line and is the reference;
// then with the formats that hold these ranges, on the host and for the simulated chip.
#pragma once

#include <filesystem>
#include <vector>

namespace advise {

struct Options {
    std::filesystem::path program;
    std::vector<std::filesystem::path> data;  // CSV: a run each, a column for each input of step
    double error = 0;                         // the largest that a result may have
    bool ranges_only = false;
    std::filesystem::path
        measured;  // operations.csv, from which cycles are estimated; may be missing
    std::filesystem::path output;  // folder for ranges.csv and advice.csv
    unsigned threads = 1;
};

// Writes ranges.csv, and unless that is all, advice.csv: the formats, those that meet the error
// first, the fastest of them first. Returns whether any meets it. Throws std::invalid_argument of
// one line where the program does not compile or the data are wrong.
bool advise_program(const Options& options);

}  // namespace advise
