// SPDX-License-Identifier: GPL-3.0-or-later
// A session with the lever, at a terminal or by itself.
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

// Pushed up, held while the dial makes the arm longer, let go: falls, bounces, rests.
haptic::Scenario demonstration();

// Returns the exit code; throws std::exception with a line for whoever asked for what cannot be.
int run_lever(const Options& options);

}  // namespace live
