// SPDX-License-Identifier: GPL-3.0-or-later
// Device programs are built when an experiment reads them, and only those.
#pragma once

#include <string>
#include <vector>

namespace fixbench {

// Builds targets of the build folder, or files below it by their paths. Says on stderr what it
// builds, nothing where all is up to date. A step of `fixbench all` builds nothing: that was done
// before it. Throws std::runtime_error where the build fails.
void build(const std::vector<std::string>& targets);

}  // namespace fixbench
