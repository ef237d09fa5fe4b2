// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/world_of.hpp"

namespace stability {

std::vector<Subject> subjects_of_q16_16() {
    return subjects_of_format<16, 16, Recording>("q16_16", "nearest");
}

}  // namespace stability
