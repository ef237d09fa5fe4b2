// SPDX-License-Identifier: GPL-3.0-or-later
// The effect of each row of the instruction set, compared with simavr on random registers, flags
// and memory; and that a row with a wrong effect is detected.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sim_avr.h>
#include <sim_core.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <random>

#include "bench/chip/instructions/compiled_function.hpp"
#include "bench/chip/instructions/tests/programs.hpp"
#include "bench/chip/simulator/chip.hpp"

namespace instructions {
namespace {

using simulator::Chip;

constexpr int words_of_a_row = 5, trials = 1000;
constexpr std::uint32_t here = 0x4000;  // the address of the instruction; below it are random bytes

// Registers, flags, stack pointer and memory; the generated code declares the same.
struct State {
    std::uint8_t r[32];
    std::uint8_t flags;
    std::uint8_t condition;  // of a branch or skip
    std::uint16_t sp;
    std::uint8_t memory[Chip::ram_end];
};

constexpr const char* prelude = R"(
#include "bench/chip/instructions/semantics.hpp"
using namespace instructions::semantics;
struct State { Byte r[32]; Byte flags, condition; Word sp; Byte memory[0x900]; };
#define STEP(name, ...)                                                                         \
    extern "C" void name(State& state, const Byte* flash) {                                     \
        auto& [r0, r1, r2, r3, r4, r5, r6, r7, r8, r9, r10, r11, r12, r13, r14, r15, r16, r17,  \
               r18, r19, r20, r21, r22, r23, r24, r25, r26, r27, r28, r29, r30, r31] = state.r; \
        Memory<0x100, 0x100, 0x100, 0x800, 0x900> m{state.memory, state.sp};                    \
        Status f;                                                                               \
        m.out<m.sreg>(state.flags, f);                                                          \
        __VA_ARGS__;                                                                            \
        state.flags = m.in<m.sreg>(f);                                                          \
        state.sp = m.sp;                                                                        \
    }
)";

bool is_condition(const InstructionRow& row) {
    return row.flow == Flow::branch || row.flow == Flow::skip;
}

Instruction decode_words(std::uint16_t opcode, std::uint16_t second) {
    const std::vector<std::uint8_t> bytes = {std::uint8_t(opcode), std::uint8_t(opcode >> 8),
                                             std::uint8_t(second), std::uint8_t(second >> 8)};
    return decode(bytes, 0);
}

// Random words of each row that has a statement, or only of one mnemonic.
std::vector<Instruction> instructions(std::mt19937& random, std::string_view mnemonic = {}) {
    std::vector<Instruction> chosen;
    for (const InstructionRow& row : instruction_set()) {
        const bool straight = row.flow == Flow::next || is_condition(row);
        if (!straight || (!mnemonic.empty() && row.mnemonic != mnemonic)) continue;
        for (int i = 0; i < words_of_a_row;) {
            std::uint16_t opcode = 0;
            for (const char letter : row.pattern)
                opcode = std::uint16_t(opcode << 1 | (letter == '0'   ? 0
                                                      : letter == '1' ? 1
                                                                      : random() & 1));
            if (row.mnemonic == "in" || row.mnemonic == "out")  // SPL, SPH, SREG
                opcode = std::uint16_t((opcode & 0xf9f0) | 0x060d) + std::uint16_t(random() % 3);
            const Instruction instruction =
                decode_words(opcode, std::uint16_t(0x200 + random() % 0x500));
            // A pointer that moves while it is loaded or stored is undefined.
            const bool moves = row.operands.find('+') != row.operands.npos ||
                               row.operands.find('-') != row.operands.npos;
            const bool pointer = instruction.d >= 26 || instruction.r >= 26;
            if (instruction.row != &row || (moves && pointer && row.mnemonic.size() == 2)) continue;
            chosen.push_back(instruction);
            ++i;
        }
    }
    return chosen;
}

std::string source_of(const std::vector<Instruction>& chosen) {
    std::string source = prelude;
    for (std::size_t i = 0; i < chosen.size(); ++i)
        source += fmt::format("STEP(step{}, {}{})\n", i,
                              is_condition(*chosen[i].row) ? "state.condition = " : "",
                              chosen[i].statement());
    return source;
}

class SemanticsTest : public testing::Test {
  protected:
    SemanticsTest() : chip_(simulator::Elf(test_program("functions"))), core_(chip_.core()) {
        for (std::uint32_t i = 0; i < here; ++i) core_->flash[i] = std::uint8_t(random_());
        for (std::uint8_t& byte : state_.memory) byte = std::uint8_t(random_());
    }

