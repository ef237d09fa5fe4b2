// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/profile/profiler.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <numeric>

#include "bench/chip/profile/tests/test_program.hpp"
#include "bench/chip/simulator/device_function.hpp"

namespace profile {
namespace {

using simulator::Chip;
using testing::ElementsAre;

// A call of a function of functions.S from main().
struct Called {
    explicit Called(const std::string& function, std::uint8_t r24 = 0)
        : chip(test_program("functions")) {
        chip.run_until_function("main");
        chip.data()[24] = r24;
        Profiler profiler(chip);
        const Cycle began = chip.cycle();
        profiler.call(function);
        profile = profiler.profile();
        EXPECT_EQ(profile.elapsed, chip.cycle() - began);
        EXPECT_EQ(chip.program_counter(), chip.elf().function("main").address);
    }

    // Throws if the function did not run.
    const FunctionCost& operator[](const std::string& name) const {
        const FunctionCost* const found = profile.find(name);
        if (!found) throw std::runtime_error(name + " did not run");
        return *found;
    }

    Chip chip;
    Profile profile;
};

Cycle sum_of_self(const Profile& profile) {
    return std::accumulate(profile.functions.begin(), profile.functions.end(), Cycle{0},
                           [](Cycle sum, const FunctionCost& f) { return sum + f.self_cycles; });
}

TEST(Profiler, FunctionWithoutCalls) {
    const Called called("ten_nops");
    EXPECT_EQ(called["ten_nops"].self_cycles, 4 + 10 + 4);
    EXPECT_EQ(called["ten_nops"].inclusive_cycles, 18);
    EXPECT_EQ(called["ten_nops"].calls, 1);
    EXPECT_EQ(called["ten_nops"].stack_bytes, 2);
    EXPECT_EQ(called["main"].self_cycles, 0);
    EXPECT_EQ(called["main"].calls, 0) << "it began before";
    EXPECT_EQ(called.profile.elapsed, 18);
    EXPECT_EQ(called.profile.folded(), "main;ten_nops 18\n");
}

TEST(Profiler, NestedCalls) {
    const Called called("twice");
    const Cycle inner = 3 + 3 + 4;  // rcall, nops, ret
    EXPECT_EQ(called["three_nops"].calls, 2);
    EXPECT_EQ(called["three_nops"].self_cycles, 2 * inner);
    EXPECT_EQ(called["three_nops"].per_call.count, 2);
    EXPECT_EQ(called["three_nops"].per_call.min, inner);
    EXPECT_EQ(called["three_nops"].per_call.max, inner);
    EXPECT_EQ(called["three_nops"].stack_bytes, 2);
    EXPECT_EQ(called["twice"].self_cycles, 4 + 4);
    EXPECT_EQ(called["twice"].inclusive_cycles, 8 + 2 * inner);
    EXPECT_EQ(called["twice"].frame_bytes, 2);
    EXPECT_EQ(called["twice"].stack_bytes, 4);
    EXPECT_EQ(called.profile.folded(), "main;twice 8\nmain;twice;three_nops 20\n");
}

// Each of n calls: 3 for rcall (4 for the first), dec, breq (a cycle more when taken, the last),
// ret.
TEST(Profiler, RecursionCountsOnceInInclusiveCycles) {
    const Called called("recursive", 5);
    const Cycle all = 4 + 4 * 3 + 5 * (1 + 1 + 4) + 1;
    EXPECT_EQ(called["recursive"].calls, 5);
    EXPECT_EQ(called["recursive"].self_cycles, all);
    EXPECT_EQ(called["recursive"].inclusive_cycles, all);
    EXPECT_EQ(called["recursive"].per_call.count, 5);
    EXPECT_EQ(called["recursive"].per_call.max, all);
    EXPECT_EQ(called["recursive"].per_call.min, 3 + 1 + 2 + 4);
    // From the innermost out, each an rcall, dec, breq and ret more; the outermost by call.
    EXPECT_EQ(called["recursive"].per_call.total, 10 + 19 + 28 + 37 + 47);
    EXPECT_EQ(called["recursive"].frame_bytes, 2);
    EXPECT_EQ(called["recursive"].stack_bytes, 10);
    EXPECT_THAT(called.profile.stacks, testing::SizeIs(5));
}

TEST(Profiler, TailCall) {
    const Called called("jumps_on");
    EXPECT_EQ(called["jumps_on"].self_cycles, 4 + 1 + 2);
    EXPECT_EQ(called["jumps_on"].inclusive_cycles, 7 + 5 + 4);
    EXPECT_EQ(called["five_nops"].calls, 1);
    EXPECT_EQ(called["five_nops"].inclusive_cycles, 5 + 4);
    EXPECT_EQ(called["five_nops"].per_call.max, 9);
    EXPECT_EQ(called["five_nops"].stack_bytes, 2);
    EXPECT_EQ(called.profile.folded(), "main;jumps_on 7\nmain;jumps_on;five_nops 9\n");
}

TEST(Profiler, FallIntoTheNextFunction) {
    const Called called("falls_on");
    EXPECT_EQ(called["falls_on"].self_cycles, 4 + 2);
    EXPECT_EQ(called["fallen_into"].self_cycles, 3 + 4);
    EXPECT_EQ(called["falls_on"].inclusive_cycles, 13);
}

TEST(Profiler, PrologueThatJumpsBack) {
    const Called called("with_prologue");
    EXPECT_EQ(called["prologue"].calls, 1);
    EXPECT_EQ(called["prologue"].self_cycles, 2 + 2 + 2);
    EXPECT_EQ(called["with_prologue"].calls, 1);
    EXPECT_EQ(called["with_prologue"].self_cycles, 4 + 1 + 1 + 2 + 2 + 2 + 4);
    EXPECT_EQ(called["with_prologue"].inclusive_cycles, 16 + 6);
    EXPECT_EQ(called["with_prologue"].stack_bytes, 4);
}

TEST(Profiler, StackOfFunctionAloneAndWithItsCallees) {
    const Called called("pushes");
    EXPECT_EQ(called["pushes"].frame_bytes, 2 + 3);
    EXPECT_EQ(called["pushes"].stack_bytes, 2 + 3 + 2 + 2);
    EXPECT_EQ(called["pushes_two"].frame_bytes, 4);
    EXPECT_EQ(called.profile.stack_bytes, 9u + 2) << "the return address of main";
    EXPECT_EQ(Called("reserves")["reserves"].frame_bytes, 2 + 4);
    EXPECT_EQ(Called("reserves")["reserves"].calls, 1);
}

TEST(Profiler, ReturnToAPushedAddressIsAJump) {
    const Called called("returns_elsewhere");
    EXPECT_EQ(called["returns_elsewhere"].calls, 1);
    EXPECT_EQ(called["returns_elsewhere"].per_call.max, 4 + 1 + 2 + 1 + 2 + 4 + 1 + 4);
    EXPECT_EQ(called["returns_elsewhere"].frame_bytes, 4);
}

TEST(Profiler, SubroutineWithinAFunctionIsNotACall) {
    const Called called("own_subroutine");
    EXPECT_EQ(called["own_subroutine"].calls, 1);
    EXPECT_EQ(called["own_subroutine"].per_call.count, 1);
    EXPECT_EQ(called["own_subroutine"].self_cycles, 4 + 2 * (3 + 1 + 4) + 4);
    EXPECT_EQ(called["own_subroutine"].frame_bytes, 4);
}

TEST(Profiler, IndirectCall) {
    const Called called("indirect");
    EXPECT_EQ(called["three_nops"].inclusive_cycles, 3 + 3 + 4);
    EXPECT_EQ(called["indirect"].self_cycles, 4 + 1 + 1 + 4);
}

// Entry 4, the vector's jmp 3, push 2, pop 2, reti 4, and the function that it calls.
constexpr Cycle handler_self = 4 + 3 + 2 + 2 + 4, handler_callee = 3 + 3 + 4;
// sts 2 each (4 of them), ldi 1 each (2), ret 4; called by rcall.
constexpr Cycle start_timer = 3 + 4 * 2 + 2 + 4;

TEST(Profiler, InterruptIsNotPartOfWhatItInterrupts) {
    const Called called("interrupted_nops", 50);
    EXPECT_EQ(called["interrupted_nops"].self_cycles, 4 + 1 + 200 + 1 + 4);
    EXPECT_EQ(called["interrupted_nops"].inclusive_cycles, 210 + start_timer);
    EXPECT_EQ(called["interrupted_nops"].per_call.max, 210 + start_timer);
    EXPECT_EQ(called["interrupted_nops"].stack_bytes, 4) << "of start_timer, not of the interrupt";
    EXPECT_EQ(called["TIMER1_COMPA_vect"].self_cycles, handler_self);
    EXPECT_EQ(called["__vector_11"].inclusive_cycles, handler_self + handler_callee);
    EXPECT_EQ(called["TIMER1_COMPA_vect"].stack_bytes, 2 + 1 + 2);
    EXPECT_EQ(called["three_nops"].inclusive_cycles, handler_callee);
    EXPECT_EQ(called.profile.stack_bytes, 2u + 2 + 5);
    EXPECT_EQ(called.profile.elapsed, 210 + start_timer + handler_self + handler_callee);

    ASSERT_EQ(called.profile.interrupts.size(), 1);
    const InterruptCost& interrupt = called.profile.interrupts[0];
    EXPECT_EQ(interrupt.vector, 11);
    EXPECT_EQ(interrupt.name, "TIMER1_COMPA_vect");
    EXPECT_EQ(interrupt.entries, 1);
    EXPECT_EQ(interrupt.latency.min, 4 + 3) << "an instruction ends with the flag's rise";
    EXPECT_EQ(interrupt.duration.min, 2 + 2 + 4 + handler_callee);
}

// The flag rises at the end of a jump, or in its middle.
TEST(Profiler, LatencyCountsFromTheFlagNotFromTheEndOfTheInstruction) {
    std::vector<Cycle> latencies;
    for (const std::uint8_t compare : {60, 61, 62, 63})
        latencies.push_back(
            Called("interrupted_jumps", compare).profile.interrupts.at(0).latency.min);
    std::ranges::sort(latencies);
    EXPECT_THAT(latencies, ElementsAre(7, 7, 8, 8));
}

TEST(Profiler, SleepIsAFunctionOfItsOwn) {
    const Called called("interrupted_sleep", 200);
    EXPECT_EQ(called["interrupted_sleep"].self_cycles, 4 + 1 + 1 + 1 + 1 + 1 + 4);
    EXPECT_GT(called["(asleep)"].self_cycles, 150);
    EXPECT_EQ(called["TIMER1_COMPA_vect"].self_cycles, handler_self + 4) << "waking takes 4";
    EXPECT_EQ(called.profile.interrupts.at(0).latency.min, 8 + 3);
    EXPECT_EQ(called.profile.elapsed, sum_of_self(called.profile));
}

TEST(Profiler, WholeProgramFromReset) {
    Chip chip(test_program("interrupts"));
    Profiler profiler(chip);
    constexpr Cycle end = Chip::frequency / 20;
    profiler.run_until_cycle(end);
    const Profile profile = profiler.profile();
    EXPECT_EQ(profile.elapsed, chip.cycle());
    EXPECT_EQ(sum_of_self(profile), chip.cycle());
    EXPECT_EQ(profile.stack_bytes, Chip::ram_end - 1u - chip.lowest_stack_pointer());
    // Both timers clear at their compare: every 702, and every 114 * 8 cycles.
    ASSERT_EQ(profile.interrupts.size(), 2);
    EXPECT_NEAR(double(profile.interrupts[0].entries), double(end) / 702, 1);
    EXPECT_NEAR(double(profile.interrupts[1].entries), double(end) / (114 * 8), 1);
    EXPECT_EQ(profile.interrupts[0].name, "TIMER1_COMPA_vect");
    EXPECT_EQ(profile.interrupts[1].name, "TIMER0_COMPA_vect");
    for (const StackCost& stack : profile.stacks)
        EXPECT_THAT(stack.path.front(),
                    testing::AnyOf("(start-up)", "TIMER1_COMPA_vect", "TIMER0_COMPA_vect"));
    // frame_of() runs in the program and in the interrupt.
    const FunctionCost* const frame_of = profile.find("frame_of");
    ASSERT_NE(frame_of, nullptr);
    EXPECT_EQ(frame_of->per_call.min, frame_of->per_call.max);
    EXPECT_EQ(profile.find("main")->calls, 1);
}

// What DeviceFunction counts for a call, the profiler must find in its parts.
TEST(Profiler, AgreesWithDeviceFunction) {
    Chip chip(test_program("simple"));
    chip.run_until_function("main");
    for (const std::int32_t a : {0, 1, -7, 123456789, -2147483647})
        for (const std::int32_t b : {1, -3, 65536, 2147483647}) {
            simulator::DeviceFunction quotient(chip, "quotient", {.result = 2, .operands = {4, 4}});
            const simulator::Outcome outcome = quotient(a, b);
            std::memcpy(chip.data() + 22, &a, sizeof a);
            std::memcpy(chip.data() + 18, &b, sizeof b);
            chip.data()[1] = 0;
            Profiler profiler(chip);
            profiler.call("quotient");
            const Profile profile = profiler.profile();
            const FunctionCost* const cost = profile.find("quotient");
            EXPECT_EQ(cost->inclusive_cycles, outcome.cycles);
            EXPECT_EQ(cost->per_call.max, outcome.cycles);
            EXPECT_EQ(cost->stack_bytes, outcome.stack_bytes);
            EXPECT_EQ(profile.elapsed, outcome.cycles);
            EXPECT_EQ(profile.find("__divmodsi4")->calls, 1);
        }
}

TEST(Profiler, LongJumpEndsTheCallsThatItLeaves) {
    Chip chip(test_program("long_jump"));
    Profiler profiler(chip);
    profiler.run_until_cycle(100'000);
    const Profile profile = profiler.profile();
    const FunctionCost* const tries = profile.find("tries");
    ASSERT_NE(tries, nullptr);
    EXPECT_GT(tries->calls, 100);
    EXPECT_NEAR(double(profile.find("throws")->per_call.count), double(tries->calls), 1);
    EXPECT_EQ(sum_of_self(profile), profile.elapsed);
    for (const StackCost& stack : profile.stacks)
        EXPECT_LE(stack.path.size(), 6u) << profile.folded();
}

TEST(Profiler, RestartCountsFromThereOn) {
    Chip chip(test_program("simple"));
    Profiler profiler(chip);
    profiler.run_until_function("ratio");
    profiler.restart();
    const Cycle began = chip.cycle();
    profiler.run_until_return();
    const Profile profile = profiler.profile();
    EXPECT_EQ(profile.elapsed, chip.cycle() - began);
    EXPECT_EQ(profile.find("ratio")->calls, 0) << "the call was before";
    EXPECT_EQ(profile.find("ratio")->per_call.count, 0);
    EXPECT_EQ(profile.find("ratio")->inclusive_cycles, profile.elapsed);
    EXPECT_EQ(profile.find("main")->self_cycles, 0);
    EXPECT_EQ(profile.find("quotient"), nullptr);
}

TEST(Profiler, RefusesAChipThatWasRunWithoutIt) {
    Chip chip(test_program("functions"));
    Profiler profiler(chip);
    chip.run_until_function("main");
    EXPECT_THROW(profiler.profile(), std::logic_error);
}

}  // namespace
}  // namespace profile
