// SPDX-License-Identifier: GPL-3.0-or-later
// Error against run time: every scene in every scalar, method and time step.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/lab/records/record.hpp"

namespace scene_bench {

// A row of scenes.csv. Runs on the host have no cycles and bytes, and where no true motion is known
// there are no errors.
struct SceneRow {
    std::string scene, scalar, arithmetic, integrator;
    double dt;
    std::uint64_t steps;
    std::optional<double> cycles_per_step_mean, cycles_per_step_max, cycles_per_simulated_second;
    std::optional<double> error, error_method, error_arithmetic;
    std::string unit;
    double energy_drift;
    std::optional<double> flash_bytes, ram_bytes, stack_bytes;
    std::string verdict;

    static constexpr auto columns = std::tuple(
        records::column("scene", &SceneRow::scene), records::column("scalar", &SceneRow::scalar),
        records::column("arithmetic", &SceneRow::arithmetic),
        records::column("integrator", &SceneRow::integrator), records::column("dt", &SceneRow::dt),
        records::column("steps", &SceneRow::steps),
        records::column("cycles_per_step_mean", &SceneRow::cycles_per_step_mean),
        records::column("cycles_per_step_max", &SceneRow::cycles_per_step_max),
        records::column("cycles_per_simulated_second", &SceneRow::cycles_per_simulated_second),
        records::column("error", &SceneRow::error),
        records::column("error_method", &SceneRow::error_method),
        records::column("error_arithmetic", &SceneRow::error_arithmetic),
        records::column("unit", &SceneRow::unit),
        records::column("energy_drift", &SceneRow::energy_drift),
        records::column("flash_bytes", &SceneRow::flash_bytes),
        records::column("ram_bytes", &SceneRow::ram_bytes),
        records::column("stack_bytes", &SceneRow::stack_bytes),
        records::column("verdict", &SceneRow::verdict));
};

struct SceneOptions {
    std::vector<std::string> scenes, scalars, methods;  // empty: all
    std::filesystem::path programs;                     // folder of the device programs
    std::filesystem::path output;
    unsigned threads = 1;
    bool quick = false;  // coarse time steps only, fewer programs for the chip
};

// The device programs that such a run needs, by their paths. Throws std::invalid_argument if a name
// does not exist or nothing is selected.
std::vector<std::string> programs_of(const SceneOptions& options);

// Writes scenes.csv. Throws if a name does not exist, a program is missing, or chip and host
// differ.
void measure_scenes(const SceneOptions& options);

}  // namespace scene_bench
