// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as a program for the chip: -DSCENE=Pendulum -DSCALAR=scalars::q16_16 or float
// -DMETHOD=SemiImplicit. The linker keeps only what it is told to (--undefined), so that each time
// step is a program of its own whose size is that of its scene.
#include <engine/hash.hpp>
#include <scenes/all.hpp>

#include "scalars.hpp"

using Scene = scenes::SCENE;
using Scalar = SCALAR;
using World = engine::World<Scalar, Scene::Uses<scenes::METHOD>>;

World world;

extern "C" {

void build() { scenes::build<Scene>(world); }

// Steps of 2^-K seconds. All eight are compiled even if three are linked: with few callers the
// compiler inlines the whole step into each, and the larger scenes in Q32.32 do not fit the flash.
#define STEP(K) \
    void step_##K() { world.step(engine::BinaryStep<K>()); }
STEP(5)
STEP(6)
STEP(7)
STEP(8)
STEP(9)
STEP(10)
STEP(11)
STEP(12)

// For the measurement, and not counted: the address of a particle's position, which its velocity
// follows; the world's error; the hash of its state.
const Scalar* position_of(uint8_t i) {
    const World& looked_at = world;
    static_assert(sizeof looked_at.particles()[i].position == World::dimensions * sizeof(Scalar),
                  "");
    return &looked_at.particles()[i].position[0];
}
engine::Error world_error() { return world.error(); }
uint32_t state_hash() { return engine::state_hash(world); }
}

int main() {
    for (;;) {
    }
}
