// SPDX-License-Identifier: MIT
/// \file
/// The forces of springs and drag, added to the force on each particle.
#pragma once

#include <engine/links.hpp>
#include <engine/observe.hpp>

namespace engine {

/// Adds the force of a spring to its ends: stiffness * extension + damping * rate of extension
/// along its length. Does nothing where the ends coincide, since there is no direction then.
template <class World, class Scalar, class Ends>
void apply(const Spring<Scalar, Ends>& spring, World& world) {
    observe<Scalar>(Quantity::spring_force);
    const auto a = spring.ends.a;
    const auto b = spring.ends.second();
    const auto difference = spring.ends.difference(world);
    const Scalar distance = length(difference);
    if (distance == Scalar()) return;
    const auto direction = divided(difference, distance);
    Scalar tension = spring.stiffness * (distance - spring.rest_length);
    if (!(spring.damping == Scalar())) {
        tension =
            engine::multiply_add(spring.damping, velocity_along(world, a, b, direction), tension);
    }
    const auto force = direction * tension;
    world.step_particles()[a].force -= force;
    if (is_particle(world, b)) world.step_particles()[b].force += force;
}

/// Adds -velocity (linear + quadratic |velocity|) to the force on the particle.
template <class World, class Scalar, class Index>
void apply(const Drag<Scalar, Index>& drag, World& world) {
    observe<Scalar>(Quantity::drag_force);
    auto& particle = world.step_particles()[drag.particle];
    Scalar factor = drag.linear;
    if (!(drag.quadratic == Scalar())) {
        factor = engine::multiply_add(drag.quadratic, length(particle.velocity), factor);
    }
    particle.force.add_scaled(particle.velocity, -factor);
}

}  // namespace engine
