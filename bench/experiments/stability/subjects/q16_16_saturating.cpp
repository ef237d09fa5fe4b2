// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/world_of.hpp"

namespace stability {

std::vector<Subject> subjects_of_q16_16_saturating() {
    return subjects_of_format<16, 16, RecordingSaturating>("q16_16", "saturating");
}

}  // namespace stability
