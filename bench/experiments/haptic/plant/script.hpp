// SPDX-License-Identifier: GPL-3.0-or-later
// What happens to the device from outside over time: the hand, the dial and faults.
//
//     Script script;
//     script.hand_angle.from(degrees(60)).ramp(1, 1.2, degrees(30));
//     script.hand_grip.from(1).step(2, 0);  // lets go after two seconds
//     script.faults.push_back({Fault::Kind::unplugged, 0, 0.5, 1});
#pragma once

#include <stdexcept>
#include <vector>

namespace haptic {

// A value over time, linear between its points and constant before and after them.
class Signal {
  public:
    Signal(double value = 0) : points_{{0, value}} {}

    // Sets the value from the start on and forgets everything else.
    Signal& from(double value) {
        points_ = {{0, value}};
        return *this;
    }
    // Constant until `time`, then jumps.
    Signal& step(double time, double value) {
        add(time, points_.back().value);
        add(time, value);
        return *this;
    }
    // Constant until `begin`, then changes linearly until `end`.
    Signal& ramp(double begin, double end, double value) {
        add(begin, points_.back().value);
        add(end, value);
        return *this;
    }
    double at(double time) const;

  private:
    struct Point {
        double time, value;
    };
    // Times must not decrease: std::invalid_argument otherwise.
    void add(double time, double value);

    std::vector<Point> points_;
};

struct Fault {
    enum class Kind {
        unplugged,  // a sensor's wire is off: 0 V at the converter
        shorted,    // a sensor's wires touch: the supply at the converter
        stalled,    // the servo's shaft does not turn
    };
    Kind kind;
    int sensor;         // 0 or 1; ignored for a stalled servo
    double begin, end;  // s
};

struct Script {
    Signal hand_angle;  // rad: where the hand wants the lever
    Signal hand_grip;   // from 0 (released) to 1: the hand's full stiffness, damping and mass
    Signal hand_force;  // N at the lever's end towards rising angles, in addition
    Signal dial{0.5};   // 0 to 1 of the supply
    std::vector<Fault> faults;
};

}  // namespace haptic
