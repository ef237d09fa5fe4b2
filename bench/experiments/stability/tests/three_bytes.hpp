// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "bench/experiments/stability/subject.hpp"

namespace stability {

// In Q8.16; not in subjects().
std::vector<Subject> subjects_of_three_bytes();

}  // namespace stability
