// SPDX-License-Identifier: GPL-3.0-or-later
// A lever as a program whose step can be taken apart: -DSCENE=PublishedLever
// -DARITHMETIC=published, nearest or float_ -DINTEGRATOR=ExplicitEuler -DSOLVER=WorstFirst<10>.
//
// What is watched is a function of its own. For the parts of a step that costs a call each; the
// published arithmetic, which was in a source file of its own, was called like this, too.
#include <fixedpoint/arithmetic/published.hpp>
#include <scenes/lever.hpp>
#include <scenes/published_lever.hpp>

#define WATCHED __attribute__((noinline))

extern "C" {
int32_t WATCHED published_multiply(int32_t a, int32_t b) {
    return fixedpoint::published::multiply<int32_t, 16>(a, b);
}
int32_t WATCHED published_divide(int32_t a, int32_t b) {
    return fixedpoint::published::divide<int32_t, 16>(a, b);
}
int32_t WATCHED published_sqrt(int32_t a) { return fixedpoint::published::sqrt<int32_t, 16>(a); }
}

struct CalledPublished : fixedpoint::Wrapping {
    template <class Raw, int F>
    static Raw multiply(Raw a, Raw b) {
        return published_multiply(a, b);
    }
    template <class Raw, int F>
    static Raw divide(Raw a, Raw b) {
        return published_divide(a, b);
    }
    template <class Raw, int F>
    static Raw sqrt(Raw a) {
        return published_sqrt(a);
    }
};

using published = fixedpoint::Fixed<16, 16, CalledPublished>;
using nearest = fixedpoint::Q16_16;
using float_ = float;

using Scene = scenes::SCENE;
using Scalar = ARITHMETIC;

struct Method {
    using Integrator = engine::INTEGRATOR;
    using Solver = engine::SOLVER;
};
using Base = engine::World<Scalar, Scene::Uses<Method>>;

struct Watched : Base {
    template <class TimeStep>
    void WATCHED collect_constraints(TimeStep dt) {
        Base::collect_constraints(dt);
    }
    void WATCHED solve_constraints() { Base::solve_constraints(); }
};

Watched world;

extern "C" {
void build() { scenes::build<Scene>(static_cast<Base&>(world)); }

#ifdef BINARY_STEP
void WATCHED step() { Watched::Integrator::step(world, engine::BinaryStep<BINARY_STEP>()); }
#else
void WATCHED step() {
    using namespace engine::literals;
    const Scalar dt = 0.005_d;
    Watched::Integrator::step(world, dt);
}
#endif

// For the measurement.
uint16_t particle_bytes() { return sizeof(Base::Particle); }
uint16_t world_bytes() { return sizeof(Base); }
}

int main() {
    build();
    for (;;) step();
}
