// SPDX-License-Identifier: GPL-3.0-or-later
// The firmware through the scenarios, in the closed loop.
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

// A program that is flashed, e.g. lever, lever_published, lever_float.
struct Firmware {
    std::string arithmetic;
    std::filesystem::path elf;
    std::optional<TimingLimits> limits;
    bool flashed = false;  // the device itself, which has to hold; the others are shown beside it
};

// q16_16, published, float, from the folder that holds their ELF files.
std::vector<Firmware> firmwares(const std::filesystem::path& folder);

struct Run {
    std::string scenario, arithmetic;
    double duration;
    Judgement judgement;
    Timing timing;
    unsigned stack_bytes;
    std::string elf_sha256;
};

// To the end of the scenario. `record` gets a folder's worth of files, unless empty.
Run run(const Firmware& firmware, const Scenario& scenario, const Parameters& parameters,
        const std::filesystem::path& record = {});

struct Options {
    std::filesystem::path firmware, output, record;
    std::vector<std::string> scenarios, arithmetics;  // all where empty
    // s of a scenario; by itself an hour of the device that is flashed, four minutes of the others.
    std::optional<double> longest;
    unsigned threads = 1;
};

// Writes haptic.csv; returns the number of runs that left their envelope where they must not.
std::uint64_t run_scenarios(const Options& options);

}  // namespace haptic
