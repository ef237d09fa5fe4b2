// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of a device, as a picture.
#pragma once

#include <optional>

#include "bench/live/picture.hpp"
#include "bench/live/session.hpp"

namespace live {

// The wall clock; none in a recording that nobody waits for.
struct WallClock {
    double seconds;  // since the session began
    double factor;   // simulated seconds per second, recently
};

Picture panel(const Session& session, const std::optional<WallClock>& clock);

}  // namespace live
