// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of three bytes with every method. No data file has them; `fixbench advise` tries them.
#include "bench/experiments/stability/tests/three_bytes.hpp"

#include "bench/experiments/stability/world_of.hpp"

namespace stability {

std::vector<Subject> subjects_of_three_bytes() {
    return subjects_of_format<8, 16, Recording>("q8_16", "nearest");
}

}  // namespace stability
