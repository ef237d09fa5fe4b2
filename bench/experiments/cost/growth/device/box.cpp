// SPDX-License-Identifier: GPL-3.0-or-later
// The box on the chip, of -DPARTICLES=8 and -DBROAD_PHASE=BruteForce.
#include "bench/experiments/cost/growth/box.hpp"

growth::World<PARTICLES, engine::BROAD_PHASE> world;

extern "C" {
__attribute__((noinline)) void build() { growth::build<PARTICLES, engine::BROAD_PHASE>(world); }
__attribute__((noinline)) void step() { world.step(engine::BinaryStep<8>()); }
__attribute__((noinline)) unsigned char error() {
    return static_cast<unsigned char>(world.error());
}
}

int main() {
    build();
    while (error() == 0) step();
}
