// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the library's own tests on the simulated chip and reports their counts.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "bench/chip/simulator/chip.hpp"
#include "bench/device/tests/program_folder.hpp"

namespace {

constexpr std::uint32_t usable_flash = 30720;  // without the bootloader
constexpr simulator::Cycle budget = 10ull * simulator::Chip::frequency;

std::vector<std::string> programs() {
    std::istringstream list(PROGRAMS);
    std::vector<std::string> names;
    for (std::string name; std::getline(list, name, ',');) names.push_back(name);
    return names;
}

class LibraryOnDevice : public testing::TestWithParam<std::string> {};

unsigned counter(const simulator::Chip& chip, const char* name) {
    const std::uint16_t address = chip.elf().object(name).address;
    return chip.read(address) | chip.read(address + 1) << 8;
}

std::string text(const simulator::Chip& chip, const char* name) {
    const simulator::Symbol& symbol = chip.elf().object(name);
    std::string characters;
    for (std::uint32_t i = 0; i < symbol.size && chip.read(symbol.address + i) != 0; ++i) {
        characters += static_cast<char>(chip.read(symbol.address + i));
    }
    return characters;
}

TEST_P(LibraryOnDevice, EveryCheckHolds) {
    simulator::Chip chip(simulator::Elf(program_folder() + "/" + GetParam() + ".elf"));
    EXPECT_LE(chip.elf().flash_bytes(), usable_flash);
    ASSERT_NO_THROW(chip.run_until_function("finished", budget));
    EXPECT_GT(counter(chip, "checks"), 0u);
    EXPECT_EQ(counter(chip, "failures"), 0u)
        << "of " << counter(chip, "checks") << "; the first one in "
        << text(chip, "first_failing_test") << ".cpp:" << counter(chip, "first_failing_line")
        << ", row " << counter(chip, "first_failing_row");
}

INSTANTIATE_TEST_SUITE_P(Programs, LibraryOnDevice, testing::ValuesIn(programs()),
                         [](const auto& program) { return program.param; });

}  // namespace
