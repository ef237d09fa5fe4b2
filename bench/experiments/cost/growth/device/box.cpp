// SPDX-License-Identifier: GPL-3.0-or-later
// The box on the chip, with for example -DPARTICLES=8 and -DBROAD_PHASE=BruteForce.
#include "bench/experiments/cost/growth/box.hpp"

#include <engine/hash.hpp>

growth::World<PARTICLES, engine::BROAD_PHASE> world;

extern "C" {
__attribute__((noinline)) void build() { growth::build<PARTICLES, engine::BROAD_PHASE>(world); }
__attribute__((noinline)) void step() { growth::step(world); }
__attribute__((noinline)) unsigned char error() {
    return static_cast<unsigned char>(world.error());
}
__attribute__((noinline)) unsigned long state_hash() { return engine::state_hash(world); }
}

int main() {
    build();
    while (error() == 0) step();
    return static_cast<int>(state_hash());
}
