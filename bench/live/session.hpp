// SPDX-License-Identifier: GPL-3.0-or-later
// A device in the closed loop to play with: time advances as it is told to, and keys control the
// hand at the lever, the dial and faults.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/experiments/haptic/haptic.hpp"

namespace live {

enum class Key {
    push_up,
    push_down,
    grip,
    dial_up,
    dial_down,
    unplug,
    stall,
    full_frame,
    reset,
    quit  // no effect on the device
};

struct Status {
    double time;                      // s since the session began
    double lever, servo;              // rad
    double hand_force;                // N at the lever's end
    double reading[2];                // counts
    double pulse;                     // s
    double dial;                      // 0 to 1
    std::optional<double> arm;        // m; none until the firmware has one
    bool held, stalled;               // by the hand; the servo
    std::optional<int> unplugged;     // sensor
    std::optional<double> loop_rate;  // Hz; this and the following over the last second
    double cpu_share, rendering_share;
    double frames_per_second, bytes_per_second;
    std::optional<double> lateness;   // s, of the latest step, if steps have one length
    std::vector<std::string> screen;  // lines, from the top
};

class Session {
  public:
    Session(haptic::Firmware firmware, haptic::Scenario scenario);

    void run_until(double seconds);
    double time() const { return before_ + loop_->time(); }
    void press(Key key);
    Status status() const;

    const haptic::Firmware& firmware() const { return firmware_; }
    const haptic::Scenario& scenario() const { return scenario_; }
    // A new one after each reset.
    haptic::DeviceLoop& loop() { return *loop_; }

  private:
    // A mark of the timing, at a time.
    struct Mark {
        double time;
        std::size_t steps;
        haptic::Cycle asleep, rendering;
        double frames;
        std::uint64_t bytes;
        // The latest of the steps since the mark before: its start less the periods before it, in
        // cycles.
        std::int64_t latest;
    };
    void reset();
    Mark mark(std::size_t steps_before);
    void push(double direction);
    void grip();
    void turn(double by);
    void toggle_stall();
    void unplug_next();
    std::optional<haptic::Fault> fault(haptic::Fault::Kind kind) const;

    haptic::Firmware firmware_;
    haptic::Scenario scenario_;
    simulator::Elf elf_;
    std::unique_ptr<haptic::DeviceLoop> loop_;
    double before_ = 0;  // the time of the last reset
    std::deque<Mark> marks_;
    std::int64_t on_time_ = 0;  // the smallest of all steps
};

}  // namespace live
