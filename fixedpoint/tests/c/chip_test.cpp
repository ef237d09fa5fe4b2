// SPDX-License-Identifier: GPL-3.0-or-later
// program.c, compiled as C for the host and for the chip, has the same results on both.
#include "bench/chip/simulator/chip.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

extern "C" {
#include "program.h"
}

#define FORMATS(X) X(q4_4) X(q8_8) X(q16_16) X(q8_24) X(q32_32)
#define DECLARE(q)                \
    extern c_results q##_results; \
    void q##_operations();        \
    void q##_functions();         \
    void q##_angles();            \
    void q##_turns();             \
    void q##_powers();            \
    void q##_auxiliary();         \
    void q##_conversions();
extern "C" {
FORMATS(DECLARE)
}

namespace {

struct Part {
    std::string name;  // of the program
    void (*run)();
    const c_results& results;
};

#define PARTS(q)                                                                                \
    {#q "_operations", q##_operations, q##_results},                                            \
        {#q "_functions", q##_functions, q##_results}, {#q "_angles", q##_angles, q##_results}, \
        {#q "_turns", q##_turns, q##_results}, {#q "_powers", q##_powers, q##_results},         \
        {#q "_auxiliary", q##_auxiliary, q##_results},                                          \
        {#q "_conversions", q##_conversions, q##_results},

class CProgram : public testing::TestWithParam<Part> {};

TEST_P(CProgram, HasTheHostsResultsOnTheChip) {
    const Part& part = GetParam();
    simulator::Chip chip(simulator::Elf(PROGRAM_FOLDER "/c_program_" + part.name + ".elf"));
    ASSERT_NO_THROW(chip.run_until_function("finished", 10ull * simulator::Chip::frequency));
    const std::string format = part.name.substr(0, part.name.rfind('_'));
    const std::uint16_t address = chip.elf().object(format + "_results").address;
    const auto bytes = [&](int offset, int size) {
        std::uint32_t value = 0;
        for (int i = size - 1; i >= 0; --i) value = value << 8 | chip.read(address + offset + i);
        return value;
    };
    part.run();
    ASSERT_EQ(bytes(0, 2), part.results.count);
    for (unsigned i = 0; i < part.results.count; ++i)
        EXPECT_EQ(bytes(2 + 4 * i, 4), part.results.hash[i]) << part.results.name[i];
}

INSTANTIATE_TEST_SUITE_P(Parts, CProgram, testing::ValuesIn(std::vector<Part>{FORMATS(PARTS)}),
                         [](const auto& part) { return part.param.name; });

}  // namespace
