// SPDX-License-Identifier: GPL-3.0-or-later
// Translated functions against the simulator, known answers, faults, and their fingerprints.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "bench/chip/instructions/compiled_function.hpp"
#include "bench/chip/instructions/fingerprint.hpp"
#include "bench/chip/instructions/tests/programs.hpp"
#include "bench/lab/operands/operand_class.hpp"
#include "bench/lab/subjects/device_subject.hpp"
#include "bench/chip/simulator/device_function.hpp"

namespace machine_code {
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

// Calls the translation and the simulator alike with `next` operands.
template <class Next>
void compare(const Elf& elf, const char* symbol, const std::vector<int>& sizes, int result_size,
             int calls, Next&& next) {
    const CompiledFunction function(elf, symbol, convention_of(sizes, result_size), quickly);
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
    const Convention convention =
        convention_of(reference::parse_symbol("normalise3_q16_16_pointers").subject);
    const CompiledFunction function(elf_, "normalise3_q16_16_pointers", convention, quickly);
    CompiledFunction::Session session(function);
    const std::vector<std::int64_t> operands = {0x12345678, -5, 1000000};
    std::vector<std::int64_t> results(3);
    std::uint32_t cycles;
    session.run(operands, results, {&cycles, 1});
    EXPECT_THAT(results, testing::ElementsAre(0x12345673, 0x12345678 + 1000000, 5));

    Chip chip(elf_);
    chip.run_until_function("main");
    operations::DeviceSubject device(chip, "normalise3_q16_16_pointers");
    const auto expected = device.call(operands);
    EXPECT_EQ(cycles, expected.cycles);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(results[i], expected.raws[i]);
}

// Subjects in assembly have a second name, under which the library calls them.
bool is_kernel(const Elf& elf, const std::string& subject) {
    for (const auto& [name, symbol] : elf.functions())
        if (name.starts_with("fixedpoint_") && symbol.address == elf.function(subject).address)
            return true;
    return false;
}

TEST_F(TranslateTest, KernelsOfTheDeviceProgram) {
    const Elf library(DEVICE_PROGRAM);
    Chip chip(library);
    chip.run_until_function("main");
    int subjects = 0;
    for (const std::string& symbol : operations::subjects_of(library)) {
        const reference::NamedSubject named = reference::parse_symbol(symbol);
        if (!is_kernel(library, symbol)) continue;
        ++subjects;
        const CompiledFunction function(library, symbol, convention_of(named.subject),
                                        {.options = "-O0"});
        CompiledFunction::Session session(function);
        operations::DeviceSubject device(chip, symbol);
        operands::Sampler sampler(named.subject.operation, named.subject.operand_format,
                                  operands::OperandClass::full, 1);
        std::vector<std::int64_t> operands(function.arity()), results(function.result_count());
        for (int i = 0; i < 300; ++i) {
            sampler.next(operands);
            std::uint32_t cycles;
            session.run(operands, results, {&cycles, 1});
            const auto expected = device.call(operands);
            ASSERT_EQ(cycles, expected.cycles) << symbol << " of " << operands[0];
            for (std::size_t k = 0; k < results.size(); ++k)
                ASSERT_EQ(results[k], expected.raws[k]) << symbol << " of " << operands[0];
        }
    }
    EXPECT_GT(subjects, 0);
}

struct Fault {
    const char *symbol, *message;

    friend void PrintTo(const Fault& fault, std::ostream* stream) { *stream << fault.symbol; }
};

class FaultTest : public TranslateTest, public testing::WithParamInterface<Fault> {};

TEST_P(FaultTest, IsReported) {
    try {
        const CompiledFunction function(elf_, GetParam().symbol, convention_of({1}, 1), quickly);
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

TEST(FingerprintTest, HoldsWhereverTheFunctionLies) {
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
}  // namespace machine_code
