// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/profile/stack_bound.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/chip/profile/profiler.hpp"
#include "bench/chip/profile/tests/test_program.hpp"

namespace profile {
namespace {

using simulator::Chip;
using testing::ElementsAre;
using testing::HasSubstr;

const FunctionBound& function(const StackBound& bound, const std::string& name) {
    for (const FunctionBound& candidate : bound.functions)
        if (candidate.name == name) return candidate;
    throw std::runtime_error(name + " is not reached");
}

Profile measured(const std::string& program, Cycle cycles = 400'000) {
    Chip chip(test_program(program));
    Profiler profiler(chip);
    profiler.run_until_cycle(cycles);
    return profiler.profile();
}

void expect_no_less_than_measured(const StackBound& bound, const Profile& profile) {
    for (const FunctionCost& cost : profile.functions) {
        if (cost.symbol.empty()) continue;
        for (const FunctionBound& reached : bound.functions) {
            if (reached.name != cost.name) continue;
            ASSERT_TRUE(reached.frame_bytes) << cost.name;
            EXPECT_GE(*reached.frame_bytes, cost.frame_bytes) << cost.name;
            ASSERT_TRUE(reached.stack_bytes) << cost.name;
            EXPECT_GE(*reached.stack_bytes, cost.stack_bytes) << cost.name;
        }
    }
}

class ReachesItsBound : public testing::TestWithParam<const char*> {};

// These programs take each of their few paths.
TEST_P(ReachesItsBound, Exactly) {
    const StackBound bound = static_stack_bound(test_program(GetParam()));
    const Profile profile = measured(GetParam());
    EXPECT_THAT(bound.unbounded, ElementsAre());
    ASSERT_TRUE(bound.bytes);
    EXPECT_EQ(*bound.bytes, profile.stack_bytes);
    expect_no_less_than_measured(bound, profile);
    EXPECT_EQ(*function(bound, "main").stack_bytes, profile.find("main")->stack_bytes);
}
INSTANTIATE_TEST_SUITE_P(StackBound, ReachesItsBound,
                         testing::Values("simple", "switch", "shared_prologues"),
                         [](const auto& info) { return std::string(info.param); });

TEST(StackBound, FrameAndSharedPrologue) {
    for (const char* program : {"simple", "shared_prologues"}) {
        const StackBound bound = static_stack_bound(test_program(program));
        // Return address, r28 and r29, the array.
        EXPECT_EQ(function(bound, "frame_of").frame_bytes, 2 + 2 + 100) << program;
    }
    // Return address, r28 and r29, four bytes.
    EXPECT_EQ(function(static_stack_bound(test_program("simple")), "small_frame_of").frame_bytes,
              2 + 2 + 4);
    EXPECT_EQ(static_stack_bound(test_program("functions")).bytes, 2u + (2 + 1 + 2))
        << "main, and TIMER1_COMPA_vect with what it calls";
}

// main() with the deepest handler, while the other one waits.
TEST(StackBound, OneInterruptOnTopOfTheProgram) {
    const StackBound bound = static_stack_bound(test_program("interrupts"));
    const Profile profile = measured("interrupts", Chip::frequency);
    ASSERT_TRUE(bound.bytes);
    EXPECT_THAT(bound.interrupts, ElementsAre("TIMER1_COMPA_vect"));
    EXPECT_THAT(bound.path, ElementsAre("main", "choose", "frame_of"));
    EXPECT_EQ(bound.interrupt_bytes, *function(bound, "TIMER1_COMPA_vect").stack_bytes);
    EXPECT_EQ(bound.interrupt_bytes, profile.find("TIMER1_COMPA_vect")->stack_bytes);
    EXPECT_EQ(*bound.bytes, profile.stack_bytes) << "within a second it meets the deepest place";
    expect_no_less_than_measured(bound, profile);
}

TEST(StackBound, HandlerThatEnablesInterruptsIsInterrupted) {
    const StackBound bound = static_stack_bound(test_program("nested"));
    ASSERT_TRUE(bound.bytes);
    EXPECT_THAT(bound.interrupts, ElementsAre("TIMER1_COMPA_vect", "TIMER0_COMPA_vect"));
    EXPECT_TRUE(function(bound, "TIMER1_COMPA_vect").enables_interrupts);
    EXPECT_FALSE(function(bound, "TIMER0_COMPA_vect").enables_interrupts);
    EXPECT_THAT(bound.interruptible, ElementsAre("TIMER1_COMPA_vect"));
    EXPECT_EQ(bound.interrupt_bytes, *function(bound, "TIMER1_COMPA_vect").stack_bytes +
                                         *function(bound, "TIMER0_COMPA_vect").stack_bytes);
    EXPECT_GE(*bound.bytes, measured("nested").stack_bytes);
}

TEST(StackBound, NamesWhatItCannotBound) {
    const StackBound recursion = static_stack_bound(test_program("recursion"));
    EXPECT_FALSE(recursion.bytes);
    EXPECT_THAT(recursion.unbounded, ElementsAre(HasSubstr("recursion: ")));
    EXPECT_THAT(recursion.unbounded[0], testing::AllOf(HasSubstr("even"), HasSubstr("odd")));
    EXPECT_FALSE(function(recursion, "even").stack_bytes);
    EXPECT_FALSE(function(recursion, "main").stack_bytes);

    const StackBound pointer = static_stack_bound(test_program("pointer"));
    EXPECT_FALSE(pointer.bytes);
    EXPECT_THAT(pointer.unbounded, ElementsAre(HasSubstr("indirect call in main")));

    const StackBound jump = static_stack_bound(test_program("long_jump"));
    EXPECT_FALSE(jump.bytes);
    EXPECT_THAT(jump.unbounded, ElementsAre(HasSubstr(" in setjmp+")));
}

}  // namespace
}  // namespace profile
