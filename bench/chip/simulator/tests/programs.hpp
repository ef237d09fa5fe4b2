// SPDX-License-Identifier: GPL-3.0-or-later
// The test programs made by the build.
#pragma once

#include <string>

#include "bench/chip/simulator/chip.hpp"
#include "this_build.hpp"

namespace simulator {

inline Elf test_program(const std::string& name) {
    return Elf(build_folder() / "bench/chip/simulator" / ("simulator_test_" + name + ".elf"));
}

}  // namespace simulator
