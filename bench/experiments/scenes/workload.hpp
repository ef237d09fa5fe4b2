// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the published workload: the lever's step and its parts.
#pragma once

#include <filesystem>

#include "this_build.hpp"

namespace scene_bench {

// The folder of the build's programs.
inline std::filesystem::path workload_programs() {
    return build_folder() / "bench/experiments/scenes/workload";
}

struct WorkloadOptions {
    std::filesystem::path programs;  // folder of the device programs
    std::filesystem::path output;
    unsigned threads = 1;
};

// Writes workload.csv, workload_rounds.csv and workload_trace.csv.
void measure_workload(const WorkloadOptions& options);

}  // namespace scene_bench
