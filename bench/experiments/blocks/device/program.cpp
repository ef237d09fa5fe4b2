// SPDX-License-Identifier: GPL-3.0-or-later
// One block, BLOCK, in one format, NUMBER: step() reads `input` and writes its results to `output`.
// Without BLOCK it is the program whose flash is subtracted.
#ifdef BLOCK
#include "../subjects.hpp"

using Number = blocks::NUMBER;
static blocks::BLOCK<Number> block;

extern "C" {
Number input[decltype(block)::inputs + 1], output[decltype(block)::outputs];
__attribute__((noinline, used)) void step() { block.step(input, output); }
}
#endif

int main() {
    for (;;) {
#ifdef BLOCK
        step();
#endif
    }
}
