// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated time relative to the wall clock. A machine that cannot keep up falls behind by at most
// `max_behind`; any further delay is given up, never made up for.
#pragma once

#include <algorithm>

namespace live {

class Pace {
  public:
    static constexpr double max_behind = 0.1;  // s

    explicit Pace(double wall) : origin_(wall), since_(wall) {}

    // The simulated time that should be reached, where `simulated` is reached by now. Both in s.
    double due(double wall, double simulated) {
        origin_ = std::max(origin_, wall - simulated - max_behind);
        if (wall - since_ >= 1) {
            factor_ = (simulated - simulated_since_) / (wall - since_);
            since_ = wall;
            simulated_since_ = simulated;
        }
        return wall - origin_;
    }
    // Simulated seconds per second, over the last second.
    double factor() const { return factor_; }

  private:
    double origin_, since_, simulated_since_ = 0, factor_ = 1;
};

}  // namespace live
