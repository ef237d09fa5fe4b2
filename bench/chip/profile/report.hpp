// SPDX-License-Identifier: GPL-3.0-or-later
// A profile and a stack bound as text for a terminal.
#pragma once

#include <string>

#include "bench/chip/profile/profiler.hpp"
#include "bench/chip/profile/stack_bound.hpp"

namespace profile {

std::string readable_report(const Profile& profile, const StackBound& bound);

}  // namespace profile
