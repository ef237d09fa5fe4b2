// SPDX-License-Identifier: MIT
// Four marbles in a tray, the first on a spring to the middle of the tray. Prints all positions ten
// times a second, and stops with a message if the world reports an error.
#include <engine.h>

using namespace engine;
using namespace engine::literals;
using Number = SaturatingFixed<16, 16>;

struct Tray : Uses {
    static constexpr unsigned particles = 4, anchored_springs = 1, planes = 4;
    static constexpr unsigned contacts = 8;  // at once: a marble may touch two walls, or others
    static constexpr bool radii = true, collisions = true, damping = true;
};

using TrayWorld = World<Number, Tray>;
TrayWorld world;

void setup() {
    Serial.begin(115200);
    world.set_restitution(0.9_d);
    world.add_plane({1_d, 0_d}, -0.2_d, 0.9_d);  // x >= -0.2 m, and so on
    world.add_plane({-1_d, 0_d}, -0.2_d, 0.9_d);
    world.add_plane({0_d, 1_d}, -0.2_d, 0.9_d);
    world.add_plane({0_d, -1_d}, -0.2_d, 0.9_d);

    TrayWorld::Body marble;
    marble.radius = 0.02_d;
    marble.inverse_mass = 50_d;  // 20 g
    marble.damping = 0.9995_d;
    marble.position = {0.15_d, 0.1_d};
    const auto sprung = world.add_particle(marble);
    world.add_anchored_spring(sprung, {0_d, 0_d}, 2_d, 0_d, 0_d);
    marble.velocity = {0.3_d, -0.2_d};
    for (unsigned char i = 0; i < 3; ++i) {
        marble.position -= TrayWorld::Vector(0.08_d, 0.06_d);
        world.add_particle(marble);
    }
}

void loop() {
    static unsigned long steps = 0;
    for (unsigned char i = 0; i < 25; ++i, ++steps) world.step(BinaryStep<8>());  // 2^-8 s each
    while (millis() < steps * 1000 / 256) {
    }
    for (const auto& marble : world.particles()) {
        for (unsigned char axis = 0; axis < 2; ++axis) {
            char text[fixedpoint::text_capacity<Number>()];
            Serial.write(text, fixedpoint::print(marble.position[axis], 3, text, sizeof text));
            Serial.print(' ');
        }
    }
    Serial.println();
    if (world.error() != Error::none) {
        Serial.println(describe(world.error()));
        for (;;) {
        }
    }
}
