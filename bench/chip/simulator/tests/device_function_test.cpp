// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/simulator/device_function.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "programs.hpp"

namespace simulator {
namespace {

class CallsTest : public testing::Test {
  protected:
    void SetUp() override { chip.run_until_function("main"); }
    DeviceFunction function(const char* name, Signature signature) {
        return DeviceFunction(chip, name, std::move(signature));
    }
    template <class T>
    T random() {
        return static_cast<T>(generator());
    }

    Chip chip{test_program("calls")};
    std::mt19937_64 generator{1};
};

TEST_F(CallsTest, OperandsOfEachWidthInRegisters) {
    DeviceFunction negate = function("negate_int8", {1, {1}});
    DeviceFunction subtract_int16 = function("subtract_int16", {2, {2, 2}});
    DeviceFunction multiply_int32 = function("multiply_int32", {4, {4, 4}});
    DeviceFunction subtract_int64 = function("subtract_int64", {8, {8, 8}});
    for (int i = 0; i < 1000; ++i) {
        const auto a8 = random<std::int8_t>();
        EXPECT_EQ(negate(a8).as<std::int8_t>(), static_cast<std::int8_t>(-a8));
        const auto a16 = random<std::int16_t>(), b16 = random<std::int16_t>();
        EXPECT_EQ(subtract_int16(a16, b16).as<std::int16_t>(),
                  static_cast<std::int16_t>(a16 - b16));
        const auto a32 = random<std::uint32_t>(), b32 = random<std::uint32_t>();
        EXPECT_EQ(multiply_int32(a32, b32).as<std::uint32_t>(), a32 * b32);
        const auto a64 = random<std::uint64_t>(), b64 = random<std::uint64_t>();
        EXPECT_EQ(subtract_int64(a64, b64).as<std::uint64_t>(), a64 - b64);
    }
}

TEST_F(CallsTest, Floats) {
    EXPECT_EQ(function("multiply_float", {4, {4, 4}})(1.5f, -2.5f).as<float>(), -3.75f);
    EXPECT_EQ(function("divide_float", {4, {4, 4}})(1.0f, 3.0f).as<float>(), 1.0f / 3.0f);
}

TEST_F(CallsTest, OperandsOnTheStack) {
    DeviceFunction weigh = function("weigh_int64", {8, {8, 8, 8}});
    for (int i = 0; i < 1000; ++i) {
        const auto a = random<std::uint64_t>(), b = random<std::uint64_t>(),
                   c = random<std::uint64_t>();
        EXPECT_EQ(weigh(a, b, c).as<std::uint64_t>(), a + 2 * b + 3 * c);
    }
}

TEST_F(CallsTest, MixedWidthsInRegistersAndOnTheStack) {
    DeviceFunction weigh = function("weigh_mixed", {4, {1, 2, 4, 8, 1, 2, 1, 4}});
    for (int i = 0; i < 1000; ++i) {
        const auto a = random<std::int8_t>(), e = random<std::int8_t>(), g = random<std::int8_t>();
        const auto b = random<std::int16_t>(), f = random<std::int16_t>();
        const auto c = random<std::uint32_t>(), h = random<std::uint32_t>();
        const auto d = random<std::uint64_t>();
        EXPECT_EQ(weigh(a, b, c, d, e, f, g, h).as<std::uint32_t>(),
                  a + 3u * b + 5u * c + 7u * static_cast<std::uint32_t>(d) + 11u * e + 13u * f +
                      17u * g + 19u * h);
    }
}

TEST_F(CallsTest, ArraysByAddress) {
    const std::array<std::int32_t, 3> a{1, -20, 300}, b{7, 11, -13};
    const auto bytes = [](const auto& array) {
        return std::span(reinterpret_cast<const std::uint8_t*>(array.data()), sizeof array);
    };
    const std::uint16_t at_a = chip.allocate(12), at_b = chip.allocate(12);
    chip.write(at_a, bytes(a));
    chip.write(at_b, bytes(b));
    EXPECT_EQ(function("dot3", {4, {2, 2}})(at_a, at_b).as<std::int32_t>(), 7 - 220 - 3900);

    const std::array<std::int16_t, 3> from{5, 6, 7};
    chip.write(at_a, bytes(from));
    DeviceFunction reverse = function("reverse3", {0, {2, 2}});
    reverse.forbid_writes_except({{at_b, 6}});
    reverse(at_a, at_b);
    std::array<std::int16_t, 3> to;
    chip.read(at_b, {reinterpret_cast<std::uint8_t*>(to.data()), 6});
    EXPECT_EQ(to, (std::array<std::int16_t, 3>{7, 6, 5}));

    chip.write(at_b, bytes(from));
    reverse.forbid_writes_except({{at_b, 4}});
    EXPECT_THROW(reverse(at_a, at_b), SimulationError);
}

TEST_F(CallsTest, VariablesHaveTheirInitialValues) {
    EXPECT_EQ(function("scaled", {2, {2}})(std::uint16_t{7}).as<std::uint16_t>(), 7000);
}

TEST_F(CallsTest, TheChipIsWhereItWasAfterACall) {
    const std::uint32_t program_counter = chip.program_counter();
    const std::uint16_t stack_pointer = chip.stack_pointer();
    function("multiply_int32", {4, {4, 4}})(3, 4);
    EXPECT_EQ(chip.program_counter(), program_counter);
    EXPECT_EQ(chip.stack_pointer(), stack_pointer);
}

TEST_F(CallsTest, WrongNumberOfOperands) {
    DeviceFunction multiply = function("multiply_int32", {4, {4, 4}});
    EXPECT_THROW(multiply(1), SimulationError);
}

TEST_F(CallsTest, MoreMemoryThanThereIs) { EXPECT_THROW(chip.allocate(3000), SimulationError); }

TEST(CountedTest, CyclesOfHandCountedSequences) {
    Chip chip(test_program("counted"));
    const std::pair<const char*, std::uint32_t> counted[] = {
        {"count_nothing", 8}, {"count_single", 24},   {"count_double", 32},
        {"count_memory", 24}, {"count_branches", 17}, {"count_skips", 16},
        {"count_calls", 32},  {"count_loop", 38},     {"count_clear_bit", 10}};
    for (const auto& [name, cycles] : counted)
        EXPECT_EQ(DeviceFunction(chip, name, {0, {}})().cycles, cycles) << name;
}

class FaultsTest : public testing::Test {
  protected:
    std::string message_of_call(const char* name) {
        try {
            DeviceFunction(chip, name, {1, {1}})(std::uint8_t{1});
        } catch (const SimulationError& error) {
            return error.what();
        }
        return "no exception";
    }
    Chip chip{test_program("faults")};
};

TEST_F(FaultsTest, ProgramsThatGoWrong) {
    const auto expect_begin = [&](const char* name, const std::string& begin) {
        const std::string message = message_of_call(name);
        EXPECT_EQ(message.substr(0, begin.size()), begin);
    };
    expect_begin("hang", "not done after 1000000 cycles, at hang+0");
    expect_begin("illegal_opcode", "illegal opcode 0x00ff at illegal_opcode+2, cycle ");
    expect_begin("jump_out", "jump out of the program, at flash address 0x7ff");
    expect_begin(
        "recurse",
        "the stack ran into the data: stack pointer 0x013d, data up to 0x013f at recurse+0");
    expect_begin("big_frame", "the stack ran into the data: stack pointer 0x0");
    expect_begin("sleep_forever",
                 "sleep with interrupts off, which nothing ends, at sleep_forever+4");
}

// simavr itself would overwrite the host's memory.
TEST_F(FaultsTest, AddressesBeyondTheChip) {
    for (const char* name :
         {"write_beyond_ram", "write_last_address", "read_beyond_ram", "stack_beyond_ram"}) {
        const std::string message = message_of_call(name);
        EXPECT_EQ(message.find("access to a data address beyond the RAM at " + std::string(name)),
                  0u)
            << message;
    }
    EXPECT_EQ(DeviceFunction(chip, "read_beyond_flash", {1, {1}})(std::uint8_t{1}).result, 0xffu);
    EXPECT_EQ(DeviceFunction(chip, "eeprom_end", {2, {1}})(std::uint8_t{77}).result, 0x0300u | 77u);
    std::uint8_t bytes[2];
    EXPECT_THROW(chip.read(Chip::ram_end - 1, bytes), SimulationError);
    EXPECT_THROW(chip.write(Chip::ram_end - 1, bytes), SimulationError);
    EXPECT_NO_THROW(chip.read(Chip::ram_end - 2, bytes));
}

TEST_F(FaultsTest, TheCallerRecovers) {
    message_of_call("recurse");
    EXPECT_EQ(DeviceFunction(chip, "push_three", {0, {}})().stack_bytes, 7);
}

TEST_F(FaultsTest, CallingConvention) {
    EXPECT_EQ(message_of_call("leave_r1"), "leave_r1: r1 is not zero at return");
    EXPECT_EQ(message_of_call("change_r5"),
              "change_r5: call-saved register r5 is changed at return");
    EXPECT_EQ(message_of_call("change_r17"),
              "change_r17: call-saved register r17 is changed at return");
    EXPECT_EQ(message_of_call("change_r28"),
              "change_r28: call-saved register r28 is changed at return");
    EXPECT_EQ(message_of_call("enable_interrupts"),
              "enable_interrupts: interrupts are on at return");
    EXPECT_EQ(message_of_call("unbalanced"),
              "unbalanced: the stack pointer is not balanced at return");
}

TEST_F(FaultsTest, WritesOutsideOfTheFrame) {
    for (const char* name : {"write_variable", "write_below_stack"}) {
        DeviceFunction function(chip, name, {1, {1}});
        EXPECT_NO_THROW(function(std::uint8_t{1}));
        function.forbid_writes_except({});
        EXPECT_THROW(function(std::uint8_t{2}), SimulationError) << name;
    }
    DeviceFunction permitted(chip, "write_variable", {1, {1}});
    const auto address = static_cast<std::uint16_t>(chip.elf().object("variables").address);
    permitted.forbid_writes_except({{address, 1}});
    EXPECT_NO_THROW(permitted(std::uint8_t{3}));
}

TEST_F(FaultsTest, StackBytes) {
    EXPECT_EQ(DeviceFunction(chip, "push_three", {0, {}})().stack_bytes, 2 + 3 + 2);
    EXPECT_EQ(DeviceFunction(chip, "reserve_twenty", {0, {}})().stack_bytes, 2 + 2 + 20);
    EXPECT_EQ(DeviceFunction(chip, "write_variable", {0, {1}})(std::uint8_t{1}).stack_bytes, 2);
}

TEST_F(FaultsTest, CoverageNamesWhatWasNotExecuted) {
    Coverage coverage;
    DeviceFunction function(chip, "either_branch", {1, {1}});
    function.record(&coverage);
    const std::uint32_t begin = function.symbol().address;
    const std::uint32_t cycles = function(std::uint8_t{1}).cycles;
    EXPECT_EQ(coverage.missed(chip.elf(), function.symbol()),
              (std::vector<std::uint32_t>{begin + 12, begin + 14}));
    function(std::uint8_t{0});
    EXPECT_TRUE(coverage.missed(chip.elf(), function.symbol()).empty());
    function.record(nullptr);
    EXPECT_EQ(function(std::uint8_t{1}).cycles, cycles);
}

}  // namespace
}  // namespace simulator
