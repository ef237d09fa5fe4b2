// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench haptic: the firmware in the closed loop.
#pragma once

#include <CLI/CLI.hpp>

#include "bench/lab/command.hpp"

namespace haptic {

void add_haptic_command(CLI::App& app, fixbench::Action& action);

}  // namespace haptic
