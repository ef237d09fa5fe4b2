// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/haptic/scenarios.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace haptic {
namespace {

// The hand holds the lever at an angle from the start.
Script held_at(double angle) {
    Script script;
    script.hand_angle.from(angle);
    script.hand_grip.from(1);
    script.dial.from(0);  // the shortest arm, 23 cm
    return script;
}

}  // namespace

std::vector<Scenario> scenarios(const Travel& travel) {
    const double middle = (travel.raised + travel.lowered) / 2;
    // Towards the top, so that the hand carries the weight.
    const double push = travel.raised > travel.lowered ? 1 : -1;
    std::vector<Scenario> list;

    // Published: a 20 cm arm falls in about 0.18 s, so 23 cm in 0.18 sqrt(23 / 20) = 0.19 s. The
    // release by the hand takes part of it, the servo's frame 20 ms.
    Scenario s{
        "release_and_fall", "held at the top, let go after 1 s", 3, held_at(travel.raised), 1, {}};
    s.script.hand_grip.step(1, 0);
    s.envelope.fall = {0.10, 0.35};
    list.push_back(s);

    s = {"bounce", "the same, watched until it rests", 6, held_at(travel.raised), 1, {}};
    s.script.hand_grip.step(1, 0);
    s.envelope.fall = {0.10, 0.35};
    // The number of turns is not limited: it depends on when in the servo's period the hand lets
    // go.
    s.envelope.rest = {5, travel.lowered};
    list.push_back(s);

    s = {"push_and_hold",
         "pushed up from rest to the middle within 0.5 s, then held still",
         5,
         held_at(travel.lowered),
         1,
         {}};
    s.script.hand_angle.ramp(1, 1.5, middle);
    s.envelope.quiet = {3, degrees(1.5)};
    list.push_back(s);

    s = {"slow_dial", "held in the middle while the dial goes from end to end in 4 s",
         6,           held_at(middle),
         1,           {}};
    s.script.dial.ramp(1, 5, 1);
    s.envelope.arm = {5.5, {0.97, 1}};
    s.envelope.quiet = {2, degrees(3)};
    list.push_back(s);

    s = {"fast_dial", "held in the middle while the dial jumps between its ends",
         6,           held_at(middle),
         1,           {}};
    s.script.dial.step(1, 1).step(1.5, 0).step(2, 1).step(2.1, 0).step(2.2, 1);
    s.envelope.arm = {3, {0.97, 1}};
    s.envelope.quiet = {4, degrees(1.5)};
    list.push_back(s);

    s = {"poke_while_held",
         "held in the middle, poked with 3 N for 50 ms",
         5,
         held_at(middle),
         1,
         {}};
    s.script.hand_force.step(2, 3 * push).step(2.05, 0);
    s.envelope.quiet = {3.5, degrees(1.5)};
    list.push_back(s);

    s = {"stall", "the servo is blocked for 1 s while the lever falls",
         6,       held_at(travel.raised),
         1,       {}};
    s.script.hand_grip.step(1, 0);
    s.script.faults.push_back({Fault::Kind::stalled, 0, 1.05, 2.05});
    s.envelope.rest = {5, travel.lowered};
    list.push_back(s);

    for (const auto& [name, kind] : {std::pair{"sensor_unplugged", Fault::Kind::unplugged},
                                     std::pair{"sensor_shorted", Fault::Kind::shorted}}) {
        s = {name, "each sensor in turn for 0.5 s, with nobody at the lever",
             8,    held_at(travel.lowered),
             1,    {}};
        s.script.hand_grip.from(0);
        s.script.faults.push_back({kind, 0, 1, 1.5});
        s.script.faults.push_back({kind, 1, 3, 3.5});
        s.envelope.rest = {7, travel.lowered};
        list.push_back(s);
    }

    s = {"noise", "held in the middle with ten times the noise of the converter",
         5,       held_at(middle),
         10,      {}};
    s.envelope.quiet = {2, degrees(3)};
    list.push_back(s);

    s = {"hours", "two hours: pushed and let go once a minute", 7200, held_at(travel.raised), 1,
         {}};
    for (double minute = 0; minute < 7200; minute += 60) {
        s.script.hand_angle.step(minute, travel.raised);
        s.script.hand_grip.step(minute, 1).step(minute + 2, 0);
    }
    s.envelope.rest = {7190, travel.lowered};
    list.push_back(s);
    return list;
}

Scenario scenario(std::string_view name, const Travel& travel) {
    std::string names;
    for (Scenario& s : scenarios(travel)) {
        if (s.name == name) return s;
        names += (names.empty() ? "" : ", ") + s.name;
    }
    throw std::invalid_argument(fmt::format("no scenario '{}'; allowed are {}", name, names));
}

}  // namespace haptic
