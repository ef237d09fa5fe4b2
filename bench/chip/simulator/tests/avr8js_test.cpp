// SPDX-License-Identifier: GPL-3.0-or-later
// An independent simulator, avr8js, returns the same results in the same cycles.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <random>
#include <vector>

#include "bench/chip/simulator/device_function.hpp"
#include "programs.hpp"
#include "this_build.hpp"

namespace simulator {
namespace {

const std::filesystem::path avr8js = build_folder() / "bench/chip/simulator/avr8js";

struct Call {
    std::string function;
    Signature signature;
    std::vector<std::uint64_t> operands;
};

std::vector<std::string> run_in_avr8js(const Elf& elf, const std::vector<Call>& calls) {
    const std::string base = avr8js / elf.path().stem();
    std::ofstream(base + ".bin", std::ios::binary)
        .write(reinterpret_cast<const char*>(elf.flash().data()), elf.flash().size());
    std::ofstream list(base + ".calls");
    for (const Call& call : calls) {
        list << fmt::format("{:x} {}", elf.function(call.function).address, call.signature.result);
        for (std::size_t i = 0; i < call.operands.size(); ++i)
            list << fmt::format(" {}:{:x}", call.signature.operands[i], call.operands[i]);
        list << '\n';
    }
    list.close();
    const std::string command =
        fmt::format("cd '{}' && node call.mjs '{}.bin' {:x} < '{}.calls' > '{}.out'",
                    avr8js.string(), base, elf.function("main").address, base, base);
    if (std::system(command.c_str())) return {};
    std::vector<std::string> lines;
    std::ifstream answers(base + ".out");
    for (std::string line; std::getline(answers, line);) lines.push_back(line);
    return lines;
}

void compare(const Elf& elf, const std::vector<Call>& calls) {
    const std::vector<std::string> theirs = run_in_avr8js(elf, calls);
    ASSERT_EQ(theirs.size(), calls.size());
    Chip chip(elf);
    chip.run_until_function("main");
    for (std::size_t i = 0; i < calls.size(); ++i) {
        DeviceFunction function(chip, calls[i].function, calls[i].signature);
        const Outcome ours = function.call(calls[i].operands);
        EXPECT_EQ(fmt::format("{:x} {}", ours.result, ours.cycles), theirs[i])
            << calls[i].function << fmt::format("({:x})", fmt::join(calls[i].operands, ", "));
    }
}

class Avr8jsTest : public testing::Test {
  protected:
    void SetUp() override {
        if (!std::filesystem::exists(avr8js / "node_modules"))
            GTEST_SKIP() << "avr8js is not installed: see the test Avr8jsTest.install";
    }
};

// But for `cbi`, which takes two cycles by the data sheet's instruction set summary, and one in
// avr8js.
TEST_F(Avr8jsTest, AgreesOnHandCountedSequences) {
    std::vector<Call> calls;
    for (const char* name : {"count_nothing", "count_single", "count_double", "count_memory",
                             "count_branches", "count_skips", "count_calls", "count_loop"})
        calls.push_back({name, {0, {}}, {}});
    compare(test_program("counted"), calls);
}

TEST_F(Avr8jsTest, AgreesOnArithmetic) {
    const std::pair<const char*, Signature> functions[] = {
        {"negate_int8", {1, {1}}},
        {"subtract_int16", {2, {2, 2}}},
        {"multiply_int32", {4, {4, 4}}},
        {"divide_int32", {4, {4, 4}}},
        {"subtract_int64", {8, {8, 8}}},
        {"weigh_int64", {8, {8, 8, 8}}},
        {"weigh_mixed", {4, {1, 2, 4, 8, 1, 2, 1, 4}}},
        {"square_root_uint32", {2, {4}}},
        {"multiply_float", {4, {4, 4}}},
        {"divide_float", {4, {4, 4}}},
        {"square_root_float", {4, {4}}},
        {"arc_tangent_float", {4, {4}}}};
    std::mt19937_64 random(1);
    std::vector<Call> calls;
    for (const auto& [name, signature] : functions)
        for (int i = 0; i < 200; ++i) {
            std::vector<std::uint64_t> operands;
            for (const int size : signature.operands) {
                const int shift = random() % (8 * size);  // short and long numbers alike
                operands.push_back((random() >> (64 - 8 * size)) >> shift);
            }
            calls.push_back({name, signature, operands});
        }
    compare(test_program("calls"), calls);
}

}  // namespace
}  // namespace simulator
