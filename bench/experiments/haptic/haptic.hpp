// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the firmware through the scenarios in the closed loop.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/experiments/haptic/judge.hpp"
#include "bench/experiments/haptic/recording.hpp"

namespace haptic {

// A program that can be flashed, e.g. lever, lever_published, lever_float.
struct Firmware {
    std::string arithmetic;
    std::filesystem::path elf;
    std::optional<TimingLimits> limits;
    bool flashed = false;  // the device itself, which must pass; the others are for comparison
};

// q16_16, published and float, from the folder that contains their ELF files.
std::vector<Firmware> firmwares(const std::filesystem::path& folder);

struct Run {
    std::string scenario, arithmetic;
    double duration;
    Judgement judgement;
    Timing timing;
    unsigned stack_bytes;
    std::string elf_sha256;
};

// Runs to the end of the scenario. `record` is a folder for the recording's files; empty: none.
Run run(const Firmware& firmware, const Scenario& scenario, const Parameters& parameters,
        const std::filesystem::path& record = {});

struct Options {
    std::filesystem::path firmware, output, record;
    std::vector<std::string> scenarios, arithmetics;  // empty: all
    // The limit of a scenario's duration in s. By default an hour for the device that is flashed,
    // and four minutes for the others.
    std::optional<double> longest;
    unsigned threads = 1;
};

// Writes haptic.csv. Returns the number of runs that left their envelope although they must pass.
std::uint64_t run_scenarios(const Options& options);

}  // namespace haptic
