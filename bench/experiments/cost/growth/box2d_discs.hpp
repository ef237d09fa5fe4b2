// SPDX-License-Identifier: GPL-3.0-or-later
// The discs of discs.hpp in Box2D (Erin Catto, MIT licence), for comparison with the engine.
#pragma once

#include <box2d/box2d.h>

#include <memory>

namespace growth {

// Without friction, spin, sleep and loss, and without continuous collision, which our scene does
// not use either.
std::unique_ptr<b2World> box2d_discs(unsigned n);

// One step of 2^-8 s, with the 8 and 3 iterations that Box2D's manual recommends.
void step(b2World& world);

}  // namespace growth
