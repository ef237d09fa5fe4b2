// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/cost/growth/box2d_discs.hpp"

#include "bench/experiments/cost/growth/discs.hpp"

namespace growth {

std::unique_ptr<b2World> box2d_discs(unsigned n) {
    auto world = std::make_unique<b2World>(b2Vec2(0, 0));
    world->SetContinuousPhysics(false);
    world->SetAllowSleeping(false);
    b2FixtureDef fixture;
    fixture.density = 1;
    fixture.friction = 0;
    fixture.restitution = 1;
    fixture.restitutionThreshold = 0;
    const float wall = half_edge(n);
    // Clockwise, since the edges of a loop stop only bodies that come from their right.
    const b2Vec2 corners[] = {{-wall, -wall}, {-wall, wall}, {wall, wall}, {wall, -wall}};
    b2ChainShape walls;
    walls.CreateLoop(corners, 4);
    fixture.shape = &walls;
    const b2BodyDef still;
    world->CreateBody(&still)->CreateFixture(&fixture);
    b2CircleShape circle;
    circle.m_radius = disc_radius;
    fixture.shape = &circle;
    for (unsigned i = 0; i < n; ++i) {
        const Disc start = disc(i, n);
        b2BodyDef body;
        body.type = b2_dynamicBody;
        body.fixedRotation = true;
        body.position.Set(start.position[0], start.position[1]);
        body.linearVelocity.Set(start.velocity[0], start.velocity[1]);
        world->CreateBody(&body)->CreateFixture(&fixture);
    }
    return world;
}

void step(b2World& world) { world.Step(1.0f / (1 << exponent_of_step), 8, 3); }

}  // namespace growth
