// SPDX-License-Identifier: GPL-3.0-or-later
// What a terminal at the chip's serial port shows of shapes in the world, compared with
// inequalities.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "device_program.hpp"
#include "rasteriser.hpp"
#include "terminal_emulator.hpp"

namespace {

using simulator::Cycle;

#pragma pack(push, 1)
struct Shape {
    std::uint8_t colour, is_line;
    std::int32_t x0, y0, x1, y1;  // raw numbers of 16 fraction bits
};
#pragma pack(pop)

class RendererDeviceTest : public testing::Test {
  protected:
    explicit RendererDeviceTest(const std::string& name = "screen") : program(name) {
        program.chip.on_uart_byte([this](Cycle, std::uint8_t byte) {
            terminal.take(static_cast<char>(byte));
            ++sent;
        });
        program.chip.run_until_function("main");
    }

    void put(const std::vector<Shape>& list) {
        for (std::size_t i = 0; i < list.size(); ++i) program.set("shapes", list[i], i);
        program.set("shapes", Shape{}, list.size());
    }
    // Until the terminal has the next frame whose drawing has not started yet.
    void show() {
        program.chip.run_until_function("render_shapes");
        const auto before = program.get<std::uint8_t>("frames_shown");
        program.chip.run_until([&] { return program.get<std::uint8_t>("frames_shown") != before; });
        program.run_for(0.004);  // what the ring buffer still holds
    }

    // The view of the program: its corner at (-1/8, 1/16), 50 cells a unit.
    static std::int64_t cells(std::int64_t raw) {
        return static_cast<std::int64_t>(std::floor(static_cast<long double>(raw) * 50 / 65536));
    }
    static rasteriser::Picture picture_of(const std::vector<Shape>& list) {
        auto picture = rasteriser::blank(20, 20);
        for (const Shape& shape : list) {
            const char character = " .o#"[shape.colour];
            const std::int64_t x0 = cells(shape.x0 + 0x2000), y0 = cells(shape.y0 - 0x1000);
            if (shape.is_line) {
                draw(picture,
                     rasteriser::Line{x0, y0, cells(shape.x1 + 0x2000), cells(shape.y1 - 0x1000)},
                     character);
            } else {
                const auto radius = std::floor(shape.x1 * 50.0L / 65536 + 0.5L);
                draw(picture, rasteriser::Circle{x0, y0, static_cast<std::int64_t>(radius)},
                     character);
            }
        }
        return picture;
    }

    // Within half a unit, or one in three within 64 units.
    std::vector<Shape> random_shapes(bool far = true) {
        std::vector<Shape> list(random() % 6);
        for (Shape& shape : list) {
            const int reach = far && random() % 3 == 0 ? 1 << 22 : 1 << 15;
            std::uniform_int_distribution<std::int32_t> coordinate(-reach, reach);
            shape.colour = 1 + random() % 3;
            shape.is_line = random() % 2;
            shape.x0 = coordinate(random);
            shape.y0 = coordinate(random);
            shape.x1 = shape.is_line ? coordinate(random) : std::abs(coordinate(random));
            shape.y1 = coordinate(random);
        }
        return list;
    }

