// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/world_of.hpp"

namespace stability {

std::vector<Subject> subjects_of_q8_24() {
    return subjects_of_format<8, 24, Recording>("q8_24", "nearest");
}

}  // namespace stability
