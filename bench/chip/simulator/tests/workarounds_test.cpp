// SPDX-License-Identifier: GPL-3.0-or-later
// Each test compares one workaround of a libsimavr defect with the ATmega328P's data sheet, and
// fails without it.
#include <avr_extint.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "bench/chip/simulator/chip.hpp"
#include "programs.hpp"

namespace simulator {
namespace {

struct Mark {
    Cycle cycle;
    int value;
    bool operator==(const Mark&) const = default;
};

// Runs a test program and records its writes to GPIOR0.
class WorkaroundTest : public testing::Test {
  protected:
    void load(const char* name) {
        chip = std::make_unique<Chip>(test_program(name));
        chip->on_gpior0_write([this](Cycle cycle, std::uint8_t value) {
            marks.push_back({cycle, value});
        });
        chip->on_uart_byte([this](Cycle cycle, std::uint8_t byte) {
            sent.push_back({cycle, byte});
        });
    }
    void run(const char* program) {
        marks.clear();
        chip->reset();
        chip->run_until_function("main");
        chip->set_program_counter(chip->elf().function(program).address);
        chip->run_until_function("done", Chip::default_budget);
    }
    std::vector<int> values() const {
        std::vector<int> all;
        for (const Mark& mark : marks) all.push_back(mark.value);
        return all;
    }
    std::vector<Cycle> cycles_of(int value) const {
        std::vector<Cycle> all;
        for (const Mark& mark : marks)
            if (mark.value == value) all.push_back(mark.cycle);
        return all;
    }

