// SPDX-License-Identifier: MIT
// The haptic lever as it is flashed. -DSCALAR=float -DRATE=9 is the same in another arithmetic,
// half as often; -DPUBLISHED is the device of the report: its arithmetic, scene, method, clock,
// screen and damping.
#include <firmware/hardware/atmega328p.hpp>
#include <firmware/lever_program.hpp>
#include <fixedpoint/arithmetic/published.hpp>

namespace {

using namespace firmware;

struct Wiring : Configuration {
    static constexpr uint16_t servo_shortest = 1000;
    static constexpr uint16_t servo_longest = 1667;
    static constexpr uint16_t servo_at_start = 1000;
#ifdef PROFILED
    static constexpr uint8_t profiled =
        set_of(Category::step, Category::render, Category::collision, Category::square_root,
               Category::operation);
#else
    static constexpr uint8_t profiled = set_of(Category::step, Category::render);
#endif
};
using Board = Atmega328p<Wiring>;

// Products, quotients and roots show on their pins where these are profiled.
#ifdef PROFILED
template <class Arithmetic>
using Watched = ProfiledArithmetic<Board, Arithmetic>;
#else
template <class Arithmetic>
using Watched = Arithmetic;
#endif

#ifdef PUBLISHED
using PublishedScalar = fixedpoint::Fixed<16, 16, Watched<fixedpoint::Published>>;
struct AsPublished : LeverChoices<PublishedScalar> {
    using Scene = scenes::PublishedLever;
    using Method = scenes::Published;
    using Steps = PublishedSteps;
    static constexpr PublishedScalar time_step(uint32_t ticks) {
        return seconds<PublishedScalar>(ticks);
    }
    static constexpr PublishedScalar servo_delay() { return PublishedScalar(); }
    static constexpr uint8_t damping_exponent = 0;
};
struct Lines : Screen {
    static constexpr Protocol protocol = Protocol::lines;
};
using Program = LeverProgram<Board, AsPublished, Lines>;
#else
#ifndef SCALAR
#define SCALAR fixedpoint::Fixed<16, 16, Watched<LeverArithmetic>>
#define RATE 10
#endif
using Program = LeverProgram<Board, LeverChoices<SCALAR, RATE>>;
#endif

}  // namespace

FIRMWARE_INTERRUPTS(Board)

int main() {
    Program::start();
    for (;;) Program::pass();
}
