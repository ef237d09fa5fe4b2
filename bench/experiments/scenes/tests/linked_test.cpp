// SPDX-License-Identifier: GPL-3.0-or-later
// The divisions in the levers' programs, by their symbols.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "bench/chip/simulator/quotients.hpp"
#include "bench/experiments/scenes/chip_run.hpp"
#include "bench/experiments/scenes/tests/pinned_hashes.hpp"

namespace scene_bench {
namespace {

std::vector<std::string> quotients_of(const char* scene, const char* scalar) {
    return simulator::quotients(
        simulator::Elf(program_path(scene_programs(), scene, scalar, "semi_implicit_euler", "8")));
}

// Its rod is measured by products, and the reciprocal of the length is folded.
TEST(LinkedQuotients, LeversHaveNone) {
    for (const char* scalar : pinned_scalars)
        EXPECT_THAT(quotients_of("lever", scalar), testing::IsEmpty()) << scalar;
}
// Masses share by the small quotient. It is listed, which shows that the search finds one.
TEST(LinkedQuotients, PairsHaveTheSmallOne) {
    for (const char* scene : {"double_pendulum", "newtons_cradle", "stack", "box_of_particles"})
        EXPECT_THAT(quotients_of(scene, "q16_16"),
                    testing::ElementsAre("fixedpoint_divide_q16_16_small"));
}

}  // namespace
}  // namespace scene_bench
