// SPDX-License-Identifier: GPL-3.0-or-later
// Programs of device/program.cpp in any split of the bits, built on demand.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace scene_bench {

struct TooLarge : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The program of a scene in a scalar (float, q5_27 and the like), with a method and steps of
// 2^-exponent s. It stays in the build folder, and is rebuilt only if one of its source files is
// newer. Throws TooLarge if it exceeds the flash, and std::runtime_error with the compiler's first
// error if the format cannot hold the scene.
std::filesystem::path any_program(std::string_view scene, std::string_view scalar,
                                  std::string_view method, int exponent);

}  // namespace scene_bench
