// SPDX-License-Identifier: MIT
// Draws the shapes that the test sets and shows them, at 20 frames a second.
#include <firmware/frame_clock.hpp>
#include <firmware/hardware/atmega328p.hpp>
#include <firmware/projection.hpp>
#include <firmware/renderer.hpp>
#include <fixedpoint/arithmetic/published.hpp>

#ifndef PROTOCOL
#define PROTOCOL changes
#endif
#ifndef SCALAR
#define SCALAR Fixed<16, 16>
#endif

namespace {

using namespace firmware;
using namespace fixedpoint;

template <class Scalar>
struct FromRaw {
    static constexpr Scalar number(int32_t raw) { return Scalar::from_raw(raw); }
};
template <>
struct FromRaw<float> {
    static constexpr float number(int32_t raw) { return raw / 65536.0f; }
};

using Board = Atmega328p<Configuration>;
struct Chosen : Screen {
    static constexpr Protocol protocol = Protocol::PROTOCOL;
};
struct View {
    using Scalar = SCALAR;
    static constexpr uint16_t cells_per_unit = 50;
    static constexpr Scalar left() { return FromRaw<Scalar>::number(-0x2000); }
    static constexpr Scalar bottom() { return FromRaw<Scalar>::number(0x1000); }
    static constexpr Scalar slice() { return FromRaw<Scalar>::number(0); }
};
using Picture = Projection<GridOf<Chosen>, View>;

Renderer<Board, Chosen> renderer;

}  // namespace

FIRMWARE_INTERRUPTS(Board)

extern "C" {
struct Shape {
    uint8_t colour;  // 0 ends the list
    uint8_t is_line;
    int32_t x0, y0, x1, y1;  // in 2^-16; of a circle the centre and, as x1, the radius
};
Shape shapes[8];
volatile uint8_t frames_shown;
volatile uint8_t refresh;

// Separate functions, so that their cycles can be counted.
__attribute__((noinline)) void render_shapes() {
    auto& grid = renderer.begin();
    for (const Shape& shape : shapes) {
        if (shape.colour == 0) break;
        const auto number = FromRaw<View::Scalar>::number;
        if (shape.is_line)
            Picture::line(grid, number(shape.x0), number(shape.y0), number(shape.x1),
                          number(shape.y1), shape.colour);
        else
            Picture::circle(grid, number(shape.x0), number(shape.y0), number(shape.x1),
                            shape.colour);
    }
    renderer.finish();
}
__attribute__((noinline)) void render_transmit() { renderer.transmit(); }
}

int main() {
    Board::start();
    Frames<> frames(Board::ticks());
    for (;;) {
        const bool was_idle = renderer.idle();
        if (was_idle && frames.due(Board::ticks())) {
            if (refresh) renderer.refresh();
            refresh = 0;
            render_shapes();
        }
        render_transmit();
        if (!was_idle && renderer.idle()) frames_shown = frames_shown + 1;
        Board::idle();
    }
}
