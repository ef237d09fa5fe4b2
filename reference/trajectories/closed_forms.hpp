// SPDX-License-Identifier: GPL-3.0-or-later
// The motion of scenes in closed form.
#pragma once

#include <algorithm>
#include <cmath>
#include <scenes/all.hpp>
#include <stdexcept>

#include "reference/trajectories/state.hpp"
#include "reference/trajectories/swing.hpp"
#include "reference/trajectories/vector.hpp"

namespace reference {
namespace motion {

template <class Function>
Trajectory at_each(const Times& times, Function state_at) {
    check(times);
    Trajectory trajectory;
    for (double time : times) trajectory.push_back(state_at(time));
    return trajectory;
}

// A free body with the state `from` at 0 s.
inline ParticleState thrown(const ParticleState& from, double gravity, double time) {
    ParticleState now = from;
    now.position = from.position + time * from.velocity;
    now.position[1] -= gravity / 2 * time * time;
    now.velocity[1] -= gravity * time;
    return now;
}

inline Trajectory swinging(const Swing& swing, const Times& times) {
    return at_each(times, [&](double time) { return State{at(swing, time)}; });
}

}  // namespace motion

inline Trajectory trajectory(const scenes::FreeFall::Parameters<double>& with, const Times& times) {
    const ParticleState start = {{0, with.height, 0}, {with.velocity_x, with.velocity_y, 0}};
    return motion::at_each(
        times, [&](double time) { return State{motion::thrown(start, with.gravity, time)}; });
}

// Every contact with the floor is a bounce, however slow. The ball lands with the velocity v after
// sqrt(2 h / g); the n-th flight takes 2 restitution^n v / g.
inline Trajectory trajectory(const scenes::BouncingBall::Parameters<double>& with,
                             const Times& times) {
    const double drop = with.height - with.radius;
    const double landing = std::sqrt(2 * drop / with.gravity);
    return motion::at_each(times, [&](double time) {
        ParticleState ball = {{with.velocity_x * time, with.radius, 0}, {with.velocity_x, 0, 0}};
        double height = 0, speed = 0, since = 0;
        if (time < landing) {
            height = drop;
            since = time;
        } else {
            speed = with.restitution * with.gravity * landing;
            since = time - landing;
            constexpr double at_rest = 1e-12;  // m/s
            while (speed > at_rest && since > 2 * speed / with.gravity) {
                since -= 2 * speed / with.gravity;
                speed *= with.restitution;
            }
            if (speed <= at_rest) return State{ball};
        }
        ball.position[1] += height + (speed - with.gravity / 2 * since) * since;
        ball.velocity[1] = speed - with.gravity * since;
        return State{ball};
    });
}

// Along the line of the spring: extension'' + 2 d extension' + k/m extension = 0 from rest.
inline Trajectory trajectory(const scenes::SpringAndMass::Parameters<double>& with,
                             const Times& times) {
    const double length = std::hypot(with.x, with.y);
    const std::array<double, 3> direction = {with.x / length, with.y / length, 0};
    const double stretch = length - with.rest_length;
    const double d = with.damping * with.inverse_mass / 2;
    const double square = with.stiffness * with.inverse_mass - d * d;
    if (!(square > 0))
        throw std::invalid_argument("the spring's motion is known only where it oscillates");
    const double w = std::sqrt(square);
    return motion::at_each(times, [&](double time) {
        const double decay = stretch * std::exp(-d * time);
        const double extension = decay * (std::cos(w * time) + d / w * std::sin(w * time));
        const double velocity = -decay * (w + d * d / w) * std::sin(w * time);
        return State{{(with.rest_length + extension) * direction, velocity * direction}};
    });
}

inline Trajectory trajectory(const scenes::TwoBodyCollision::Parameters<double>& with,
                             const Times& times) {
    const double approach = with.velocity - with.other_velocity;
    const double reach = 2 * with.radius;
    const bool meet = approach > 0 && std::abs(with.other_y) < reach;
    const double gap = std::sqrt(std::max(0.0, reach * reach - with.other_y * with.other_y));
    const double meeting = meet ? (with.other_x - gap) / approach : HUGE_VAL;
    const std::array<double, 3> normal = {-gap / reach, -with.other_y / reach, 0};
    const double impulse = -(1 + with.restitution) * approach * normal[0] /
                           (with.inverse_mass + with.other_inverse_mass);
    return motion::at_each(times, [&](double time) {
        ParticleState a = {{}, {with.velocity, 0, 0}};
        ParticleState b = {{with.other_x, with.other_y, 0}, {with.other_velocity, 0, 0}};
        const double before = std::min(time, meeting), after = time - before;
        a.position = before * a.velocity;
        b.position = b.position + before * b.velocity;
        if (after > 0) {
            a.velocity = a.velocity + impulse * with.inverse_mass * normal;
            b.velocity = b.velocity - impulse * with.other_inverse_mass * normal;
        }
        a.position = a.position + after * a.velocity;
        b.position = b.position + after * b.velocity;
        return State{a, b};
    });
}

// All balls fall side by side. A ball stops when it has closed all gaps below it, on balls that are
// at rest already.
inline Trajectory trajectory(const scenes::Stack::Parameters<double>& with, const Times& times) {
    return motion::at_each(times, [&](double time) {
        State state;
        for (unsigned i = 0; i < scenes::Stack::balls; ++i) {
            const double drop = (i + 1) * with.gap;
            const double rest = (2 * i + 1) * with.radius;
            const bool falls = with.gravity / 2 * time * time < drop;
            const ParticleState start = {{0, rest + drop, 0}, {}};
            const ParticleState lying = {{0, rest, 0}, {}};
            state.push_back(falls ? motion::thrown(start, with.gravity, time) : lying);
        }
        return state;
    });
}

inline Trajectory trajectory(const scenes::Pendulum::Parameters<double>& with, const Times& times) {
    return motion::swinging({{0, 0}, {with.x, with.y}, {0, -with.gravity}}, times);
}

inline Trajectory trajectory(const scenes::Lever::Parameters<double>& with, const Times& times) {
    return motion::swinging(
        {{with.pivot_x, with.pivot_y},
         {with.end_x, with.end_y},
         {with.force_x * with.inverse_mass, with.force_y * with.inverse_mass - with.gravity}},
        times);
}

inline Trajectory trajectory(const scenes::PublishedLever::Parameters<double>& with,
                             const Times& times) {
    if (with.damping != 1)
        throw std::invalid_argument("the lever's motion is known only without damping");
    const ParticleState pivot = {{0.38, 0.15, 0}, {}};
    const double x = 0.1 - 0.38, y = 0 - 0.15;
    const double pull = with.length / std::hypot(x, y);
    const Swing swing = {{0.38, 0.15}, {0.38 + pull * x, 0.15 + pull * y}, {0, -9.81}};
    return motion::at_each(times, [&](double time) { return State{pivot, at(swing, time)}; });
}

// The moving ball's momentum passes through the row instantly: the row swings as one pendulum, one
// half of whose swing is seen at the first ball and the other at the last.
inline Trajectory trajectory(const scenes::NewtonsCradle::Parameters<double>& with,
                             const Times& times) {
    if (with.restitution != 1 || !(with.x < 0))
        throw std::invalid_argument(
            "the cradle's motion is known only for restitution 1 and x < 0");
    const Swing swing = {{0, 0}, {with.x, with.y}, {0, -with.gravity}};
    return motion::at_each(times, [&](double time) {
        State state;
        for (unsigned i = 0; i < scenes::NewtonsCradle::balls; ++i)
            state.push_back({{2 * i * with.radius, -with.length, 0}, {}});
        ParticleState moving = at(swing, time);
        const std::size_t which = moving.position[0] < 0 ? 0 : state.size() - 1;
        moving.position[0] += state[which].position[0];
        state[which] = moving;
        return state;
    });
}

}  // namespace reference
