// SPDX-License-Identifier: MIT
// A pendulum of 1 m in real time: prints the position of its bob twenty times a second.
#include <engine.h>

using namespace engine;
using namespace engine::literals;
using Number = SaturatingFixed<16, 16>;

struct Pendulum : Uses {
    static constexpr unsigned particles = 1, anchored_rods = 1;
    static constexpr bool gravity = true;
};

using PendulumWorld = World<Number, Pendulum>;
PendulumWorld world;
PendulumWorld::Handle bob;

void setup() {
    Serial.begin(115200);
    world.gravity = {0_d, -9.81_d};
    PendulumWorld::Body body;
    body.position = {0.6_d, -0.8_d};
    body.inverse_mass = 1_d;
    bob = world.add_particle(body);
    world.add_anchored_rod(bob, {0_d, 0_d}, 1_d);
}

// Metres, to the millimetre.
void write(Number metres) {
    char text[fixedpoint::text_capacity<Number>()];
    Serial.write(text, fixedpoint::print(metres, 3, text, sizeof text));
}

void loop() {
    static unsigned long steps = 0, frames = 0;
    // 2^-8 s a step, as many as the clock says.
    for (; steps * 1000 / 256 < millis(); ++steps) world.step(BinaryStep<8>());
    if (frames * 50 > millis()) return;
    ++frames;
    write(world[bob].position[0]);
    Serial.print(' ');
    write(world[bob].position[1]);
    Serial.println();
}
