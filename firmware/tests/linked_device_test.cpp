// SPDX-License-Identifier: GPL-3.0-or-later
// The divisions in the flashed levers, by their symbols.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "bench/chip/simulator/quotients.hpp"
#include "this_build.hpp"

namespace {

using testing::Contains;
using testing::IsSubsetOf;

std::vector<std::string> quotients_of(const std::string& program) {
    return simulator::quotients(simulator::Elf(build_folder() / "firmware" / (program + ".elf")));
}

// 16-bit and 32-bit ones, and one kernel.
class FlashedLever : public testing::TestWithParam<const char*> {};
TEST_P(FlashedLever, HasNo64BitQuotient) {
    EXPECT_THAT(quotients_of(GetParam()), IsSubsetOf({"__divmodhi4", "__udivmodhi4", "__udivmodsi4",
                                                      "fixedpoint_divide_q16_16"}));
}
INSTANTIATE_TEST_SUITE_P(All, FlashedLever,
                         testing::Values("lever", "lever_profiled", "lever_arduino"),
                         [](const auto& info) { return std::string(info.param); });

// The published arithmetic divides like this, which shows that such a quotient is found.
TEST(PublishedLever, HasA64BitQuotient) {
    EXPECT_THAT(quotients_of("lever_published"), Contains("__udivdi3"));
}

}  // namespace