    State random_state() {
        // Half of the bytes are values at which flags change.
        constexpr std::uint8_t edges[] = {0x00, 0x01, 0x0f, 0x10, 0x7f, 0x80, 0x81, 0xff};
        State state = state_;
        for (std::uint8_t& byte : state.r)
            byte = random_() & 1 ? std::uint8_t(random_()) : edges[random_() % std::size(edges)];
        for (int pointer = 26; pointer < 32; pointer += 2)
            state.r[pointer + 1] = std::uint8_t(2 + random_() % 5);
        state.flags = std::uint8_t(random_());
        state.condition = 0;
        state.sp = std::uint16_t(0x810 + random_() % 0xe0);
        return state;
    }

    void put_word(std::uint32_t address, std::uint16_t word) {
        std::memcpy(core_->flash + address, &word, sizeof word);
    }

    // One step of simavr from a state. Returns the cycles and sets by how many words it advanced.
    std::uint64_t step(State& state, int& went_on) {
        std::memcpy(core_->data + Chip::ram_begin, state.memory + Chip::ram_begin,
                    Chip::ram_end - Chip::ram_begin);
        std::memcpy(core_->data, state.r, sizeof state.r);
        std::memcpy(core_->data + R_SPL, &state.sp, sizeof state.sp);
        for (int i = 0; i < 8; ++i) core_->sreg[i] = state.flags >> i & 1;
        core_->interrupt_state = 0;
        core_->pc = here;
        core_->state = cpu_Running;
        core_->run_cycle_count = 1;
        const std::uint64_t before = core_->cycle;
        const std::uint32_t after = avr_run_one(core_);
        went_on = (int(after) - int(here)) / 2;
        std::memcpy(state.memory + Chip::ram_begin, core_->data + Chip::ram_begin,
                    Chip::ram_end - Chip::ram_begin);
        std::memcpy(state.r, core_->data, sizeof state.r);
        std::memcpy(&state.sp, core_->data + R_SPL, sizeof state.sp);
        state.flags = chip_.status();
        return core_->cycle - before;
    }

    // The difference as text; empty if there is none.
    std::string difference(const Instruction& instruction,
                           void (*translated)(State&, const std::uint8_t*)) {
        put_word(here, instruction.opcode);
        // After a skip, an instruction of one word or of two.
        const bool long_next = random_() & 1;
        put_word(here + 2, instruction.size() == 4 ? instruction.second_word
                                                   : std::uint16_t(long_next ? 0x9000 : 0));
        const State begin = random_state();
        State expected = begin, computed = begin;
        int went_on = 0;
        const std::uint64_t cycles = step(expected, went_on);
        translated(computed, core_->flash);

        const InstructionRow& row = *instruction.row;
        int expected_cycles = row.cycles;
        int words = int(instruction.size() / 2);
        if (computed.condition && row.flow == Flow::branch) {
            ++expected_cycles;
            words += instruction.k;
        } else if (computed.condition) {
            expected_cycles += 1 + long_next;
            words += 1 + long_next;
        }
        computed.condition = 0;
        std::string text;
        if (cycles != std::uint64_t(expected_cycles)) text += fmt::format(" cycles {}", cycles);
        if (went_on != words) text += " next instruction";
        if (std::memcmp(expected.r, computed.r, sizeof expected.r)) text += " registers";
        if (expected.flags != computed.flags)
            text += fmt::format(" flags {:02x} not {:02x}", computed.flags, expected.flags);
        if (expected.sp != computed.sp) text += " stack pointer";
        if (std::memcmp(expected.memory, computed.memory, sizeof expected.memory))
            text += " memory";
        return text;
    }

