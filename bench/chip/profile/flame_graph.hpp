// SPDX-License-Identifier: GPL-3.0-or-later
// A profile as a picture: a bar for each path of calls, above the bar of its caller, whose width is
// its inclusive cycles.
#pragma once

#include <string>
#include <string_view>

#include "bench/chip/profile/profiler.hpp"

namespace profile {

// A self-contained SVG document without scripts. Pointing at a bar shows its name and cycles.
// Interrupt handlers are next to the program, on the same ground: the time awake.
std::string flame_graph(const Profile& profile, std::string_view title);

}  // namespace profile
