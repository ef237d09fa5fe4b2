// SPDX-License-Identifier: GPL-3.0-or-later
// Other libraries' arithmetic on the simulated chip, built from checkouts that the user has.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rivals {

struct Options {
    std::map<std::string, std::filesystem::path> sources;  // checkouts, by rival
    std::filesystem::path kept;  // rivals.csv of an earlier run; none where empty
    std::filesystem::path output;
    std::string date;  // of this run
    std::uint64_t samples = 2000;
    unsigned threads = 1;
};

// The names in rivals.json; those that need no source.
std::vector<std::string> known_rivals();

// Measures the rivals that need no source and those whose checkouts are named, writes rivals.csv.
// Rows of the others are those of the earlier run, and so are rows whose figures did not change:
// they keep their date. Throws std::invalid_argument of one line where a checkout does not build.
void measure_rivals(const Options& options);

}  // namespace rivals
