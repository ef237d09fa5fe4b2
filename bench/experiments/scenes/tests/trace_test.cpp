// SPDX-License-Identifier: GPL-3.0-or-later
// The trace of calls, compared with the profiler, which counts each cycle by other means, and with
// a plain call of the function.
#include <gtest/gtest.h>

#include <filesystem>

#include "bench/chip/profile/profiler.hpp"
#include "bench/chip/simulator/device_function.hpp"
#include "bench/experiments/scenes/call_trace.hpp"
#include "bench/experiments/scenes/workload.hpp"

namespace scene_bench {
namespace {

using simulator::Chip;
using simulator::Elf;

const std::filesystem::path program = workload_programs() / "published_lever.nearest.O2.elf";

TEST(CallTrace, CountsWhatTheProfilerCounts) {
    Chip traced{Elf(program)}, profiled{Elf(program)}, called{Elf(program)};
    const std::vector<Lane> lanes = {{"divide", {"fixedpoint_divide_q16_16"}},
                                     {"resolve", {"_ZN7Watched17solve_constraints"}},
                                     {"missing", {"no_such_function"}}};
    CallTrace trace(traced, lanes);
    traced.run_until_function("step");
    const simulator::Cycle begin = traced.cycle();
    const std::vector<Call> calls = trace.run_function();
    const simulator::Cycle cycles = traced.cycle() - begin + 4;

    called.run_until_function("step");
    simulator::DeviceFunction step(called, "step", {.result = 0, .operands = {}});
    EXPECT_EQ(step().cycles, cycles);

    profiled.run_until_function("step");
    profile::Profiler profiler(profiled);
    profiler.run_until_return();
    const profile::Profile profile = profiler.profile();
    for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
        const profile::FunctionCost* expected = nullptr;
        for (const profile::FunctionCost& cost : profile.functions)
            if (cost.symbol.starts_with(lanes[lane].prefixes[0])) expected = &cost;
        std::uint64_t count = 0, total = 0;
        for (const Call& call : calls) {
            if (call.lane != lane) continue;
            ++count;
            total += call.end - call.begin;
            EXPECT_GE(call.begin, begin);
            EXPECT_LE(call.end, traced.cycle());
        }
        if (expected == nullptr) {
            EXPECT_EQ(count, 0u) << lanes[lane].name;
            EXPECT_EQ(lanes[lane].name, "missing");
        } else {
            EXPECT_EQ(count, expected->calls) << lanes[lane].name;
            EXPECT_EQ(total, expected->inclusive_cycles) << lanes[lane].name;
        }
    }
}

}  // namespace
}  // namespace scene_bench
