// SPDX-License-Identifier: GPL-3.0-or-later
// The scenes of the engine as descriptions.
#pragma once

#include <string>
#include <vector>

#include "bench/experiments/stability/description.hpp"

namespace stability {

// The scene's duration is in `steps` steps of `dt`, a binary step. Throws std::runtime_error if
// there is no such scene, or if it is not in two dimensions.
Description describe_scene(const std::string& name, int exponent);
// The scenes in two dimensions.
std::vector<std::string> plane_scenes();

}  // namespace stability