    // How many instructions differ; the first few as text.
    int count_differences(std::string_view mnemonic, const Compilation& compilation,
                          std::string& text) {
        const std::vector<Instruction> chosen = instructions(random_, mnemonic);
        const SharedObject object(source_of(chosen), compilation);
        int count = 0;
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            const auto translated = reinterpret_cast<void (*)(State&, const std::uint8_t*)>(
                object.symbol(fmt::format("step{}", i).c_str()));
            for (int trial = 0; trial < trials; ++trial) {
                const std::string found = difference(chosen[i], translated);
                if (found.empty()) continue;
                if (++count < 20) text += fmt::format("{}:{}\n", chosen[i].text(), found);
                break;
            }
        }
        return count;
    }

    std::mt19937 random_{1};
    Chip chip_;
    avr_t* core_;
    State state_{};  // with the memory of every trial
};

TEST_F(SemanticsTest, EveryInstructionDoesWhatItDoesInSimavr) {
    std::string text;
    EXPECT_EQ(count_differences({}, {.options = "-O0"}, text), 0) << text;
}

struct Mutant {
    const char *mnemonic, *right, *wrong;

    friend void PrintTo(const Mutant& mutant, std::ostream* stream) { *stream << mutant.mnemonic; }
};

// semantics.hpp with one mistake.
class BrokenSemanticsTest : public SemanticsTest, public testing::WithParamInterface<Mutant> {};

TEST_P(BrokenSemanticsTest, IsFoundOut) {
    namespace fs = std::filesystem;
    const char* const name = "bench/chip/instructions/semantics.hpp";
    std::ifstream stream(fs::path(Compilation().include_folder) / name);
    std::string header((std::istreambuf_iterator<char>(stream)), {});
    const std::size_t place = header.find(GetParam().right);
    ASSERT_NE(place, header.npos) << "the header no longer holds: " << GetParam().right;
    header.replace(place, std::strlen(GetParam().right), GetParam().wrong);

    const fs::path folder =
        fs::temp_directory_path() / fmt::format("broken_semantics.{}", getpid());
    fs::create_directories((folder / name).parent_path());
    std::ofstream(folder / name) << header;
    std::string text;
    const int found =
        count_differences(GetParam().mnemonic, {.options = "-O0", .include_folder = folder}, text);
    fs::remove_all(folder);
    EXPECT_GT(found, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Mutants, BrokenSemanticsTest,
    testing::Values(
        Mutant{"adc", "f.h = (d & 15) + (r & 15) + carry > 15", "f.h = (d & 15) + (r & 15) > 15"},
        Mutant{"add", "f.c = sum > 255", "f.c = sum > 256"},
        Mutant{"sbc", "f.c = d < unsigned(r) + borrow", "f.c = d < r"},
        Mutant{"cpi", "f.v = ((d ^ r) & (d ^ result)) >> 7", "f.v = ((d ^ r) & (r ^ result)) >> 7"},
        Mutant{"sbci", "f.z &= d == 0", "f.z = d == 0"},
        Mutant{"and", "f.s = f.n != f.v", "f.s = f.v"}, Mutant{"com", "f.c = true", "f.c = false"},
        Mutant{"dec", "f.v = d == 0x7f", "f.v = d == 0x80"},
        Mutant{"ror", "f.v = f.n != f.c", "f.v = f.n"},
        Mutant{"mulsu", "std::int8_t(d) * int(r)", "std::int8_t(d) * std::int8_t(r)"},
        Mutant{"fmul", "product << 1", "product"},
        Mutant{"sbiw", "f.c = (~before & after) >> 15", "f.c = (before & after) >> 15"},
        Mutant{"ld", "Word(word(low, high) - 1)", "word(low, high)"},
        Mutant{"push", "bytes[sp--] = value", "bytes[--sp] = value"}));

}  // namespace
}  // namespace instructions
