// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench region: where the lever holds still.
#pragma once

#include <CLI/CLI.hpp>

#include "bench/lab/command.hpp"

namespace haptic::region {

void add_region_command(CLI::App& app, fixbench::Action& action);

}  // namespace haptic::region
