// SPDX-License-Identifier: GPL-3.0-or-later
// Debug text and profiling: what they do if they are on, and that they cost nothing if they are
// off.
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "device_program.hpp"
#include "terminal_emulator.hpp"

namespace {

using simulator::Cycle;

bool holds(const DeviceProgram& program, std::string_view text) {
    const auto& flash = program.chip.elf().flash();
    return std::search(flash.begin(), flash.end(), text.begin(), text.end()) != flash.end();
}

// To the last byte of flash, and in RAM.
TEST(Categories, OffIsTheSameProgramAsWithout) {
    const DeviceProgram silent("silent"), bare("bare"), talkative("talkative");
    EXPECT_EQ(silent.chip.elf().sha256(), bare.chip.elf().sha256());
    EXPECT_EQ(silent.chip.elf().ram_bytes(), bare.chip.elf().ram_bytes());
    EXPECT_GT(talkative.chip.elf().flash_bytes(), bare.chip.elf().flash_bytes() + 500);
    std::printf("debug text and profiling: flash %u, RAM %u bytes\n",
                talkative.chip.elf().flash_bytes() - bare.chip.elf().flash_bytes(),
                talkative.chip.elf().ram_bytes() - bare.chip.elf().ram_bytes());
}

TEST(Categories, OnlyTheTopicsThatAreOnHaveTheirStrings) {
    const DeviceProgram talkative("talkative"), silent("silent");
    EXPECT_TRUE(holds(talkative, "the root is "));
    EXPECT_FALSE(holds(talkative, "never said"));
    EXPECT_FALSE(holds(talkative, "nor this"));
    EXPECT_FALSE(holds(silent, "the root is "));
    // In flash only.
    EXPECT_EQ(talkative.chip.elf().ram_bytes(), silent.chip.elf().ram_bytes() + 1);
}

TEST(Categories, TextOfEachTopicOnItsLine) {
    DeviceProgram program("talkative");
    TerminalEmulator terminal(20, 24);
    program.chip.on_uart_byte(
        [&](Cycle, std::uint8_t byte) { terminal.take(static_cast<char>(byte)); });
    program.run_for(0.05);
    const auto& lines = terminal.screen();
    EXPECT_EQ(lines[20], "a loop              ");
    EXPECT_EQ(lines[21], std::string(20, '?'));
    EXPECT_EQ(lines[22], std::string(20, '?'));
    EXPECT_EQ(lines[23], "the root is 2.500   ");
}

// High for two cycles longer than the code inside takes.
TEST(Categories, EachHasItsPin) {
    DeviceProgram program("talkative");
    std::vector<Cycle> lengths[8];
    Cycle since[8] = {};
    for (int pin = 2; pin <= 6; ++pin)
        program.chip.on_edge({'D', pin}, [&, pin](Cycle cycle, bool level) {
            if (level)
                since[pin] = cycle;
            else
                lengths[pin].push_back(cycle - since[pin]);
        });
    program.run_for(0.05);
    const auto shortest = [&](int pin) { return std::ranges::min(lengths[pin]); };
    const auto rounds = static_cast<double>(lengths[2].size());
    EXPECT_GT(rounds, 20);
    for (int pin = 2; pin <= 3; ++pin) EXPECT_EQ(shortest(pin), 2u + 1) << pin;
    // A round takes the root of a product, and the step of a pendulum, whose rod is found, by
    // products, and solved.
    EXPECT_NEAR(static_cast<double>(lengths[4].size()), 2 * rounds, 2);
    EXPECT_NEAR(static_cast<double>(lengths[5].size()), rounds, 2);
    EXPECT_GT(static_cast<double>(lengths[6].size()), 6 * rounds);
    // A single rod is solved where it is found: nothing is left to solve.
    for (std::size_t i = 0; i + 1 < lengths[4].size(); i += 2) {
        EXPECT_GT(lengths[4][i], 200u);
        EXPECT_EQ(lengths[4][i + 1], 2u);
    }
    // Solving the rod's row and computing a product each take at least 80 to 100 cycles.
    EXPECT_GT(shortest(5), 60u);
    EXPECT_GT(shortest(6), 60u);
    EXPECT_LT(shortest(6), 200u);
}

}  // namespace
