// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench growth: what a step costs against the number of particles.
#pragma once

#include <CLI/CLI.hpp>

#include "bench/lab/command.hpp"

namespace growth {

void add_growth_command(CLI::App& app, fixbench::Action& action);

}  // namespace growth
