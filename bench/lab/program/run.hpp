// SPDX-License-Identifier: GPL-3.0-or-later
// Runs another program until it ends.
#pragma once

#include <string>
#include <vector>

namespace fixbench {

struct Ran {
    bool succeeded;  // it started and exited with 0
    std::string out, err;
};

// The first argument is the program, by its path or found in PATH. No shell interprets the others.
Ran run(std::vector<std::string> arguments);

}  // namespace fixbench
