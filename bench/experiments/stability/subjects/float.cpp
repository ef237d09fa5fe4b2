// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/world_of.hpp"

namespace stability {

std::vector<Subject> subjects_of_float() {
    return subjects_with<float>("float", "ieee", std::numeric_limits<float>::max(), 0);
}

}  // namespace stability
