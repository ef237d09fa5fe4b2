// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of a device, as a picture.
#pragma once

#include <optional>

#include "bench/live/picture.hpp"
#include "bench/live/session.hpp"

namespace live {

// Of the clock on the wall; none in a recording that nobody waits for.
struct WallClock {
    double seconds;  // since the session began
    double factor;   // simulated seconds a second, of late
};

Picture panel(const Session& session, const std::optional<WallClock>& clock);

}  // namespace live
