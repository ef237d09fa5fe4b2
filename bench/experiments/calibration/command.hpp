// SPDX-License-Identifier: GPL-3.0-or-later
// `fixbench calibrate`.
#pragma once

#include <CLI/CLI.hpp>

#include "bench/lab/command.hpp"

namespace calibration {

void add_calibrate_command(CLI::App& app, fixbench::Action& action);

}  // namespace calibration
