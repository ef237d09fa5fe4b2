// SPDX-License-Identifier: MIT
// All scenes: AllScenes is the list of their types, for_each_scene(f) calls f(Scene()) with each.
#pragma once

#include <scenes/bouncing_ball.hpp>
#include <scenes/box_of_particles.hpp>
#include <scenes/chain_of_rods.hpp>
#include <scenes/double_pendulum.hpp>
#include <scenes/free_fall.hpp>
#include <scenes/lever.hpp>
#include <scenes/newtons_cradle.hpp>
#include <scenes/pendulum.hpp>
#include <scenes/projectile_with_drag.hpp>
#include <scenes/published_lever.hpp>
#include <scenes/rope_swing.hpp>
#include <scenes/spring_and_mass.hpp>
#include <scenes/stack.hpp>
#include <scenes/two_body_collision.hpp>

namespace scenes {

template <class... Scene>
struct List {};
using AllScenes = List<FreeFall, BouncingBall, SpringAndMass, Pendulum, DoublePendulum, RopeSwing,
                       TwoBodyCollision, NewtonsCradle, ChainOfRods, Stack, BoxOfParticles,
                       ProjectileWithDrag, Lever, PublishedLever>;

template <class Function, class... Scene>
void for_each(List<Scene...>, Function function) {
    const bool called[] = {(function(Scene()), true)...};
    (void)called;
}
template <class Function>
void for_each_scene(Function function) {
    for_each(AllScenes(), function);
}

}  // namespace scenes
