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
    std::vector<std::string> cases, scalars, integrators;  // all where empty
};

// Whether only a part of the cases or subjects is asked for.
bool is_selection(const Options& options);

// Throws std::invalid_argument where a name is none.
void check_selection(const Options& options);

// Writes stability.csv and, of all cases, envelope.csv,
// stability_map.csv, ablations.csv and, where not quick, suitability.csv.
void measure_stability(const Options& options);

}  // namespace stability
