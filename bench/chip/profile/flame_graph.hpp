// SPDX-License-Identifier: GPL-3.0-or-later
// A profile as a picture: a bar for each path of calls, as wide as its inclusive cycles, upon the
// bar of its caller.
#pragma once

#include <string>
#include <string_view>

#include "bench/chip/profile/profiler.hpp"

namespace profile {

// A self-contained SVG document without scripts; a bar names itself and its cycles when pointed at.
// Interrupt handlers stand beside the program, on the same ground: the time awake.
std::string flame_graph(const Profile& profile, std::string_view title);

}  // namespace profile
