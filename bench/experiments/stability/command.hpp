// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include "bench/lab/command.hpp"

namespace stability {

void add_stability_command(CLI::App& app, fixbench::Action& action);

}  // namespace stability
