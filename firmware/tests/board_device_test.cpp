// SPDX-License-Identifier: GPL-3.0-or-later
// The hardware layer in the simulated chip: the state of its pins, its line and its variables.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "device_program.hpp"

namespace {

using simulator::Chip;
using simulator::Cycle;

enum Task : std::uint8_t { rest, flood, echo, busy, watch_clock, alternate_pulses, deaf };

constexpr double cycles_per_microsecond = Chip::frequency / 1e6;

class BoardTest : public testing::Test {
  protected:
    BoardTest() : program("board"), chip(program.chip) {
        chip.on_uart_byte([this](Cycle cycle, std::uint8_t byte) {
            sent.push_back({cycle, byte});
        });
        chip.run_until_function("main");
    }
    void do_task(Task task) { program.set<std::uint8_t>("task", task); }

    struct Byte {
        Cycle cycle;
        std::uint8_t value;
    };
    DeviceProgram program;
    Chip& chip;
    std::vector<Byte> sent;
};

// --- Analogue inputs ---

TEST_F(BoardTest, EachInputHasItsReadings) {
    std::vector<int> channels;
    std::vector<Cycle> starts;
    chip.on_conversion([&](Cycle cycle, int channel) {
        channels.push_back(channel);
        starts.push_back(cycle);
        return (100 + 300 * channel + 0.5) * 5 / 1024;
    });
    program.run_for(0.01);
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(program.get<std::uint16_t>("sums", i), 4 * (100 + 300 * i)) << i;
    for (std::size_t i = 0; i < channels.size(); ++i) ASSERT_EQ(channels[i], i % 3) << i;
    // 13 cycles of the converter's clock of 125 kHz, and the wait for the next one.
    for (std::size_t i = 2; i < starts.size(); ++i)
        EXPECT_NEAR((starts[i] - starts[i - 1]) / cycles_per_microsecond, 108, 6);
}

// A sum contains the newest four readings: a step of the voltage passes through it in four.
TEST_F(BoardTest, TheNewestReadingsAreSummed) {
    int conversions = 0;
    chip.on_conversion([&](Cycle, int channel) {
        ++conversions;
        return channel == 1 && conversions > 300 ? 5.0 : 0.0;
    });
    std::vector<int> seen = {0};
    chip.run_until([&] {
        const int sum = program.get<std::uint16_t>("sums", 1);
        if (sum != seen.back()) seen.push_back(sum);
        return conversions > 330;
    });
    // Between its two bytes a variable is neither the old number nor the new one.
    std::erase_if(seen, [](int sum) { return sum % 1023 != 0; });
    EXPECT_EQ(seen, (std::vector<int>{0, 1023, 2 * 1023, 3 * 1023, 4 * 1023}));
}

// Readings jump between two values whose bytes differ: no sum mixes the bytes of two readings.
TEST_F(BoardTest, NoSumIsTorn) {
    std::srand(1);
    chip.on_conversion([](Cycle, int) { return (std::rand() % 2 ? 0x2ff + 0.5 : 0.5) * 5 / 1024; });
    do_task(busy);
    for (int i = 0; i < 3000; ++i) {
        program.run_for(0.0002);
        chip.run_until_function("bracketed_ticks");
        for (int input = 0; input < 3; ++input)
            ASSERT_EQ(program.get<std::uint16_t>("sums", input) % 0x2ff, 0);
    }
}

// --- Servo ---

struct Edges {
    std::vector<double> widths, periods;  // microseconds
};

class ServoTest : public BoardTest {
  protected:
    ServoTest() {
        chip.on_edge({'D', 7}, [this](Cycle cycle, bool level) {
            if (level) {
                if (rise) edges.periods.push_back((cycle - rise) / cycles_per_microsecond);
                rise = cycle;
            } else {
                edges.widths.push_back((cycle - rise) / cycles_per_microsecond);
            }
        });
    }
    Edges measure(double seconds) {
        edges = {};
        program.run_for(seconds);
        return edges;
    }
    Cycle rise = 0;
    Edges edges;
};

// With the line saturated both ways and the converter running: less than half a microsecond off,
// since the interrupt waits for the tick.
TEST_F(ServoTest, ThePulseIsAsLongAsCommanded) {
    do_task(busy);
    double worst_width = 0, worst_period = 0;
    for (const int half_microseconds : {1200, 2001, 3000, 3333, 4799, 4800}) {
        program.set<std::uint16_t>("pulse", half_microseconds);
        measure(0.045);
        for (int i = 0; i < 10000; ++i) chip.send_to_uart(static_cast<std::uint8_t>(i));
        const auto [widths, periods] = measure(0.4);
        ASSERT_GE(widths.size(), 19u);
        for (const double width : widths)
            worst_width = std::max(worst_width, std::abs(width - half_microseconds / 2.0));
        for (const double period : periods)
            worst_period = std::max(worst_period, std::abs(period - 20000));
    }
    EXPECT_LE(worst_width, 0.5);
    EXPECT_LE(worst_period, 0.5);
    std::printf("servo: width off by at most %.3f us, period by %.3f us\n", worst_width,
                worst_period);
}

TEST_F(ServoTest, ThePulseIsHeldToTheTravel) {
    for (const auto& [command, microseconds] :
         {std::pair(0, 600.0), {1199, 600.0}, {4801, 2400.0}, {65535, 2400.0}}) {
        program.set<std::uint16_t>("pulse", command);
        measure(0.045);
        for (const double width : measure(0.1).widths) EXPECT_NEAR(width, microseconds, 0.5);
    }
}

// Timer1 returns to the same phase after 1024 periods. Here one of the compare values is 0.
TEST_F(ServoTest, NoPulseIsMissedInAThousand) {
    program.set<std::uint16_t>("pulse", 3016);
    measure(0.045);
    const auto [widths, periods] = measure(1030 * 0.02);
    EXPECT_GE(widths.size(), 1029u);
    for (const double period : periods) ASSERT_NEAR(period, 20000, 0.5);
    for (const double width : widths) ASSERT_NEAR(width, 1508, 0.5);
}

// A command in the middle of a pulse applies to the next one, and no pulse is made of mixed bytes.
TEST_F(ServoTest, CommandsDoNotCutPulses) {
    do_task(alternate_pulses);
    measure(0.045);
    const auto [widths, periods] = measure(8);
    int shorter = 0;
    for (const double width : widths) {
        ASSERT_LE(std::min(std::abs(width - 1000), std::abs(width - 2000)), 0.5) << width;
        shorter += width < 1500;
    }
    EXPECT_GT(shorter, 50);
    EXPECT_LT(shorter, 350);
    for (const double period : periods) ASSERT_NEAR(period, 20000, 0.5);
}

// --- Serial port ---

TEST_F(BoardTest, NothingIsSentWithoutRequest) {
    program.run_for(0.01);
    EXPECT_TRUE(sent.empty());
}

TEST_F(BoardTest, TheTransmitterIsNeverIdle) {
    do_task(flood);
    program.run_for(0.2);
    ASSERT_GT(sent.size(), 4900u);
    for (std::size_t i = 1; i < sent.size(); ++i) {
        ASSERT_EQ(sent[i].value, static_cast<std::uint8_t>(i));
        // 10 bits of 4 us; the first frames start before the ring has filled.
        const auto cycles = sent[i].cycle - sent[i - 1].cycle;
        ASSERT_TRUE(cycles == 640 || i <= 100) << i << ": " << cycles;
    }
}

TEST_F(BoardTest, WhatIsReceivedComesBack) {
    do_task(echo);
    const int count = 5000;
    for (int i = 0; i < count; ++i) chip.send_to_uart(static_cast<std::uint8_t>(i * 37));
    program.run_for(count * 40e-6 + 0.002);
    ASSERT_EQ(sent.size(), static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) ASSERT_EQ(sent[i].value, static_cast<std::uint8_t>(i * 37));
    EXPECT_EQ(program.get<std::uint8_t>("lost"), 0);
}

// Nobody reads: 16 bytes are kept, the rest is counted, and nothing is mixed up afterwards.
TEST_F(BoardTest, LostBytesAreCounted) {
    program.run_for(0.001);
    for (int i = 0; i < 116; ++i) chip.send_to_uart(static_cast<std::uint8_t>(i));
    program.run_for(0.006);
    EXPECT_EQ(program.get<std::uint8_t>("lost"), 100);
    do_task(echo);
    program.run_for(0.002);
    ASSERT_EQ(sent.size(), 16u);
    for (int i = 0; i < 16; ++i) EXPECT_EQ(sent[i].value, i);
    for (int i = 0; i < 300; ++i) chip.send_to_uart(1);
    do_task(rest);
    program.run_for(0.02);
    EXPECT_EQ(program.get<std::uint8_t>("lost"), 255);
}

// With interrupts off for 0.5 ms the receiver keeps two bytes and a third in its shift register; it
// reports the loss, but not its size.
TEST_F(BoardTest, AnOverrunLosesTheLaterBytes) {
    program.run_for(0.001);
    do_task(deaf);
    for (int i = 0; i < 8; ++i) chip.send_to_uart(static_cast<std::uint8_t>(100 + i));
    program.run_for(0.003);
    ASSERT_EQ(sent.size(), 3u);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(sent[i].value, 100 + i);
    EXPECT_EQ(program.get<std::uint8_t>("lost"), 1);
}

// --- Clock ---

// Each reading was taken between two marks. All readings are right if a single cycle at which the
// count was zero explains them all.
class ClockTest : public BoardTest {
  protected:
    ClockTest() {
        chip.on_gpior0_write([this](Cycle cycle, std::uint8_t mark) {
            if (mark == 2) {
                end = cycle;
            } else {
                if (end) judge();  // by now the program has stored what it read
                begin = cycle;
            }
        });
    }
    void judge() {
        const auto ticks = program.get<std::uint32_t>("time");
        wraps += ticks < last_ticks;
        last_ticks = ticks;
        const auto cycles = static_cast<std::int64_t>(wraps << 32 | ticks) * 8;
        earliest_zero = std::max(earliest_zero, static_cast<std::int64_t>(begin) - cycles - 8);
        latest_zero = std::min(latest_zero, static_cast<std::int64_t>(end) - cycles);
        ++readings;
    }
    void forget() {
        earliest_zero = INT64_MIN;
        latest_zero = INT64_MAX;
        wraps = last_ticks = readings = 0;
        end = 0;
    }
    Cycle begin = 0, end = 0;
    std::int64_t earliest_zero = INT64_MIN, latest_zero = INT64_MAX;
    std::uint64_t wraps = 0, last_ticks = 0, readings = 0;
};

// Through 120 overflows of the 16-bit count, some of which occur during a reading.
TEST_F(ClockTest, CountsHalfMicrosecondsFromTheStart) {
    do_task(watch_clock);
    program.run_for(4.0);
    EXPECT_LE(earliest_zero, latest_zero);
    EXPECT_GE(earliest_zero, 0);
    EXPECT_LE(latest_zero, 1000);  // cycles: start-up code
    EXPECT_GT(readings, 10000u);
}

// Advanced to 64 overflows before its wrap, 35 minutes after the start.
TEST_F(ClockTest, RunsThroughItsWrap) {
    program.run_for(0.001);
    program.set<std::uint16_t>("overflows_", 0xffff - 64);
    program.run_for(0.001);
    chip.run_until_function("bracketed_ticks");
    forget();
    program.set<std::uint8_t>("went_backwards", 0);
    do_task(watch_clock);
    program.run_for(200 * 0.032768);
    EXPECT_EQ(wraps, 1u);
    EXPECT_LE(earliest_zero, latest_zero);
    EXPECT_GT(readings, 10000u);
    EXPECT_EQ(program.get<std::uint8_t>("went_backwards"), 0);
}

// --- What it takes ---

// From the interrupt's entry to the end of its `reti`.
struct Handler {
    const char* name;
    const char* vector;
    Task task;
    unsigned max_cycles;
};
class HandlerTest : public BoardTest, public testing::WithParamInterface<Handler> {};
INSTANTIATE_TEST_SUITE_P(, HandlerTest,
                         testing::Values(Handler{"Conversion", "__vector_21", rest, 100},
                                         Handler{"Transmit", "__vector_19", flood, 90},
                                         Handler{"Receive", "__vector_18", echo, 90},
                                         Handler{"Overflow", "__vector_13", rest, 60},
                                         Handler{"Edge", "__vector_11", rest, 300}),
                         [](const auto& info) { return info.param.name; });

TEST_P(HandlerTest, TakesFewCycles) {
    do_task(GetParam().task);
    unsigned longest = 0, shortest = ~0u;
    for (int i = 0; i < 40; ++i) {
        if (GetParam().task == echo) chip.send_to_uart(1);
        chip.run_until_function(GetParam().vector);
        const unsigned cycles = DeviceProgram::interrupt_entry + program.cycles_of_function();
        longest = std::max(longest, cycles);
        shortest = std::min(shortest, cycles);
    }
    EXPECT_LE(longest, GetParam().max_cycles);
    std::printf("%s: %u to %u cycles\n", GetParam().name, shortest, longest);
}

TEST_F(BoardTest, NeedsLittleMemory) {
    do_task(busy);
    for (int i = 0; i < 500; ++i) chip.send_to_uart(0);
    program.run_for(0.1);
    const int stack = Chip::ram_end - 1 - chip.lowest_stack_pointer();
    EXPECT_LE(stack, 80);
    std::printf("board: flash %u, RAM %u, stack %d bytes\n", chip.elf().flash_bytes(),
                chip.elf().ram_bytes(), stack);
}

}  // namespace
