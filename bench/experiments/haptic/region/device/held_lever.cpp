// SPDX-License-Identifier: GPL-3.0-or-later
// The lever with the choices -DCHOICES, on the board of lever.cpp, with selective damping according
// to -DDAMPED: the host's stable region is checked against it.
#include <firmware/hardware/atmega328p.hpp>
#include <firmware/lever_program.hpp>
#include <fixedpoint/arithmetic/published.hpp>

namespace {

using namespace firmware;

using Board = Atmega328p<LeverWiring>;
using PublishedScalar = fixedpoint::Fixed<16, 16, fixedpoint::Published>;

struct Choices : CHOICES {
    static constexpr bool selective_damping = DAMPED;
};
using Program = LeverProgram<Board, Choices>;

}  // namespace

FIRMWARE_INTERRUPTS(Board)

int main() {
    Program::start();
    for (;;) Program::pass();
}
