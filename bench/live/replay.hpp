// SPDX-License-Identifier: GPL-3.0-or-later
// The record of a session, as data for a page that replays it: angles, forces, screen and pins.
#pragma once

#include <string>
#include <vector>

#include "bench/live/session.hpp"

namespace live {

class Replay {
  public:
    static constexpr double sample = 0.004;  // s

    // Records the session since its last reset; after another reset a new Replay is needed.
    explicit Replay(Session& session);

    // Must be called every `sample` seconds.
    void watch(Session& session);

    // In SI units, except for degrees. Pins are the microseconds that they are low, high, low, ...
    // from the first sample on.
    std::string json(const Session& session) const;

  private:
    struct Sample {
        double lever, servo, told, hand, force[2], reading[2], arm;
        bool held;
    };
    struct Screen {
        double at;
        std::string cells;
    };
    std::vector<Sample> samples_;
    std::vector<Screen> screens_;
    std::vector<haptic::PinEdge> edges_;
};

}  // namespace live
