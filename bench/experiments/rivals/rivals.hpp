// SPDX-License-Identifier: GPL-3.0-or-later
// Measures other libraries' arithmetic on the simulated chip, built from the user's checkouts.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rivals {

struct Options {
    std::map<std::string, std::filesystem::path> sources;  // checkouts, by rival
    std::filesystem::path kept;  // rivals.csv of an earlier run; empty: none
    std::filesystem::path output;
    std::string date;  // of this run
    std::uint64_t samples = 2000;
    unsigned threads = 1;
};

// The names in rivals.json, and those that need no source.
std::vector<std::string> known_rivals();

// Measures the rivals that need no source and those whose checkouts are named, and writes
// rivals.csv. The rows of the others are those of the earlier run. Rows whose figures did not
// change keep their date. Throws std::invalid_argument with one line if a checkout does not build.
void measure_rivals(const Options& options);

}  // namespace rivals
