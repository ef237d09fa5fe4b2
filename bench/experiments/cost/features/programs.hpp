// SPDX-License-Identifier: GPL-3.0-or-later
// The programs that were compiled with a feature and without it.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace features {

// GRAVITY, RODS ... and the scene's choices: 3 (dimensions), VelocityVerlet, BruteForce ...
using Uses = std::set<std::string>;

struct Program {
    std::string scene, feature;
    bool with;
    Uses uses;
    std::filesystem::path measured, uninlined;
};

// Throws std::runtime_error if the folder's programs.csv is missing or malformed.
std::vector<Program> load_programs(const std::filesystem::path& folder);

}  // namespace features
