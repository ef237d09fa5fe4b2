// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench scenes and fixbench workload.
#pragma once

#include <CLI/CLI.hpp>

#include "bench/lab/command.hpp"

namespace scene_bench {

void add_scenes_command(CLI::App& app, fixbench::Action& action);
void add_workload_command(CLI::App& app, fixbench::Action& action);

}  // namespace scene_bench
