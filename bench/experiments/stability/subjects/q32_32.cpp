// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/world_of.hpp"

namespace stability {

std::vector<Subject> subjects_of_q32_32() {
    return subjects_of_format<32, 32, Recording>("q32_32", "nearest");
}

}  // namespace stability
