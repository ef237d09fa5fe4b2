// SPDX-License-Identifier: GPL-3.0-or-later
// When the parts of a program run: calls of functions, found by watching the program counter and
// the stack pointer, which changes nothing in the program.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "bench/chip/simulator/chip.hpp"

namespace scene_bench {

// A part of a program: the functions whose symbols start with one of the prefixes. A function that
// is called while another of its lane runs belongs to that call.
struct Lane {
    std::string name;
    std::vector<std::string> prefixes;
};

struct Call {
    std::size_t lane;
    simulator::Cycle begin, end;  // including `call` (4 cycles) and `ret`
};

class CallTrace {
  public:
    CallTrace(simulator::Chip& chip, const std::vector<Lane>& lanes);

    // The chip must be at a function's first instruction. Runs to its return and returns the calls
    // made meanwhile, in order of their ends.
    std::vector<Call> run_function();

  private:
    simulator::Chip& chip_;
    std::size_t lanes_;
    std::unordered_map<std::uint32_t, std::size_t> lane_at_;  // by the address of a function
};

}  // namespace scene_bench
