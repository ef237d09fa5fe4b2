// SPDX-License-Identifier: GPL-3.0-or-later
// Translated functions compared with the simulator, known answers, faults, and fingerprints.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "bench/chip/instructions/compiled_function.hpp"
#include "bench/chip/instructions/fingerprint.hpp"
#include "bench/chip/instructions/tests/programs.hpp"
#include "bench/chip/simulator/device_function.hpp"

namespace instructions {
namespace {

using simulator::Chip;
using simulator::DeviceFunction;
using simulator::Elf;
using testing::HasSubstr;

const Compilation quickly = {.options = "-O1"};

class TranslateTest : public testing::Test {
  protected:
    Elf elf_{test_program("functions")};
};

// Calls the translation and the simulator with the same `next` operands.
template <class Next>
void compare(const Elf& elf, const char* symbol, const std::vector<int>& sizes, int result_size,
             int calls, Next&& next) {
    const CompiledFunction function(elf, symbol, interface_of({result_size, sizes}), quickly);
    CompiledFunction::Session session(function);
    Chip chip(elf);
    chip.run_until_function("main");
    DeviceFunction device(chip, symbol, {result_size, sizes});
    const std::uint64_t mask = (std::uint64_t(1) << 8 * result_size) - 1;
    for (int i = 0; i < calls; ++i) {
        std::vector<std::int64_t> operands;
        for (std::size_t k = 0; k < sizes.size(); ++k) operands.push_back(next());
        std::int64_t result;
        std::uint32_t cycles;
        session.run(operands, {&result, 1}, {&cycles, 1});
        const std::vector<std::uint64_t> bits(operands.begin(), operands.end());
        const simulator::Outcome outcome = device.call(bits);
        ASSERT_EQ(std::uint64_t(result) & mask, outcome.result) << symbol << " of " << operands[0];
        ASSERT_EQ(cycles, outcome.cycles) << symbol << " of " << operands[0];
    }
}

TEST_F(TranslateTest, EveryBranchUnderAllFlags) {
    int flags = 0;
    compare(elf_, "branches", {1}, 2, 256, [&] { return flags++; });
}

TEST_F(TranslateTest, SkipsOverOneWordAndTwo) {
    int pair = 0;
    compare(elf_, "skips", {1, 1}, 1, 65536, [&] { return pair++ / 2 * 37; });
    std::mt19937 random(1);
    compare(elf_, "skips", {1, 1}, 1, 10000, [&] { return std::int64_t(random() & 0x88); });
}

TEST_F(TranslateTest, CallsFramesAndLoops) {
    std::mt19937 random(1);
    compare(elf_, "calls", {4, 1}, 4, 20000, [&] { return std::int64_t(random()); });
}

TEST_F(TranslateTest, VectorsThroughEveryPointer) {
    const simulator::Signature signature = {0, {2, 2}};
    const CompiledFunction function(elf_, "normalise3_q16_16_pointers",
                                    interface_of(signature, {1, 3, 4, 3, 4}), quickly);
    CompiledFunction::Session session(function);
    const std::vector<std::int64_t> operands = {0x12345678, -5, 1000000};
    std::vector<std::int64_t> results(3);
    std::uint32_t cycles;
    session.run(operands, results, {&cycles, 1});
    EXPECT_THAT(results, testing::ElementsAre(0x12345673, 0x12345678 + 1000000, 5));

    Chip chip(elf_);
    chip.run_until_function("main");
    const std::uint16_t from = chip.allocate(12), to = chip.allocate(12);
    for (std::size_t i = 0; i < 3; ++i)
        chip.write(std::uint16_t(from + 4 * i),
                   {reinterpret_cast<const std::uint8_t*>(&operands[i]), 4});
    DeviceFunction device(chip, "normalise3_q16_16_pointers", signature);
    EXPECT_EQ(device(from, to).cycles, cycles);
    for (std::size_t i = 0; i < 3; ++i) {
        std::int32_t result;
        chip.read(std::uint16_t(to + 4 * i), {reinterpret_cast<std::uint8_t*>(&result), 4});
        EXPECT_EQ(result, results[i]);
    }
}

TEST_F(TranslateTest, WorksOnVariables) {
    const CompiledFunction function(elf_, "counts", interface_of_variables(elf_), quickly);
    CompiledFunction::Session session(function);
    Chip chip(elf_);
    chip.run_until_function("main");
    const auto variables = session.memory().subspan(Chip::ram_begin, elf_.ram_bytes());
    chip.read(Chip::ram_begin, variables);
    DeviceFunction device(chip, "counts", {.result = 0, .operands = {}});
    const auto counter = elf_.object("counter").address;
    for (int i = 1; i <= 600; ++i) {
        std::uint32_t cycles;
        session.run({}, {}, {&cycles, 1});
        ASSERT_EQ(device().cycles, cycles) << i;
        ASSERT_EQ(session.memory()[counter] | session.memory()[counter + 1] << 8, i);
        std::vector<std::uint8_t> expected(variables.size());
        chip.read(Chip::ram_begin, expected);
        ASSERT_TRUE(std::equal(variables.begin(), variables.end(), expected.begin())) << i;
    }
}

TEST_F(TranslateTest, WritesNothingBesideTheVariables) {
    const CompiledFunction function(elf_, "writes_away", interface_of_variables(elf_), quickly);
    CompiledFunction::Session session(function);
    std::uint32_t cycles;
    EXPECT_THROW(session.run({}, {}, {&cycles, 1}), Misbehaviour);
}

struct Fault {
    const char *symbol, *message;

