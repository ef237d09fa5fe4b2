// SPDX-License-Identifier: GPL-3.0-or-later
// Functions on other chips: the ATmega328P, loaded like any chip, has the cycles of its own class;
// on a chip with addresses of 22 bits each call and each return takes a cycle more.
#include <gtest/gtest.h>

#include <fstream>

#include "bench/chip/simulator/device_function.hpp"
#include "bench/chip/simulator/other_chip.hpp"
#include "bench/experiments/operations/measure_other_chips.hpp"
#include "bench/lab/records/csv.hpp"
#include "this_build.hpp"

namespace operations {
namespace {

using simulator::OtherChip;
using simulator::Signature;
using simulator::SimulationError;

std::string program_of(const std::string& chip) {
    return build_folder() / "bench/experiments/operations" / ("other_chips_" + chip + ".elf");
}

const std::string atmega328p = program_of("atmega328p");
const Signature unary{.result = 4, .operands = {4}}, binary{.result = 4, .operands = {4, 4}},
    wide{.result = 8, .operands = {8, 8, 8}};  // the third operand is on the stack

TEST(OtherChip, CountsWhatTheSimulatedAtmega328pCounts) {
    const std::pair<const char*, Signature> functions[] = {
        {"twice", unary}, {"sum", binary}, {"last", wide}};
    for (const auto& [name, signature] : functions) {
        simulator::Chip chip{simulator::Elf(atmega328p)};
        chip.run_until_function("main");
        simulator::DeviceFunction known(chip, name, signature);
        OtherChip other("atmega328p", atmega328p);
        for (const std::uint64_t a : {0ull, 1ull, 0xffffull, 0x7fffffffull, 0x123456789abull}) {
            const std::vector<std::uint64_t> operands(signature.operands.size(), a);
            const simulator::Outcome expected = known.call(operands);
            const OtherChip::Outcome outcome = other.call(name, signature, operands);
            EXPECT_EQ(outcome.result, expected.result) << name;
            EXPECT_EQ(outcome.cycles, expected.cycles) << name;
        }
    }
}

TEST(OtherChip, PaysForItsOwnCallAndReturn) {
    const std::uint64_t operands[] = {3, 4};
    const auto cycles = [&](const char* name) {
        const OtherChip::Outcome outcome =
            OtherChip(name, program_of(name)).call("sum", binary, operands);
        EXPECT_EQ(outcome.result, 7u) << name;
        return outcome.cycles;
    };
    // add, adc, adc, adc, ret; data sheets, "Instruction Set Summary".
    EXPECT_EQ(cycles("atmega328p"), 4 + 4 + 4u);
    EXPECT_EQ(cycles("atmega2560"), 5 + 4 + 5u);
    EXPECT_EQ(cycles("attiny85"), 3 + 4 + 4u);
}

TEST(OtherChip, RefusesWhatItCannotRun) {
    EXPECT_THROW(OtherChip("atmega328q", atmega328p), SimulationError);
    EXPECT_THROW(OtherChip("attiny85", "no_such.elf"), SimulationError);
    OtherChip chip("atmega328p", atmega328p);
    EXPECT_THROW(chip.call("none", unary, {}), SimulationError);
    const std::uint64_t one[] = {1};
    EXPECT_THROW(chip.call("endless", unary, one), SimulationError);
    EXPECT_THROW(chip.call("careless", unary, one), SimulationError);
}

// A wrong sum is reported: the program claims to add and multiply.
TEST(OtherChips, ReportsResultsThatContradictTheDefinition) {
    const std::filesystem::path folder =
        build_folder() / "bench/experiments/operations/other_chips";
    std::filesystem::create_directories(folder / "atmega328p/q16_16");
    std::filesystem::create_directories(folder / "out");
    for (const char* subject : {"add_q16_16_default", "subtract_q16_16_default"})
        std::filesystem::copy_file(atmega328p,
                                   folder / "atmega328p/q16_16" / (subject + std::string(".elf")),
                                   std::filesystem::copy_options::overwrite_existing);
    std::ofstream(folder / "atmega328p/q16_16/programs.csv")
        << "subject,flash_bytes\nadd_q16_16_default,10\nsubtract_q16_16_default,10\n"
           "multiply_q16_16_default,\n";
    OtherChipOptions options;
    options.chips = {"atmega328p"};
    options.programs = folder;
    options.output = folder / "out";
    options.selection.formats = {"q16_16"};
    options.selection.operands = {"full"};
    options.samples = 100;
    EXPECT_GT(measure_other_chips(options), 90u);
    const records::Table table = records::Table::load(folder / "out/other_chips.csv");
    ASSERT_EQ(table.rows().size(), 2u);
    const auto cell = [&](std::size_t row, const char* name) {
        return table.rows()[row][table.column(name)];
    };
    EXPECT_EQ(cell(0, "operation"), "add");
    EXPECT_EQ(cell(0, "violations"), "0");
    EXPECT_EQ(cell(0, "cycles_max"), "12");
    EXPECT_EQ(cell(0, "flash_bytes"), "10");
    EXPECT_GT(std::stoi(cell(1, "violations")), 90);
    options.selection.operations = {"divide"};
    EXPECT_THROW(measure_other_chips(options), std::invalid_argument);
}

}  // namespace
}  // namespace operations
