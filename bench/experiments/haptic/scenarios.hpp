// SPDX-License-Identifier: GPL-3.0-or-later
// The scenarios of the closed loop, each defined once and by name, with the envelope that its run
// must stay in. Envelopes, never traces: absolute figures depend on the plant's assumptions.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/experiments/haptic/plant/plant.hpp"

namespace haptic {

// The firmware's stops as servo angles.
struct Travel {
    double raised = degrees(60);  // the lever's end at the top
    double lowered = 0;           // where gravity takes it
};

struct Span {
    double least, most;
};

// The requirements of a run. In every scenario, in addition: the servo's command is within the
// travel (half a step more is allowed), a pulse comes every 20 ms, and no byte of a full frame is
// lost.
struct Envelope {
    // The seconds from the hand's release until the servo first comes within a degree of `lowered`.
    std::optional<Span> fall;
    // From this time on, the largest swing of the lever about its mean, peak to peak, in rad.
    struct Quiet {
        double from, max_swing;
    };
    std::optional<Quiet> quiet;
    // From this time on, the share of the dial that the firmware's arm length must correspond to.
    struct Settled {
        double from;
        Span dial;
    };
    std::optional<Settled> arm;
    // From this time on, everything is as without the fault: the servo rests within a degree of
    // `angle`.
    struct Rest {
        double from, angle;
    };
    std::optional<Rest> rest;
};

struct Scenario {
    std::string name, what;
    double duration;  // s
    Script script;
    double noise_factor = 1;  // multiplies the plant's noise of the converter
    Envelope envelope;

    Parameters adapted(Parameters parameters) const {
        parameters.electrical.noise *= noise_factor;
        return parameters;
    }
};

// All of them, in this order: release_and_fall, bounce, push_and_hold, slow_dial,
// fast_dial, poke_while_held, stall, sensor_unplugged, sensor_shorted, noise, hours.
std::vector<Scenario> scenarios(const Travel& travel = {});

// Throws std::invalid_argument for any other name, with a message that lists the names.
Scenario scenario(std::string_view name, const Travel& travel = {});

}  // namespace haptic
