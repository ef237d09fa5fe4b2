// SPDX-License-Identifier: GPL-3.0-or-later
// The levers whose stable region is looked for: each arithmetic at each loop rate, with and without
// its selective damping, compiled for the host.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/experiments/haptic/region/held_lever.hpp"
#include "bench/experiments/haptic/region/released_lever.hpp"

namespace haptic::region {

// What the linear model has to know of a lever's firmware.
struct Law {
    double step;          // s; 0 where the clock is the report's
    double servo_delay;   // s, by which the servo is led
    double damping;       // share of its way that a step against the push slows the arm, 0 to 1
    bool position_first;  // explicit Euler
};

struct Device {
    std::string arithmetic;  // q16_16, float, published
    std::string change;      // to the flashed lever, if one of changes()
    bool damped;
    int rate;  // 2^rate steps a second; 0: by the report's clock
    Law law;
    // On the host; a step takes so long, in s, on the chip.
    Swing (*hold)(const Parameters&, double arm, Start, double step_takes);
    std::optional<double> (*fall)(const Parameters&, double step_takes);
};

constexpr int slowest = 7, fastest = 11;  // rates

// Each arithmetic at each rate, damped and not; and the report's at its own clock.
std::vector<Device> devices();

// The flashed lever, with what makes it stable left out in turn, and the other levers as they are.
std::vector<Device> changes();

}  // namespace haptic::region
