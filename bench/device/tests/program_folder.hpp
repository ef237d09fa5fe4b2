// SPDX-License-Identifier: GPL-3.0-or-later
// Where a test finds its programs for the chip: in the build folder, or in the one that the
// environment variable DEVICE_PROGRAMS names, where scripts/mutation_test.py builds faults.
#pragma once

#include <cstdlib>
#include <string>

#include "this_build.hpp"

inline std::string program_folder() {
    const char* other = std::getenv("DEVICE_PROGRAMS");
    return other ? other : build_folder() / "bench/device";
}
