// SPDX-License-Identifier: GPL-3.0-or-later
// The test programs made by the build.
#pragma once

#include <string>

#include "bench/chip/simulator/elf.hpp"
#include "this_build.hpp"

namespace instructions {

inline std::string test_program(const std::string& name) {
    return build_folder() / "bench/chip/instructions" / ("instructions_test_" + name + ".elf");
}

}  // namespace instructions
