// SPDX-License-Identifier: GPL-3.0-or-later
// states_of<Scene>(): the runs of a scene from drawn initial states, on the host.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "bench/experiments/scenes/host/describe.hpp"
#include "bench/experiments/scenes/initial_states.hpp"
#include "bench/experiments/scenes/judge.hpp"

namespace scene_bench {

// Draws that are the same on every machine, unlike those of the standard library's distributions.
class Draw {
  public:
    explicit Draw(unsigned seed) : bits_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(bits_()) * 0x1p-32);
    }
    double degrees(double low, double high) { return between(low, high) * std::numbers::pi / 180; }

  private:
    std::mt19937 bits_;
};

// For each scene: the integer bits of its best split, which CMakeLists.txt reads, and how its start
// is drawn.
template <class SceneType>
using Numbers = typename SceneType::template Parameters<double>;

template <>
inline constexpr int integer_bits<scenes::FreeFall> = 6;
inline void draw(Numbers<scenes::FreeFall>& of, Draw& any) {
    of.height = any.between(15, 25);
    of.velocity_x = any.between(-4, 4);
    of.velocity_y = any.between(-5, 5);
}
template <>
inline constexpr int integer_bits<scenes::BouncingBall> = 5;
inline void draw(Numbers<scenes::BouncingBall>& of, Draw& any) {
    of.height = any.between(1, 3);
    of.velocity_x = any.between(-1, 1);
}
template <>
inline constexpr int integer_bits<scenes::SpringAndMass> = 6;
inline void draw(Numbers<scenes::SpringAndMass>& of, Draw& any) {
    const double angle = any.degrees(0, 360), length = of.rest_length + any.between(0.2, 0.6);
    of.x = length * std::cos(angle);
    of.y = length * std::sin(angle);
}
template <>
inline constexpr int integer_bits<scenes::Pendulum> = 5;
inline void draw(Numbers<scenes::Pendulum>& of, Draw& any) {
    const double angle = any.degrees(15, 60);
    of.x = of.length * std::sin(angle);
    of.y = -of.length * std::cos(angle);
}
template <>
inline constexpr int integer_bits<scenes::DoublePendulum> = 5;
inline void draw(Numbers<scenes::DoublePendulum>& of, Draw& any) {
    const double upper = any.degrees(20, 50), lower = any.degrees(30, 60);
    of.x = of.length * std::sin(upper);
    of.y = -of.length * std::cos(upper);
    of.lower_x = of.x + of.length * std::sin(lower);
    of.lower_y = of.y - of.length * std::cos(lower);
}
template <>
inline constexpr int integer_bits<scenes::RopeSwing> = 5;
inline void draw(Numbers<scenes::RopeSwing>& of, Draw& any) {
    of.x = any.between(0.9, 1.4);
    of.y = any.between(-0.3, 0);
}
template <>
inline constexpr int integer_bits<scenes::TwoBodyCollision> = 3;
inline void draw(Numbers<scenes::TwoBodyCollision>& of, Draw& any) {
    of.velocity = any.between(1.5, 2.5);
    of.other_velocity = any.between(-1.5, -0.5);
    of.other_y = any.between(0.05, 0.4);
}
template <>
inline constexpr int integer_bits<scenes::NewtonsCradle> = 5;
inline void draw(Numbers<scenes::NewtonsCradle>& of, Draw& any) {
    const double angle = any.degrees(20, 50);
    of.x = -of.length * std::sin(angle);
    of.y = -of.length * std::cos(angle);
}
template <>
inline constexpr int integer_bits<scenes::ChainOfRods> = 5;
inline void draw(Numbers<scenes::ChainOfRods>& of, Draw& any) {
    const double angle = any.degrees(20, 50);
    of.x = of.length * std::sin(angle);
    of.y = -of.length * std::cos(angle);
}
template <>
inline constexpr int integer_bits<scenes::Stack> = 5;
inline void draw(Numbers<scenes::Stack>& of, Draw& any) { of.gap = any.between(0.05, 0.2); }
template <>
inline constexpr int integer_bits<scenes::BoxOfParticles> = 3;
// Exact in every format: otherwise chaos would make the rounding of the start the whole error.
inline void draw(Numbers<scenes::BoxOfParticles>& of, Draw& any) {
    of.velocity = std::round(any.between(0.15, 0.35) * 256) / 256;
}
template <>
inline constexpr int integer_bits<scenes::ProjectileWithDrag> = 6;
inline void draw(Numbers<scenes::ProjectileWithDrag>& of, Draw& any) {
    of.velocity_x = any.between(8, 16);
    of.velocity_y = any.between(10, 18);
}
template <>
inline constexpr int integer_bits<scenes::Lever> = 5;
inline void draw(Numbers<scenes::Lever>& of, Draw& any) {
    const double angle = any.degrees(170, 230);
    of.end_x = of.pivot_x + of.length * std::cos(angle);
    of.end_y = of.pivot_y + of.length * std::sin(angle);
}
template <>
inline constexpr int integer_bits<scenes::PublishedLever> = 5;
// The end starts where it is, and the first step puts it onto its arm: the arm's length determines
// the start.
inline void draw(Numbers<scenes::PublishedLever>& of, Draw& any) {
    of.length = any.between(0.12, 0.2);
}

