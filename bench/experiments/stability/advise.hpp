// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace stability {

// What a scene takes on the chip.
struct Cost {
    double cycles_per_step;
    double flash_bytes;
};

struct AdviceOptions {
    std::string scene;
    double error = 0;  // m, that positions may have
    std::filesystem::path data;
    unsigned threads = 1;
    unsigned most = 12;  // lines
    // Runs a scene on the chip in a scalar (q16_16, float), a method and steps of 2^-exponent s.
    // Throws std::runtime_error where the chip cannot.
    std::function<Cost(const std::string& scene, const std::string& scalar,
                       const std::string& method, int exponent)>
        measure;
};

// Prints the formats, methods and steps that run a scene within an error of its truth, cheapest
// first; whether there are any. What no data file has the cycles of is measured.
bool advise(const AdviceOptions& options);

// The least error that formats of each width reach in each scene whose truth is known, over all
// splits, methods and steps that advise() tries. Writes suitability.csv.
void measure_suitability(const std::filesystem::path& output, unsigned threads);

}  // namespace stability
