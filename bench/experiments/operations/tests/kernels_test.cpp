// SPDX-License-Identifier: GPL-3.0-or-later
// The machine code of every subject against the host, as `fixbench verify` runs it, a program a
// test.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "bench/experiments/operations/verify_kernels.hpp"

namespace operations {
namespace {

// The folder of the programs: scripts/mutation_test.py names another, with faults in them.
std::string folder() {
    const char* other = std::getenv("DEVICE_PROGRAMS");
    return other ? other : PROGRAM_FOLDER;
}

class Kernels : public testing::TestWithParam<std::string> {};

TEST_P(Kernels, AreTheHostsBitForBit) {
    VerifyOptions options;
    options.programs = {folder() + "/" + GetParam() + ".elf"};
    options.output = testing::TempDir() + "kernels_test." + GetParam();
    options.selection.implementations = {"default", "small", "saturating"};
    options.samples = GetParam() == "q32_32" ? 400 : 4000;  // of 64 bits calls are long
    EXPECT_EQ(verify_kernels(options), 0u);
}
INSTANTIATE_TEST_SUITE_P(Programs, Kernels,
                         testing::Values("q4_4", "q8_8", "q16_16", "q8_24", "q32_32"),
                         [](const auto& program) { return program.param; });

}  // namespace
}  // namespace operations