// The numbers of the scene in another scalar. All of them must be scalars.
template <class SceneType, class Scalar>
auto in_scalar(const Numbers<SceneType>& numbers) {
    using Rounded = typename SceneType::template Parameters<Scalar>;
    constexpr std::size_t count = sizeof(numbers) / sizeof(double);
    static_assert(sizeof(Rounded) == count * sizeof(Scalar));
    const auto exact = std::bit_cast<std::array<double, count>>(numbers);
    std::array<Scalar, count> rounded;
    for (std::size_t i = 0; i < count; ++i) {
        if constexpr (std::is_constructible_v<Scalar, double>)
            rounded[i] = static_cast<Scalar>(exact[i]);
        else
            rounded[i] = fixedpoint::from_float<Scalar>(exact[i]);
    }
    return std::bit_cast<Rounded>(rounded);
}

template <class SceneType>
reference::Times times_of() {
    reference::Times times;
    for (unsigned i = 0; i <= SceneType::duration * observations_per_second; ++i)
        times.push_back(static_cast<double>(i) / observations_per_second);
    return times;
}

template <class SceneType, class Scalar, class Method>
std::optional<Trajectory> run_from(const Numbers<SceneType>& numbers, int exponent) {
    WorldOf<SceneType, Scalar, Method> world;
    SceneType::build(world, in_scalar<SceneType, Scalar>(numbers));
    Trajectory trajectory = {state_of(world)};
    const unsigned between = (1u << exponent) / observations_per_second;
    for (unsigned step = 1; step <= SceneType::duration << exponent; ++step) {
        world.step(PowerOfTwoStep{exponent});
        if (world.error() != engine::Error::none) return std::nullopt;
        if (step % between != 0) continue;
        trajectory.push_back(state_of(world));
        if (!finite(trajectory.back())) return std::nullopt;
    }
    return trajectory;
}

// A start drawn from the seed, with its truth. If none is known for a draw, the next is drawn.
template <class SceneType, class Method>
std::pair<Numbers<SceneType>, Trajectory> start_of(unsigned seed, int exponent) {
    Draw any(seed);
    for (;;) {
        Numbers<SceneType> numbers;
        draw(numbers, any);
        if constexpr (requires { reference::trajectory(numbers, times_of<SceneType>()); }) {
            try {
                return {numbers, reference::trajectory(numbers, times_of<SceneType>())};
            } catch (const std::invalid_argument&) {
            }
        } else {
            return {numbers, run_from<SceneType, double, Method>(numbers, exponent).value()};
        }
    }
}

template <class SceneType, class Scalar, class Method>
std::optional<double> error_from(unsigned seed, int exponent) {
    const auto [numbers, truth] = start_of<SceneType, Method>(seed, exponent);
    const auto run = run_from<SceneType, Scalar, Method>(numbers, exponent);
    if (!run) return std::nullopt;
    const double error = largest_distance(*run, truth);
    return error <= extent(truth) ? std::optional(error) : std::nullopt;
}

template <class SceneType>
SceneStates states_of() {
    SceneStates of{SceneType::name, {}};
    const auto add_all = [&]<class Method>(Method) {
        const auto add = [&](const char* scalar, const char* arithmetic, auto error) {
            of.subjects.push_back({scalar, arithmetic, Method::name, error});
        };
#define ADD_FORMAT(name, I, F) add(#name, "nearest", error_from<SceneType, scalars::name, Method>);
        SCENE_FORMATS(ADD_FORMAT)
#undef ADD_FORMAT
        add("float", "ieee", error_from<SceneType, float, Method>);
    };
    add_all(scenes::Published());
    add_all(scenes::SemiImplicit());
    add_all(scenes::Verlet());
    if constexpr (has_springs<SceneType>()) add_all(scenes::Implicit());
    if constexpr (is_of_rods<SceneType>()) add_all(scenes::Direct());
    // As on the chip: the best split and compensated integration run with one method.
    using Best = BestMethod<SceneType>;
    using Compensated = scenes::Compensated<Best>;
    constexpr int I = integer_bits<SceneType>;
    const auto add = [&](std::string scalar, const char* arithmetic, auto error) {
        of.subjects.push_back({std::move(scalar), arithmetic, Best::name, error});
    };
    add(split_name<SceneType>(), "nearest",
        error_from<SceneType, fixedpoint::Fixed<I, 32 - I>, Best>);
    add("q8_8", "compensated", error_from<SceneType, scalars::q8_8, Compensated>);
    add("q16_16", "compensated", error_from<SceneType, scalars::q16_16, Compensated>);
    return of;
}

}  // namespace scene_bench
