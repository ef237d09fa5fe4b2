// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated time against the clock on the wall. A machine that cannot keep up falls behind by
// `most_behind` at most: what is beyond is given up, never made up for.
#pragma once

#include <algorithm>

namespace live {

class Pace {
  public:
    static constexpr double most_behind = 0.1;  // s

    explicit Pace(double wall) : origin_(wall), since_(wall) {}

    // The simulated time that it ought to be, where it is `simulated` by now. Both in s.
    double due(double wall, double simulated) {
        origin_ = std::max(origin_, wall - simulated - most_behind);
        if (wall - since_ >= 1) {
            factor_ = (simulated - simulated_since_) / (wall - since_);
            since_ = wall;
            simulated_since_ = simulated;
        }
        return wall - origin_;
    }
    // Simulated seconds a second, over the last one.
    double factor() const { return factor_; }

  private:
    double origin_, since_, simulated_since_ = 0, factor_ = 1;
};

}  // namespace live
