// SPDX-License-Identifier: GPL-3.0-or-later
// Watches a device loop through a scenario and decides whether the run stayed within its envelope.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "bench/experiments/haptic/device_loop.hpp"
#include "bench/experiments/haptic/scenarios.hpp"

namespace haptic {

// The limits for a loop that keeps time; none for a device without steps of constant length.
struct TimingLimits {
    Cycle step_period;        // nominal
    double loop_rate = 1000;  // Hz, at least
    double lateness = 1e-3;   // s, of any step
    double cpu_share = 0.5;
    double rendering_share = 0.05;
    double frames_per_second = 19.5;
};

struct Judgement {
    double loop_rate = 0, step_mean = 0, step_most = 0;  // Hz, s, s
    // Relative to steps of the nominal period, none of which is earlier than due; in s. NaN without
    // limits.
    double worst_lateness = std::numeric_limits<double>::quiet_NaN();
    std::uint64_t late_steps = 0;  // by more than the limit
    double cpu_share = 0, rendering_share = 0, frames_per_second = 0;
    double fall = std::numeric_limits<double>::quiet_NaN();   // s
    double swing = std::numeric_limits<double>::quiet_NaN();  // rad, where the lever must be quiet
    std::vector<std::string> violations;                      // empty if the run passed
};

// The observations of a run at one time. Angles are in rad.
struct Glance {
    double time, servo_angle, lever_angle;
    bool screen_is_right = true;
};

class Judge {
  public:
    Judge(const Scenario& scenario, std::optional<TimingLimits> limits)
        : scenario_(scenario), limits_(limits) {}

    // Must be called each millisecond.
    void watch(const Glance& glance);
    // Judges a run that ended at `end` with a virtual arm of `arm_length` m.
    Judgement judge(const Timing& timing, double end, double arm_length);

  private:
    void violate(bool violated, std::string what);
    void judge_timing(const Timing& timing, double end);

    Scenario scenario_;
    std::optional<TimingLimits> limits_;
    Judgement judgement_;
    std::optional<double> let_go_, fallen_;
    double least_ = 1e9, most_ = -1e9;
    bool screen_right_ = true, rested_ = true, held_before_ = false;
};

}  // namespace haptic
