// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a profile and a stack bound as files.
#pragma once

#include <filesystem>
#include <string>

#include "bench/chip/profile/profiler.hpp"
#include "bench/chip/profile/stack_bound.hpp"

namespace profile {

// Writes profile_<program>.csv, interrupts_<program>.csv, stack_<program>.csv and
// stacks_<program>.folded.
void save_tables(const Profile& profile, const StackBound& bound, const std::string& program,
                 const std::filesystem::path& folder);

// Writes the flame graph <program>_flame.svg.
void save_figure(const Profile& profile, const std::string& program,
                 const std::filesystem::path& folder);

}  // namespace profile
