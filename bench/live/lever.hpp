// SPDX-License-Identifier: GPL-3.0-or-later
// A session with the lever, at a terminal or alone.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "bench/experiments/haptic/scenarios.hpp"

namespace live {

struct Options {
    std::string arithmetic = "q16_16", scenario;
    std::filesystem::path firmware, record;
    std::optional<double> seconds;
};

// Pushed up, held while the dial makes the arm longer, released: falls, bounces, rests.
haptic::Scenario demonstration();

// Returns the exit code. Throws std::exception with one line if the options cannot be met.
int run_lever(const Options& options);

}  // namespace live
