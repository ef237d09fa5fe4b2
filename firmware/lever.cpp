// SPDX-License-Identifier: MIT
// The haptic lever as it is flashed. -DSCALAR=float -DRATE=9 builds the same lever in
// float, at half the rate; -DPUBLISHED is the 2016 device: its arithmetic, scene, method, clock,
// screen and damping.
#include <firmware/hardware/atmega328p.hpp>
#include <firmware/lever_program.hpp>
#include <fixedpoint/arithmetic/published.hpp>

namespace {

using namespace firmware;

struct Wiring : LeverWiring {
#ifdef PROFILED
    static constexpr uint8_t profiled =
        set_of(Category::step, Category::render, Category::collision, Category::square_root,
               Category::operation);
#endif
};
using Board = Atmega328p<Wiring>;

#ifdef PUBLISHED
using PublishedScalar = fixedpoint::Fixed<16, 16, ProfiledArithmetic<Board, fixedpoint::Published>>;
using AsPublished = PublishedLeverChoices<PublishedScalar>;
struct Lines : Screen {
    static constexpr Protocol protocol = Protocol::lines;
};
using Program = LeverProgram<Board, AsPublished, Lines>;
#else
#ifndef SCALAR
#define SCALAR fixedpoint::Fixed<16, 16, ProfiledArithmetic<Board, LeverArithmetic>>
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
