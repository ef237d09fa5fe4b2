// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as plain numbers for all scalars: what a world is built from. SI units.
#pragma once

#include <cstdint>
#include <vector>

namespace stability {

struct Point {
    double x = 0, y = 0, z = 0;  // z in three dimensions only
};

struct Body {
    Point position{}, velocity{};
    double inverse_mass = 1;  // 1/kg
    double radius = 0;
    Point force{};       // N, constant
    double damping = 1;  // factor of the velocity in each step
};

constexpr int no_body = -1;  // as b of a link: its other end is the anchor

struct Link {
    int a = 0, b = no_body;
    Point anchor{};
    double length = 1;
};
struct Spring : Link {
    double stiffness = 0, damping = 0;
};
struct Rope : Link {
    double restitution = 0;
};
struct Drag {
    int a = 0;
    double linear = 0, quadratic = 0;
};
struct Plane {
    Point normal{};
    double offset = 0, restitution = 0;
};

// 2^-exponent s, or a step in seconds that the scalar rounds.
struct TimeStep {
    int exponent = 10;
    double seconds = 0;  // used if the step is not a power of two

    static TimeStep binary(int exponent) { return {exponent, 0}; }
    static TimeStep of_seconds(double seconds) { return {0, seconds}; }
    double value() const {
        return seconds > 0 ? seconds : 1.0 / double(std::int64_t(1) << exponent);
    }
};

struct Description {
    std::vector<Body> bodies;
    std::vector<Spring> springs;
    std::vector<Link> rods;
    std::vector<Rope> ropes;
    std::vector<Drag> drags;
    std::vector<Plane> planes;
    Point gravity{};
    double restitution = 0, restitution_threshold = 0;
    TimeStep dt;
    unsigned steps = 1000;
    // From this step on the first anchored rod has this length, as if somebody turned the dial.
    unsigned dial_step = 0;
    double dial_length = 0;
};

struct BodyState {
    Point position, velocity;
};
using State = std::vector<BodyState>;

}  // namespace stability
