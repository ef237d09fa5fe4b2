// SPDX-License-Identifier: GPL-3.0-or-later
// Error against run time: every scene in every scalar, method and time step.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scene_bench {

struct SceneOptions {
    std::vector<std::string> scenes, scalars, methods;  // empty: all
    std::filesystem::path programs;                     // folder of the device programs
    std::filesystem::path output;
    unsigned threads = 1;
    bool quick = false;  // coarse time steps only
};

// The device programs that such a run reads, by their paths. Throws std::invalid_argument where a
// name is none or nothing is selected.
std::vector<std::string> programs_of(const SceneOptions& options);

// Writes scenes.csv. Throws where a name is none, a program is missing, or chip and host differ.
void measure_scenes(const SceneOptions& options);

}  // namespace scene_bench
