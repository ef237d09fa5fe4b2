// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/world_of.hpp"

namespace stability {

std::vector<Subject> subjects_of_q16_16_published() {
    return subjects_of_format<16, 16, RecordingPublished>("q16_16", "published");
}

}  // namespace stability
