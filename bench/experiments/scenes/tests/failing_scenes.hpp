// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that go wrong, for the tests of verdicts.
#pragma once

#include <scenes/methods.hpp>

namespace scenes {

// Two balls on a floor, which is one contact more than it states.
struct Overfull {
    static constexpr const char* name = "overfull";
    static constexpr unsigned duration = 1;

    template <class Method>
    struct Uses : UsesWith<Method> {
        static constexpr unsigned particles = 2, planes = 1, contacts = 1;
        static constexpr bool gravity = true;
    };
    template <class Scalar>
    struct Parameters {};

    template <class World>
    static void build(World& world, const Parameters<typename World::Scalar>&) {
        using namespace engine::literals;
        world.gravity = {0_d, -9.81_d};
        world.add_plane({0_d, 1_d}, 0_d, 0_d);
        typename World::Body ball;
        ball.inverse_mass = 1_d;
        world.add_particle(ball);
        world.add_particle(ball);
    }
};

// A spring that is too stiff for any step that it runs with: it leaves all bounds, even those of
// float.
struct Exploding {
    static constexpr const char* name = "exploding";
    static constexpr unsigned duration = 4;

    template <class Method>
    struct Uses : UsesWith<Method> {
        static constexpr unsigned particles = 1, anchored_springs = 1;
    };
    template <class Scalar>
    struct Parameters {};

    template <class World>
    static void build(World& world, const Parameters<typename World::Scalar>&) {
        using namespace engine::literals;
        typename World::Body mass;
        mass.position = {2_d, 0_d};
        mass.inverse_mass = 100_d;
        world.add_anchored_spring(world.add_particle(mass), {0_d, 0_d}, 20000_d, 0_d, 1_d);
    }
};

}  // namespace scenes
