// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of scenes on the simulated chip: the programs of device/program.cpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "bench/experiments/scenes/scene.hpp"

namespace scene_bench {

// How a scalar lies in memory.
struct Layout {
    int bytes;
    int fraction_bits;  // -1: an IEEE single
    // One past the largest magnitude; infinite for a float.
    double range() const;
    double value(const std::uint8_t* raw) const;
};
// Of a scalar by its name: float, or q<I>_<F> with any arithmetic behind it.
Layout layout_of(std::string_view scalar);

// <scene>.<scalar>.<method>.<exponent>.elf of the folder; with the exponent `hash`, the program
// that can tell hashes.
std::filesystem::path program_path(const std::filesystem::path& folder, std::string_view scene,
                                   std::string_view scalar, std::string_view method,
                                   std::string_view exponent);

struct ChipRun : Run {
    std::uint64_t steps = 0;
    // Of a step, its call (4) and return (4) included.
    double cycles_mean = 0;
    std::uint32_t cycles_max = 0;
    std::uint16_t stack_bytes = 0;  // at most, the return address of the step included
    std::uint32_t flash_bytes = 0;  // building and stepping, without start-up code and main()
    std::uint32_t ram_bytes = 0;
};

// Builds the scene and steps for its duration. With hashes, the program tells the hash after each
// step. A number that is not finite ends the run with a failure, as an error of the engine does.
ChipRun run_on_chip(const std::filesystem::path& program, const Scene& scene,
                    std::string_view scalar, int exponent, Hashes hashes);

}  // namespace scene_bench
