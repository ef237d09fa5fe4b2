// SPDX-License-Identifier: GPL-3.0-or-later
// `fixbench lever`: the device live in a terminal, and its recordings.
#pragma once

#include <CLI/CLI.hpp>

#include "bench/lab/command.hpp"

namespace live {

void add_lever_command(CLI::App& app, fixbench::Action& action);

}  // namespace live
