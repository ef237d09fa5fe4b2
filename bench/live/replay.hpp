// SPDX-License-Identifier: GPL-3.0-or-later
// What a session did, as data for a page that replays it: angles, forces, screen and pins.
#pragma once

#include <string>
#include <vector>

#include "bench/live/session.hpp"

namespace live {

class Replay {
  public:
    static constexpr double sample = 0.004;  // s

    // Of the session since its last reset: another one is needed behind the next.
    explicit Replay(Session& session);

    // To be called each `sample` seconds.
    void watch(Session& session);

    // In SI units but for degrees; pins as the microseconds that they are low, high, low, ... from
    // the first sample on.
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
