// SPDX-License-Identifier: MIT
// The same work three times: with debug text and profiling on (TALKATIVE), off, and (BARE) without
// a line of either.
#include <engine.h>

#include <firmware/debug.hpp>
#include <firmware/hardware/atmega328p.hpp>
#include <firmware/profiling.hpp>
#include <fixedpoint/math.hpp>

namespace {

using namespace firmware;

struct Chosen : Configuration {
    static constexpr uint8_t transmit_capacity = 128;
#ifdef TALKATIVE
    static constexpr uint8_t profiled =
        set_of(Category::step, Category::render, Category::collision, Category::square_root,
               Category::operation);
    static constexpr uint8_t debugged = set_of(Topic::loop, Topic::physics);
#endif
};
using Board = Atmega328p<Chosen>;
using Text = Debug<Board, 21>;

#ifdef BARE
using Arithmetic = fixedpoint::Nearest;
using Integrator = engine::SemiImplicitEuler;
#else
using Arithmetic = ProfiledArithmetic<Board, fixedpoint::Nearest>;
using Integrator = ProfiledIntegrator<Board, engine::SemiImplicitEuler>;
#endif
using Number = fixedpoint::Fixed<16, 16, Arithmetic>;

struct Pendulum : engine::Uses {
    static constexpr unsigned particles = 1, anchored_rods = 1;
    static constexpr bool gravity = true;
    using Integrator = ::Integrator;
};
engine::World<Number, Pendulum> world;

}  // namespace

FIRMWARE_INTERRUPTS(Board)

extern "C" {
volatile int32_t operand = 0x28000;
volatile int32_t result;
}

template <Category category>
static void bracket() {
#ifndef BARE
    const Profiled<Board, category> profiled;
#endif
    asm volatile("nop");
}

int main() {
    using namespace engine::literals;
    Board::start();
    decltype(world)::Body bob;
    bob.position = {1_d, 0_d};
    bob.inverse_mass = 1_d;
    world.gravity = {0_d, -9.81_d};
    world.add_anchored_rod(world.add_particle(bob), {0_d, 0_d}, 1_d);
    for (;;) {
        const Number number = Number::from_raw(operand);
        const Number root = sqrt(number * number);
        result = root.raw();
        bracket<Category::step>();
        bracket<Category::render>();
        world.step(engine::BinaryStep<10>());
#ifndef BARE
        Text::print<Topic::loop>(FIRMWARE_TEXT("a loop"));
        Text::print<Topic::sensors>(FIRMWARE_TEXT("never said"));
        Text::print<Topic::physics>(FIRMWARE_TEXT("the root is "), root, 3);
        Text::print<Topic::servo>(FIRMWARE_TEXT("nor this "), int32_t{5});
#endif
        Board::idle();
    }
}
