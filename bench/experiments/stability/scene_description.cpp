// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/scene_description.hpp"

#include <fmt/format.h>

#include <scenes/all.hpp>
#include <stdexcept>

namespace stability {
namespace {

template <class Scene>
constexpr int scene_dimensions() {
    return Scene::template Uses<scenes::SemiImplicit>::dimensions;
}

template <class Vector>
Point point(const Vector& v) {
    return {v[0], v[1]};
}

template <class Ends>
Link link_of(const Ends& ends, double length) {
    Link link{.a = ends.a, .length = length};
    if constexpr (requires { ends.anchor; }) {
        link.anchor = point(ends.anchor);
    } else {
        link.b = ends.b;
    }
    return link;
}

// Read from the scene built in double.
template <class Scene>
Description describe() {
    engine::World<double, typename Scene::template Uses<scenes::SemiImplicit>> world;
    using World = decltype(world);
    scenes::build<Scene>(world);
    Description made;
    if constexpr (World::Uses::gravity) made.gravity = point(world.gravity);
    if constexpr (World::bounces) {
        made.restitution = world.restitution();
        made.restitution_threshold = world.restitution_threshold();
    }
    if constexpr (World::Uses::custom_force) world.custom_force().apply(world);
    for (const auto& particle : world.particles()) {
        Body body{.position = point(particle.position),
                  .velocity = point(particle.velocity),
                  .inverse_mass = particle.inverse_mass};
        if constexpr (World::Uses::radii) body.radius = particle.radius;
        if constexpr (World::Uses::damping) body.damping = particle.damping;
        if constexpr (World::Uses::custom_force) body.force = point(particle.force);
        made.bodies.push_back(body);
    }
    const auto add_spring = [&](const auto& spring) {
        made.springs.push_back(
            {link_of(spring.ends, spring.rest_length), spring.stiffness, spring.damping});
    };
    world.springs().for_each(add_spring);
    world.anchored_springs().for_each(add_spring);
    const auto add_rod = [&](const auto& rod) {
        made.rods.push_back(link_of(rod.ends, rod.length));
    };
    world.anchored_rods().for_each(add_rod);
    world.rods().for_each(add_rod);
    const auto add_rope = [&](const auto& rope) {
        made.ropes.push_back({link_of(rope.ends, rope.length), rope.restitution});
    };
    world.anchored_ropes().for_each(add_rope);
    world.ropes().for_each(add_rope);
    world.drags().for_each([&](const auto& drag) {
        made.drags.push_back({drag.particle, drag.linear, drag.quadratic});
    });
    world.planes().for_each([&](const auto& plane) {
        made.planes.push_back({point(plane.normal), plane.offset, plane.restitution});
    });
    return made;
}

}  // namespace

std::vector<std::string> plane_scenes() {
    std::vector<std::string> names;
    scenes::for_each_scene([&](auto scene) {
        if (scene_dimensions<decltype(scene)>() == 2) names.push_back(scene.name);
    });
    return names;
}

Description describe_scene(const std::string& name, int exponent) {
    Description made;
    bool found = false;
    scenes::for_each_scene([&](auto scene) {
        using Scene = decltype(scene);
        if constexpr (scene_dimensions<Scene>() == 2) {
            if (name != Scene::name) return;
            made = describe<Scene>();
            made.dt = TimeStep::binary(exponent);
            made.steps = Scene::duration << exponent;
            found = true;
        }
    });
    if (!found)
        throw std::runtime_error(fmt::format("no scene '{}' in two dimensions; allowed are {}",
                                             name, fmt::join(plane_scenes(), ", ")));
    return made;
}

}  // namespace stability
