// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/world_of.hpp"

namespace stability {

std::vector<Subject> subjects_of_double() {
    return subjects_with<double>("double", "ieee", std::numeric_limits<double>::max(), 0);
}

}  // namespace stability
