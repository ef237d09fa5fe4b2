// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of scenes on the simulated chip: the programs of device/program.cpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "bench/experiments/scenes/scene.hpp"
#include "this_build.hpp"

namespace scene_bench {

// How a scalar is stored in memory.
struct Layout {
    int bytes;
    int fraction_bits;  // -1: an IEEE single
    // One past the largest magnitude; infinite for a float.
    double range() const;
    double value(const std::uint8_t* raw) const;
};
// For a scalar by its name: float, or q<I>_<F>, optionally followed by an arithmetic.
Layout layout_of(std::string_view scalar);

// The folder of the build's programs.
inline std::filesystem::path scene_programs() {
    return build_folder() / "bench/experiments/scenes/programs";
}

// <scene>.<scalar>.<method>.<exponent>.elf in the folder. With the exponent `hash`, the program
// that can report hashes.
std::filesystem::path program_path(const std::filesystem::path& folder, std::string_view scene,
                                   std::string_view scalar, std::string_view method,
                                   std::string_view exponent);

struct ChipRun : Run {
    std::uint64_t steps = 0;
    // Of a step, including its call (4) and return (4).
    double cycles_mean = 0;
    std::uint32_t cycles_max = 0;
    std::uint16_t stack_bytes = 0;  // maximum, including the return address of the step
    std::uint32_t flash_bytes = 0;  // building and stepping, without start-up code and main()
    std::uint32_t ram_bytes = 0;
};

// Builds the scene and steps for its duration. With hashes, the program reports the hash after each
// step. A number that is not finite ends the run with a failure, like an error of the engine.
ChipRun run_on_chip(const std::filesystem::path& program, const Scene& scene,
                    std::string_view scalar, int exponent, Hashes hashes);

}  // namespace scene_bench