    std::unique_ptr<Chip> chip;
    std::vector<Mark> marks, sent;
};

class InterruptTest : public WorkaroundTest {
  protected:
    void SetUp() override { load("interrupts"); }
};

// "The interrupt execution response for all the enabled AVR interrupts is four clock cycles
// minimum"; the vector's jmp takes 3, the handler 1 + 4.
TEST_F(InterruptTest, EntryTakesFourCycles) {
    run("interrupted_nops");
    ASSERT_EQ(values(), (std::vector<int>{1, 3, 2}));
    EXPECT_EQ(marks[2].cycle - marks[0].cycle, 1 + 100 + (4 + 3 + 1 + 4));
}

// "If an interrupt occurs when the MCU is in sleep mode, the interrupt execution response time is
// increased by four clock cycles."
TEST_F(InterruptTest, WakingTakesFourCyclesMore) {
    run("interrupted_nops");
    const Cycle awake = marks.at(1).cycle - marks.at(0).cycle;
    run("interrupted_sleep");
    ASSERT_EQ(values(), (std::vector<int>{1, 3, 2}));
    EXPECT_EQ(marks[1].cycle - marks[0].cycle, awake + 4);
}

// "When using the SEI instruction to enable interrupts, the instruction following SEI will be
// executed before any pending interrupts"; "When the AVR exits from an interrupt, it will always
// return to the main program and execute one more instruction before any pending interrupt is
// served."
TEST_F(InterruptTest, OneInstructionBeforeAPendingInterrupt) {
    run("pending_pair");
    EXPECT_EQ(values(), (std::vector<int>{1, 3, 2, 4, 1}));
}

// "The OCR1x Register ... is double buffered ... updated at BOTTOM": a match comes OCR1A + 1 cycles
// after BOTTOM, where the overflow comes.
TEST_F(InterruptTest, FastPwmTakesNewCompareValuesAtBottomToTheCycle) {
    run("fast_pwm");
    const int match = 3, overflow = 5;
    ASSERT_EQ(values(),
              (std::vector<int>{match, overflow, match, overflow, match, overflow, match}));
    const auto apart = [&](std::size_t i) { return marks[i + 1].cycle - marks[i].cycle; };
    EXPECT_EQ(apart(0), 1500u);
    EXPECT_EQ(apart(1), 500u);
    EXPECT_EQ(apart(2), 1500u);
    EXPECT_EQ(apart(3), 1000u);
    EXPECT_EQ(apart(4), 1000u);
    EXPECT_EQ(apart(5), 1000u);
}

TEST_F(InterruptTest, SleepDoesNotWaitForTheWallClock) {
    const auto begin = std::chrono::steady_clock::now();
    run("long_sleep");
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(cycles_of(3).size(), 5u);
    EXPECT_GT(chip->cycle(), 5u * Chip::frequency - 1000);
    EXPECT_LT(wall.count(), 1.0);
}

class PeripheralTest : public WorkaroundTest {
  protected:
    void SetUp() override { load("peripherals"); }
};

// 10 bits of 64 cycles: 40 us. The second byte waits in UDR0; UDR0 takes the third when the second
// goes to the shift register; TXC0 is set at the end of the last frame.
TEST_F(PeripheralTest, UartSendsAByteIn40MicrosecondsAndBuffersOne) {
    run("uart_8n1");
    ASSERT_EQ(sent.size(), 3u);
    EXPECT_EQ(sent[0].value, 1);
    EXPECT_EQ(sent[1].cycle - sent[0].cycle, 640u);
    EXPECT_EQ(sent[2].cycle - sent[1].cycle, 640u);
    ASSERT_EQ(values(), (std::vector<int>{1, 2, 3, 4}));
    EXPECT_LT(marks[1].cycle - marks[0].cycle, 40u);
    EXPECT_NEAR(marks[2].cycle - sent[0].cycle, 10, 10);
    EXPECT_NEAR(marks[3].cycle - sent[2].cycle, 10, 10);
}

// A frame starts with the store to UDR0, whose two cycles lie before the mark. UDRE0 is set again
// when the previous frame ends, TXC0 when the last one does.
TEST_F(PeripheralTest, UartFlagsComeWithTheEndOfAFrame) {
    std::vector<int> flags;
    chip->on_uart_byte([&](Cycle cycle, std::uint8_t byte) {
        sent.push_back({cycle, byte});
        flags.push_back(chip->read(0xc0) & 0x60);
    });
    run("uart_8n1");
    ASSERT_EQ(sent.size(), 3u);
    EXPECT_EQ(sent[0].cycle - marks[0].cycle, 640u - 2);
    const int udre0 = 0x20, txc0 = 0x40;
    EXPECT_EQ(flags, (std::vector<int>{udre0, udre0, udre0 | txc0}));
}

TEST_F(PeripheralTest, UartFrameFollowsItsFormat) {
    run("uart_7e2");
    ASSERT_EQ(sent.size(), 3u);
    EXPECT_EQ(sent[1].cycle - sent[0].cycle, (1 + 7 + 1 + 2) * 64u);
}

TEST_F(PeripheralTest, UartDoubleSpeedAndFlags) {
    run("uart_double_speed");
    ASSERT_EQ(sent.size(), 3u);
    EXPECT_EQ(sent[2].cycle - sent[1].cycle, 10 * 64u);
    const int udre0 = 1 << 5, u2x0 = 1 << 1;
    EXPECT_EQ(values().back(), udre0 | u2x0);
}

TEST_F(PeripheralTest, UartInterruptKeepsTheLineBusy) {
    run("uart_interrupt");
    ASSERT_EQ(sent.size(), 5u);
    for (int i = 1; i < 5; ++i) EXPECT_EQ(sent[i].cycle - sent[i - 1].cycle, 640u) << i;
    EXPECT_EQ(values(), std::vector<int>{5});
}

TEST_F(PeripheralTest, UartTransmitterIsOffAfterReset) {
    run("uart_off");
    EXPECT_TRUE(sent.empty());
}

TEST_F(PeripheralTest, UartReceivesAByteEvery40Microseconds) {
    chip->reset();
    chip->run_until_function("main");
    chip->set_program_counter(chip->elf().function("uart_echo").address);
    chip->run_until_cycle(chip->cycle() + 100);
    for (const int byte : {17, 18, 19}) chip->send_to_uart(byte);
    chip->run_until_function("done");
    ASSERT_EQ(values(), (std::vector<int>{17, 18, 19}));
    EXPECT_NEAR(marks[1].cycle - marks[0].cycle, 640, 5);  // the polling loop's period
    EXPECT_NEAR(marks[2].cycle - marks[1].cycle, 640, 10);
}

// A frame of 640 cycles for each byte, to the cycle. The receiver holds three, and reports a lost
// fourth. Then nops: a run of that many cycles takes exactly as many.
TEST_F(PeripheralTest, UartReceiverToTheCycle) {
    chip->reset();
    chip->run_until_function("main");
    chip->set_program_counter(chip->elf().function("uart_listen").address);
    chip->run_until_cycle(chip->cycle() + 100);
    const std::uint16_t ucsr0a = 0xc0, rxc0 = 0x80, dor0 = 0x08;
    const Cycle begin = chip->cycle();
    for (const int byte : {17, 18, 19, 20}) chip->send_to_uart(byte);
    chip->run_until([&] { return chip->read(ucsr0a) & rxc0; }, 10000);
    EXPECT_EQ(chip->cycle(), begin + 640);
    chip->run_until([&] { return chip->read(ucsr0a) & dor0; }, 10000);
    EXPECT_EQ(chip->cycle(), begin + 4 * 640);
    chip->run_until_cycle(begin + 2700);
    EXPECT_EQ(chip->cycle(), begin + 2700);
}

// OCR1A = 499 at first, 999 from the second period's BOTTOM on.
TEST_F(PeripheralTest, Timer1FastPwmTakesNewCompareValuesAtBottom) {
    run("timer1_fast_pwm");
    const std::vector<Cycle> compares = cycles_of(1), overflows = cycles_of(2);
    ASSERT_GE(compares.size(), 4u);
    ASSERT_GE(overflows.size(), 3u);
    const int latency = 3;  // cycles; an interrupt waits for the instruction that it meets
    std::vector<int> matches;
    for (std::size_t i = 0; i + 1 < compares.size(); ++i) {
        EXPECT_NEAR(overflows[i] - overflows[0], 2000 * i, latency);
        matches.push_back(compares[i + 1] - overflows[i]);
    }
    EXPECT_NEAR(matches.front(), 500, latency);
    EXPECT_NEAR(matches.back(), 1000, latency);
    EXPECT_TRUE(std::is_sorted(matches.begin(), matches.end(),
                               [&](int a, int b) { return a + 2 * latency < b; }));
}

TEST_F(PeripheralTest, TimerFlagsAreClearedOneByOne) {
    run("timer1_flags");
    const int tov1 = 1, ocf1a = 2, ocf1b = 4;
    EXPECT_EQ(values(), (std::vector<int>{tov1 | ocf1a | ocf1b, tov1 | ocf1b, ocf1b}));
}

TEST_F(PeripheralTest, SbiOfPinTogglesOneOutput) {
    run("toggle_one_pin");
    EXPECT_EQ(values(), std::vector<int>{0xb0});
}

TEST_F(PeripheralTest, PinsInAndOut) {
    std::vector<Mark> edges;
    chip->on_edge({'D', 7}, [&](Cycle cycle, bool level) { edges.push_back({cycle, level}); });
    chip->set_pin({'D', 2}, true);
    chip->run_until_function("main");
    chip->set_program_counter(chip->elf().function("pulse_pin").address);
    chip->run_until_function("done");
    ASSERT_EQ(edges.size(), 2u);
    EXPECT_EQ(edges[0].value, 1);
    EXPECT_EQ(edges[1].cycle - edges[0].cycle, 2u + 3);  // sbi and three nops
    EXPECT_EQ(values(), std::vector<int>{1 << 2});
    EXPECT_THROW(chip->set_pin({'A', 0}, true), SimulationError);
}

// "ADC = VIN * 1024 / VREF"; a first conversion takes 25 ADC cycles, a later one 13.
TEST_F(PeripheralTest, AdcConvertsWhatItSampled) {
    std::vector<int> channels;
    double volts[4] = {2.5, 0, 0, 0.55};
    chip->on_conversion([&](Cycle, int channel) {
        channels.push_back(channel);
        return volts[channel];
    });
    run("adc_results");
    const int at_3 = 0.55 / 5 * 1024;
    EXPECT_EQ(channels, (std::vector<int>{0, 3, 3}));
    EXPECT_EQ(values(), (std::vector<int>{1, 2, 512 & 0xff, 512 >> 8, 1, 2, at_3 & 0xff, at_3 >> 8,
                                          1, 2, 512 >> 2}));
    EXPECT_NEAR(marks[1].cycle - marks[0].cycle, 25 * 128, 10);
    EXPECT_NEAR(marks[5].cycle - marks[4].cycle, 13 * 128, 10);
}

TEST_F(PeripheralTest, AdcHoldsItsResultBetweenTheReadsOfItsBytes) {
    chip->on_conversion([](Cycle, int channel) { return channel == 0 ? 0.0 : 5.0; });
    run("adc_lock");
    EXPECT_EQ(values(), (std::vector<int>{1, 2, 0, 1, 2, 0}));
}

// simavr would poll the pins in each cycle.
TEST_F(PeripheralTest, LowInterruptPinsAreNotPolled) {
    for (const int pin : {EXTINT_IRQ_OUT_INT0, EXTINT_IRQ_OUT_INT1})
        EXPECT_EQ(avr_extint_is_strict_lvl_trig(chip->core(), pin), 0);
}

TEST_F(PeripheralTest, RunsEndAtTheirLimit) {
    EXPECT_THROW(chip->run_until_address(0x7000, 10000), SimulationError);
    const Cycle begin = chip->cycle();
    chip->run_until_cycle(begin + 1000);
    EXPECT_GE(chip->cycle(), begin + 1000);
    EXPECT_LE(chip->cycle(), begin + 1010);
}

TEST(ChipTest, ProgramsThatGoWrong) {
    const auto message_of = [](const char* program) -> std::string {
        Chip chip(test_program("faults"));
        chip.run_until_function("main");
        chip.set_program_counter(chip.elf().function(program).address);
        try {
            chip.run_until_cycle(1'000'000);
        } catch (const SimulationError& error) {
            return error.what();
        }
        return "no exception";
    };
    EXPECT_EQ(message_of("hang"), "no exception");
    EXPECT_EQ(message_of("illegal_opcode").find("illegal opcode 0x00ff at illegal_opcode+2"), 0u);
    EXPECT_EQ(message_of("jump_out").find("jump out of the program, at flash address 0x"), 0u);
    EXPECT_EQ(message_of("recurse").find("the stack ran into the data"), 0u);
    EXPECT_EQ(message_of("sleep_forever").find("sleep with interrupts off"), 0u);
}

}  // namespace
}  // namespace simulator
