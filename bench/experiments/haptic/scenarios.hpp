// SPDX-License-Identifier: GPL-3.0-or-later
// What happens to the device in the closed loop, each once and by name, with the envelope that its
// run has to stay in. Envelopes, never traces: absolute figures hang on the plant's assumptions.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/experiments/haptic/plant/plant.hpp"

namespace haptic {

// Where the firmware's stops are on the servo.
struct Travel {
    double raised = degrees(60);  // the lever's end at the top
    double lowered = 0;           // where gravity takes it
};

struct Span {
    double least, most;
};

// What is asserted of a run. In every scenario besides: the servo is commanded within the travel
// (by half a step more at most), a pulse comes every 20 ms, and no byte of a full frame is lost.
struct Envelope {
    // Seconds from the hand's letting go until the servo first comes within a degree of `lowered`.
    std::optional<Span> fall;
    // From this time on, the largest swing of the lever about its mean, peak to peak, in rad.
    struct Quiet {
        double from, most_swing;
    };
    std::optional<Quiet> quiet;
    // From this time on, the share of the dial that the firmware's arm length must stand for.
    struct Settled {
        double from;
        Span dial;
    };
    std::optional<Settled> arm;
    // From this time on everything is as it would be had no fault been: the servo rests within a
    // degree of `angle`.
    struct Rest {
        double from, angle;
    };
    std::optional<Rest> rest;
};

struct Scenario {
    std::string name, what;
    double duration;  // s
    Script script;
    double noise_factor = 1;  // on the plant's noise of the converter
    Envelope envelope;

    Parameters adapted(Parameters parameters) const {
        parameters.electrical.noise *= noise_factor;
        return parameters;
    }
};

// All of them, in the order of this list: release_and_fall, bounce, push_and_hold, slow_dial,
// fast_dial, poke_while_held, stall, sensor_unplugged, sensor_shorted, noise, hours.
std::vector<Scenario> scenarios(const Travel& travel = {});

// Throws std::invalid_argument that lists the names there are.
Scenario scenario(std::string_view name, const Travel& travel = {});

}  // namespace haptic
