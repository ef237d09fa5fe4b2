// SPDX-License-Identifier: GPL-3.0-or-later
// The test programs made by the build.
#pragma once

#include <string>

#include "bench/chip/simulator/chip.hpp"

namespace simulator {

inline Elf test_program(const std::string& name) {
    return Elf(std::string(TEST_PROGRAM_DIRECTORY) + "/simulator_test_" + name + ".elf");
}

}  // namespace simulator
