// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/scenes/call_trace.hpp"

namespace scene_bench {
namespace {

constexpr simulator::Cycle call_cycles = 4;
constexpr simulator::Cycle longest = 50'000'000;

}  // namespace

CallTrace::CallTrace(simulator::Chip& chip, const std::vector<Lane>& lanes)
    : chip_(chip), lanes_(lanes.size()) {
    for (std::size_t lane = 0; lane < lanes.size(); ++lane)
        for (const auto& [name, symbol] : chip.elf().functions())
            for (const std::string& prefix : lanes[lane].prefixes)
                if (name.starts_with(prefix)) lane_at_[symbol.address] = lane;
}

std::vector<Call> CallTrace::run_function() {
    struct Open {
        std::size_t lane;
        simulator::Cycle begin;
        std::uint16_t stack_pointer;
    };
    std::vector<Open> open;
    std::vector<bool> runs(lanes_);
    std::vector<Call> calls;
    const std::uint16_t entry = chip_.stack_pointer();
    const simulator::Cycle limit = chip_.cycle() + longest;
    while (chip_.stack_pointer() <= entry) {
        if (chip_.cycle() >= limit) chip_.throw_budget_exceeded(longest);
        if (const auto found = lane_at_.find(chip_.program_counter());
            found != lane_at_.end() && !runs[found->second]) {
            open.push_back({found->second, chip_.cycle() - call_cycles, chip_.stack_pointer()});
            runs[found->second] = true;
        }
        chip_.step();
        while (!open.empty() && chip_.stack_pointer() > open.back().stack_pointer) {
            calls.push_back({open.back().lane, open.back().begin, chip_.cycle()});
            runs[open.back().lane] = false;
            open.pop_back();
        }
    }
    return calls;
}

}  // namespace scene_bench
