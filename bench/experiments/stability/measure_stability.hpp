// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stability {

struct Options {
    std::filesystem::path output;
    unsigned threads = 1;
    bool quick = false;
    std::vector<std::string> cases, scalars, integrators;  // empty: all
};

// Whether only some of the cases or subjects are selected.
bool is_selection(const Options& options);

// Throws std::invalid_argument if a name does not exist.
void check_selection(const Options& options);

// Writes stability.csv and, for all cases, envelope.csv, stability_map.csv, ablations.csv and,
// unless quick, suitability.csv.
void measure_stability(const Options& options);

}  // namespace stability
