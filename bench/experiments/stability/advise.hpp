// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace stability {

// The cost of a scene on the chip.
struct Cost {
    double cycles_per_step;
    double flash_bytes;
};

struct AdviceOptions {
    std::string scene;
    double error = 0;  // m, the allowed error of positions
    std::filesystem::path data;
    unsigned threads = 1;
    unsigned most = 12;  // lines
    // Runs a scene on the chip in a scalar (q16_16, float), with a method and steps of 2^-exponent
    // s. Throws std::runtime_error if the chip cannot run it.
    std::function<Cost(const std::string& scene, const std::string& scalar,
                       const std::string& method, int exponent)>
        measure;
};

// Prints the formats, methods and steps that run a scene within an error of its truth, the cheapest
// first. Returns whether there are any. Cycles that no data file contains are measured.
bool advise(const AdviceOptions& options);

// The smallest error that formats of each width reach in each scene whose truth is known, over all
// splits, methods and steps that advise() tries. Writes suitability.csv.
void measure_suitability(const std::filesystem::path& output, unsigned threads);

}  // namespace stability