    friend void PrintTo(const Fault& fault, std::ostream* stream) { *stream << fault.symbol; }
};

class FaultTest : public TranslateTest, public testing::WithParamInterface<Fault> {};

TEST_P(FaultTest, IsReported) {
    try {
        const CompiledFunction function(elf_, GetParam().symbol, interface_of({1, {1}}), quickly);
        CompiledFunction::Session session(function);
        const std::int64_t operand = 3;
        std::int64_t result;
        std::uint32_t cycles;
        session.run({&operand, 1}, {&result, 1}, {&cycles, 1});
        ADD_FAILURE() << "nothing was reported";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr(GetParam().symbol));
        EXPECT_THAT(error.what(), HasSubstr(GetParam().message));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Functions, FaultTest,
    testing::Values(Fault{"leaves_r1", "r1 but 0xff, for the operands 3"},
                    Fault{"changes_r17", "changes call-saved register 0x11"},
                    Fault{"pushes_only", "stack pointer unbalanced"},
                    Fault{"returns_early", "returns to another address"},
                    Fault{"writes_away",
                          "writes outside of its results and its stack, data address 0x123"},
                    Fault{"hangs", "does not return"}, Fault{"recurses", "calls nest too deep"},
                    Fault{"jumps_indirectly", "opcode 0x9409, ijmp"},
                    Fault{"reads_a_port", "in r24, 0x03: only SPL, SPH and SREG"},
                    Fault{"is_no_code", "opcode 0x00ff, .word 0x00ff: no such instruction"}));

TEST(FingerprintTest, DoesNotDependOnTheAddressOfTheFunction) {
    const Elf elf(test_program("functions")), moved(test_program("moved")),
        another(test_program("another"));
    ASSERT_NE(elf.function("lookup").address, moved.function("lookup").address);
    for (const char* symbol : {"lookup", "skips", "calls", "multiply_q4_4_default"}) {
        EXPECT_EQ(fingerprint(elf, symbol), fingerprint(moved, symbol)) << symbol;
        EXPECT_EQ(fingerprint(elf, symbol) == fingerprint(another, symbol),
                  symbol != std::string("lookup"))
            << symbol;
    }
}

TEST(FingerprintTest, NeedsRelocations) {
    EXPECT_THROW(fingerprint(Elf(test_program("stripped")), "lookup"), TranslationError);
}

}  // namespace
}  // namespace instructions
