// SPDX-License-Identifier: GPL-3.0-or-later
// Device programs are built only when an experiment reads them.
#pragma once

#include <string>
#include <vector>

namespace fixbench {

// Builds targets of the build folder, or files below it by their paths. Prints to stderr what it
// builds, and nothing if everything is up to date. Does nothing in a step of `fixbench all`, which
// has built everything before. Throws std::runtime_error if the build fails.
void build(const std::vector<std::string>& targets);

}  // namespace fixbench
