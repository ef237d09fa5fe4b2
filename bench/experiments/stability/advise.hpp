// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace stability {

struct AdviceOptions {
    std::string scene;
    double error = 0;  // m, that positions may have
    std::filesystem::path data;
    unsigned threads = 1;
    unsigned most = 12;  // lines
};

// Prints the formats, methods and steps that run a scene within an error of its truth, cheapest
// first; whether there are any.
bool advise(const AdviceOptions& options);

// The least error that formats of each width reach in each scene whose truth is known, over all
// splits, methods and steps that advise() tries. Writes suitability.csv.
void measure_suitability(const std::filesystem::path& output, unsigned threads);

}  // namespace stability
