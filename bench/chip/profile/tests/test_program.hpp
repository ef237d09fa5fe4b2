// SPDX-License-Identifier: GPL-3.0-or-later
// The test programs made by the build.
#pragma once

#include <string>

#include "bench/chip/simulator/elf.hpp"
#include "this_build.hpp"

namespace profile {

inline simulator::Elf test_program(const std::string& name) {
    return simulator::Elf(build_folder() / "bench/chip/profile" /
                          ("profile_test_" + name + ".elf"));
}

}  // namespace profile
