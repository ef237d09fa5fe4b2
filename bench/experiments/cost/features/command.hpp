// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench features: what each feature of the engine costs in flash, RAM and cycles.
#pragma once

#include <CLI/CLI.hpp>

#include "bench/lab/command.hpp"

namespace features {

void add_features_command(CLI::App& app, fixbench::Action& action);

}  // namespace features
