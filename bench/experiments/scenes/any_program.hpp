// SPDX-License-Identifier: GPL-3.0-or-later
// Programs of device/program.cpp in any split of the bits, made when they are asked for.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace scene_bench {

struct TooLarge : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The program of a scene in a scalar (float, q5_27 and the like), a method and steps of 2^-exponent
// s. It stays in the build folder, and is made anew only where a file that it is made of is newer.
// Throws TooLarge where it exceeds the flash, else std::runtime_error with the compiler's first
// error where the format cannot hold the scene.
std::filesystem::path any_program(std::string_view scene, std::string_view scalar,
                                  std::string_view method, int exponent);

}  // namespace scene_bench
