// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench profile: where a device program's cycles and stack go.
#pragma once

#include <CLI/CLI.hpp>

#include "bench/lab/command.hpp"

namespace profile {

void add_profile_command(CLI::App& app, fixbench::Action& action);

}  // namespace profile
