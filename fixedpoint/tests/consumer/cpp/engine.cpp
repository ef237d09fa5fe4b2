// SPDX-License-Identifier: MIT
// A pendulum of 1 m after each of four seconds.
#include <engine.h>

#include "show.hpp"

using namespace engine::literals;
using fixedpoint::Q16_16;

struct Pendulum : engine::Uses {
    static constexpr unsigned particles = 1, anchored_rods = 1;
    static constexpr bool gravity = true;
};

int main() {
    begin();
    using World = engine::World<Q16_16, Pendulum>;
    World world;
    world.gravity = {0_d, -9.81_d};
    World::Body body;
    body.position = {0.6_d, -0.8_d};
    body.inverse_mass = 1_d;
    const World::Handle bob = world.add_particle(body);
    world.add_anchored_rod(bob, {0_d, 0_d}, 1_d);
    for (int second = 0; second < 4; ++second) {
        for (int step = 0; step < 256; ++step) world.step(engine::BinaryStep<8>());
        show("x", world[bob].position[0]);
        show("y", world[bob].position[1]);
    }
    end();
}
