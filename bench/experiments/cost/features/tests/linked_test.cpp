// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/cost/features/linked.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>

#include "this_build.hpp"

namespace features {

void PrintTo(const Program& program, std::ostream* out) {
    *out << program.scene << (program.with ? " with " : " without ") << program.feature;
}

namespace {

using simulator::Elf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

const std::filesystem::path folder = build_folder() / "bench/experiments/cost/features";
const Uses lever = {"GRAVITY",           "ANCHORED_RODS",
                    "CUSTOM_FORCE",      "2",
                    "SemiImplicitEuler", "ProjectedGaussSeidel<10>",
                    "BruteForce",        "Nearest"};

class FeaturePrograms : public testing::TestWithParam<Program> {};

// As measured, with inlined calls: symbols of kernels and tables remain.
TEST_P(FeaturePrograms, hold_nothing_that_their_scene_does_not_use) {
    EXPECT_THAT(unneeded(Elf(GetParam().measured), GetParam().uses), IsEmpty());
}
// With every function separate: code that the optimiser would hide in others is visible, too.
TEST_P(FeaturePrograms, hold_exactly_what_their_scene_uses_where_nothing_is_inlined) {
    const Elf elf(GetParam().uninlined);
    EXPECT_THAT(unneeded(elf, GetParam().uses), IsEmpty());
    EXPECT_THAT(missing(elf, GetParam().uses), IsEmpty());
}
INSTANTIATE_TEST_SUITE_P(all, FeaturePrograms, testing::ValuesIn(load_programs(folder)),
                         [](const auto& instance) {
                             const Program& p = instance.param;
                             std::string name =
                                 p.scene + (p.with ? "_with_" : "_without_") + p.feature;
                             for (char& c : name)
                                 if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                             return name;
                         });

// The check finds what is smuggled in, and what the scene did not ask for.
TEST(Unneeded, finds_a_stowaway) {
    for (const char* suffix : {"", "_uninlined"}) {
        const auto found = unneeded(Elf(folder / (std::string(STOWAWAY) + suffix + ".elf")), lever);
        EXPECT_THAT(found, Contains(HasSubstr("__mulsf3 of floating point")));
        EXPECT_THAT(found, Contains(HasSubstr("fixedpoint_sqrt_q16_16 of square roots")));
    }
}
TEST(Unneeded, finds_each_feature_that_a_scene_is_declared_not_to_use) {
    for (const Program& program : load_programs(folder)) {
        if (!program.with || program.feature.find('=') != std::string::npos) continue;
        Uses others = program.uses;
        std::string name = program.feature;
        for (char& c : name) c = static_cast<char>(std::toupper(c));
        ASSERT_EQ(others.erase(name), 1u);
        EXPECT_THAT(unneeded(Elf(program.uninlined), others), testing::Not(IsEmpty()))
            << program.scene << ' ' << program.feature;
    }
}

}  // namespace
}  // namespace features
