// SPDX-License-Identifier: GPL-3.0-or-later
// Which parts of a program run when: calls of functions, found by watching the program counter and
// the stack pointer, which changes nothing in the program.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "bench/chip/simulator/chip.hpp"

namespace scene_bench {

// A part of a program: the functions whose symbols begin with one of the prefixes. A function that
// is called while another of its lane runs is part of that one.
struct Lane {
    std::string name;
    std::vector<std::string> prefixes;
};

struct Call {
    std::size_t lane;
    simulator::Cycle begin, end;  // `call` (4 cycles) and `ret` included
};

class CallTrace {
  public:
    CallTrace(simulator::Chip& chip, const std::vector<Lane>& lanes);

    // The chip stands at a function's first instruction: runs to its return; the calls meanwhile,
    // by their ends.
    std::vector<Call> run_function();

  private:
    simulator::Chip& chip_;
    std::size_t lanes_;
    std::unordered_map<std::uint32_t, std::size_t> lane_at_;  // by the address of a function
};

}  // namespace scene_bench
