// SPDX-License-Identifier: GPL-3.0-or-later
// The scenes of the engine as descriptions.
#pragma once

#include <string>
#include <vector>

#include "bench/experiments/stability/description.hpp"

namespace stability {

// Its duration is in `steps` steps of `dt`, a binary step. Throws std::runtime_error where there is
// no such scene, or none in two dimensions.
Description describe_scene(const std::string& name, int exponent);
// Those in two dimensions.
std::vector<std::string> plane_scenes();

}  // namespace stability