    std::mt19937 random{1};
    DeviceProgram program;
    TerminalEmulator terminal{20, 20};
    int sent = 0;
};

TEST_F(RendererDeviceTest, TheTerminalShowsTheWorld) {
    for (int frame = 0; frame < 150; ++frame) {
        const auto list = random_shapes();
        put(list);
        show();
        ASSERT_EQ(terminal.screen(), picture_of(list)) << frame;
    }
}

// As far away as numbers go: drawn at the end of the projection's reach, and without delay.
TEST_F(RendererDeviceTest, TheEndsOfTheWorldDoNoHarm) {
    constexpr std::int32_t most = INT32_MAX, least = INT32_MIN;
    put({{1, 1, least, least, most, most},
         {2, 1, most, 0x1000, least, 0x1000 + 10 * 65536 / 50},
         {3, 0, 0, 0, most, 0},
         {3, 0, most, least, most, 0},
         {3, 0, 0, 0, least, 0}});
    const auto begin = program.chip.cycle();
    show();
    EXPECT_LT(program.chip.cycle() - begin, 2u * 16'000'000 / 20);
    // The diagonal of the whole world is the diagonal of what is within reach, 163 units each way.
    const auto near = [](std::int32_t from, int units) { return from + units * 65536; };
    EXPECT_EQ(
        terminal.screen(),
        picture_of(
            {{1, 1, near(-0x2000, -163), near(0x1000, -163), near(-0x2000, 163), near(0x1000, 163)},
             {2, 1, near(-0x2000, 163), 0x1000, near(-0x2000, -163), 0x1000 + 10 * 65536 / 50},
             {3, 0, 0, 0, near(0, 163), 0}}));
}

TEST_F(RendererDeviceTest, OnlyChangesAreSentUntilAWholeFrameIsRequested) {
    const auto list = random_shapes();
    put(list);
    show();
    show();
    sent = 0;
    for (int frame = 0; frame < 5; ++frame) show();
    EXPECT_EQ(sent, 0);
    terminal = TerminalEmulator(20, 20);
    program.set<std::uint8_t>("refresh", 1);
    show();
    EXPECT_EQ(terminal.screen(), picture_of(list));
}

// The lever: a rod and its two ends, which sweeps 60 degrees in half a second. 20 frames a second
// take less than 5% of the CPU, including the interrupts that send them.
TEST_F(RendererDeviceTest, TakesLessThanATwentiethOfTheCpu) {
    const auto lever = [](double angle) {
        const std::int32_t x = 0x2800, y = 0x2c00;
        const auto end_x = static_cast<std::int32_t>(x - 65536 * 0.25 * std::cos(angle));
        const auto end_y = static_cast<std::int32_t>(y + 65536 * 0.25 * std::sin(angle));
        return std::vector<Shape>{
            {1, 1, x, y, end_x, end_y}, {2, 0, x, y, 0, 0}, {3, 0, end_x, end_y, 65536 / 30, 0}};
    };
    Cycle drawing = 0, sending = 0, longest_draw = 0, longest_send = 0;
    put(lever(0));
    show();
    sent = 0;
    constexpr int frames = 20;
    const std::uint32_t draw_address = program.chip.elf().function("render_shapes").address;
    const std::uint32_t send_address = program.chip.elf().function("render_transmit").address;
    int frame = 0;
    while (frame < frames) {
        program.chip.run_until([&] {
            return program.chip.program_counter() == draw_address ||
                   program.chip.program_counter() == send_address;
        });
        const bool draw = program.chip.program_counter() == draw_address;
        if (draw) {
            put(lever((frame < 10 ? frame : 20 - frame) * 0.105));
            ++frame;
        }
        const Cycle cycles = program.cycles_of_function();
        (draw ? drawing : sending) += cycles;
        (draw ? longest_draw : longest_send) = std::max(draw ? longest_draw : longest_send, cycles);
    }
    constexpr int transmit_interrupt = 63;  // cycles a byte: BoardTest
    const double share = double(drawing + sending + sent * transmit_interrupt) / 16e6;
    EXPECT_LT(share, 0.05);
    std::printf(
        "renderer: %.2f%% of the CPU; a frame draws %llu cycles (at most %llu), sends %llu "
        "(at most %llu a call), %d bytes\n",
        100 * share, static_cast<unsigned long long>(drawing / frames),
        static_cast<unsigned long long>(longest_draw),
        static_cast<unsigned long long>(sending / frames),
        static_cast<unsigned long long>(longest_send), sent / frames);
}

TEST_F(RendererDeviceTest, NeedsLittleMemory) {
    put(random_shapes());
    show();
    const int stack = simulator::Chip::ram_end - 1 - program.chip.lowest_stack_pointer();
    EXPECT_LE(stack, 160);
    EXPECT_LE(program.chip.elf().ram_bytes(), 350u + 8 * sizeof(Shape));
    std::printf("screen: flash %u, RAM %u (%u of them shapes), stack %d bytes\n",
                program.chip.elf().flash_bytes(), program.chip.elf().ram_bytes(),
                static_cast<unsigned>(8 * sizeof(Shape)), stack);
}

// Only the projection depends on the arithmetic of the world: if its products are exact, as these
// are, the picture is the same.
class ScalarTest : public RendererDeviceTest, public testing::WithParamInterface<const char*> {
  protected:
    ScalarTest() : RendererDeviceTest(GetParam()) {}
};
INSTANTIATE_TEST_SUITE_P(, ScalarTest, testing::Values("screen_published", "screen_float"));

TEST_P(ScalarTest, TheTerminalShowsTheWorld) {
    for (int frame = 0; frame < 50; ++frame) {
        const auto list = random_shapes(false);
        put(list);
        show();
        ASSERT_EQ(terminal.screen(), picture_of(list)) << frame;
    }
}

class PublishedProtocolTest : public RendererDeviceTest {
  protected:
    PublishedProtocolTest() : RendererDeviceTest("screen_lines") {
        terminal = TerminalEmulator(20, 21);
    }
};

TEST_F(PublishedProtocolTest, EachFrameIsSentWhole) {
    for (int frame = 0; frame < 20; ++frame) {
        const auto list = random_shapes();
        put(list);
        show();
        ASSERT_EQ(terminal.top(20), picture_of(list)) << frame;
    }
}

}  // namespace
