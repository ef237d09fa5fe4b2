// SPDX-License-Identifier: GPL-3.0-or-later
// program.c, compiled as C for the host and for the chip, has the same results on both.
#include "bench/chip/simulator/chip.hpp"

#include <fixedpoint/c_functions.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <tuple>

#include "this_build.hpp"

extern "C" {
#include "program.h"
}

#define DECLARE(q, ...)           \
    extern c_results q##_results; \
    void q##_run(std::uint8_t part);
extern "C" {
FIXEDPOINT_C_FORMATS(DECLARE)
}

namespace {

struct Format {
    const char* name;
    void (*run)(std::uint8_t part);
    const c_results& results;
};
#define FORMAT(q, ...) Format{#q, q##_run, q##_results},
const Format formats[] = {FIXEDPOINT_C_FORMATS(FORMAT)};

class CProgram : public testing::TestWithParam<std::tuple<Format, int>> {};
std::string name_of(const std::tuple<Format, int>& program) {
    return std::get<Format>(program).name + ("_" + std::to_string(std::get<int>(program)));
}

TEST_P(CProgram, HasTheHostsResultsOnTheChip) {
    const auto& [format, part] = GetParam();
    simulator::Chip chip(simulator::Elf(build_folder() / "fixedpoint" /
                                        ("c_program_" + name_of(GetParam()) + ".elf")));
    ASSERT_NO_THROW(chip.run_until_function("finished", 10ull * simulator::Chip::frequency));
    const std::uint16_t address = chip.elf().object(format.name + std::string("_results")).address;
    const auto bytes = [&](int offset, int size) {
        std::uint32_t value = 0;
        for (int i = size - 1; i >= 0; --i) value = value << 8 | chip.read(address + offset + i);
        return value;
    };
    format.run(static_cast<std::uint8_t>(part));
    ASSERT_EQ(bytes(0, 2), format.results.count);
    for (unsigned i = 0; i < format.results.count; ++i)
        EXPECT_EQ(bytes(2 + 4 * i, 4), format.results.hash[i]) << format.results.name[i];
}

INSTANTIATE_TEST_SUITE_P(Parts, CProgram,
                         testing::Combine(testing::ValuesIn(formats), testing::Range(0, C_PARTS)),
                         [](const auto& program) { return name_of(program.param); });

}  // namespace
