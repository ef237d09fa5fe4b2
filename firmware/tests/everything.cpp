// SPDX-License-Identifier: MIT
// Everything that the firmware offers, on the chip or on the host, so that the compiler's warnings
// about its headers appear here. Compiled, and not run.
#include <engine.h>

#include <firmware/debug.hpp>
#include <firmware/lever_program.hpp>
#ifdef __AVR__
#include <firmware.h>
#else
#include <firmware/hardware/host.hpp>
#include <firmware/hardware/ring_buffer.hpp>
#endif

using namespace firmware;

namespace {

struct Wiring : LeverWiring {
    static constexpr uint8_t profiled = set_of(Category::step, Category::render);
    static constexpr uint8_t debugged = set_of(Topic::loop, Topic::physics);
};
#ifdef __AVR__
using Board = Atmega328p<Wiring>;
#else
using Board = Host<Wiring>;
#endif

struct Lines : Screen {
    static constexpr Protocol protocol = Protocol::lines;
};
template <class Scalar>
struct Corrected : LeverChoices<Scalar> {
    static constexpr bool frame_correction = true;
};

template <class Program>
void run() {
    Program::start();
    Program::pass();
}

template <class Scalar>
Scalar every_curve(int sum) {
    using namespace calibration;
    const CubicPiece pieces[] = {{0, 1, 2, 3, 4, 5}};
    return Held<Line>{0, 1, {2, 3}}.grams<Scalar>(sum) +
           RationalQuadratic{1, 2, 3}.grams<Scalar>(sum) + Quadratic{1, 2, 3}.grams<Scalar>(sum) +
           Hyperbola{1, 2, 3}.grams<Scalar, 1>(sum) + ConductancePower{1, 2, 3}.grams<Scalar>(sum) +
           MonotoneCubic{pieces, 1}.grams<Scalar>(sum) + grams<Scalar, 4>(sum);
}

}  // namespace

#ifdef __AVR__
FIRMWARE_INTERRUPTS(Board)
#endif

int main() {
    run<LeverProgram<Board, LeverChoices<LeverScalar>>>();
    run<LeverProgram<Board, PublishedLeverChoices<fixedpoint::Q16_16>, Lines>>();
    run<LeverProgram<Board, Corrected<float>, Lines>>();
    Debug<Board, 20>::template print<Topic::loop>(FIRMWARE_TEXT("grams "),
                                                  every_curve<fixedpoint::Q16_16>(3), 1);
    Debug<Board, 20>::template print<Topic::physics>(
        FIRMWARE_TEXT("grams "), fixedpoint::from_float<fixedpoint::Q16_16>(every_curve<float>(3)),
        1);
    Grid<16, 8, 4, true> grid;
    grid.clear();
    grid.line(0, 0, 3, 3, 1, 1, 2);
    grid.circle(3, 3, 2, 1, 3);
#ifndef __AVR__
    RingBuffer<8> ring;
    ring.push(1);
    Board::world().inputs[ring.pop() % inputs] = 0;
#endif
}
