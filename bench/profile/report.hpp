// SPDX-License-Identifier: GPL-3.0-or-later
// A profile and a stack bound as text for a terminal and as files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "bench/profile/profiler.hpp"
#include "bench/profile/stack_bound.hpp"

namespace profile {

std::string readable_report(const Profile& profile, const StackBound& bound);

// Writes profile.csv, interrupts.csv, stack.csv, stacks.folded and flame_graph.svg.
void save_report(const Profile& profile, const StackBound& bound, std::string_view title,
                 const std::filesystem::path& folder);

}  // namespace profile
