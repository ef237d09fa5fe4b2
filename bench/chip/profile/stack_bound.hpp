// SPDX-License-Identifier: GPL-3.0-or-later
// The maximum depth of a program's stack, from its machine code alone: each function's instructions
// are followed along every path with the depth of the stack, and calls along the call graph.
//
// Assumptions: a `jmp __tablejump2__` is a switch and stays in its function; a handler that enables
// interrupts is not interrupted by itself (`interruptible` lists them). What cannot be bounded is
// named: indirect calls and jumps, recursion, a stack pointer set to a computed value (alloca,
// longjmp).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/chip/simulator/elf.hpp"

namespace profile {

struct FunctionBound {
    std::string name;
    std::optional<unsigned> frame_bytes;  // including the return address, without its callees
    std::optional<unsigned> stack_bytes;  // with its callees; both are empty if unbounded
    std::string unbounded;                // the first reason, e.g. "indirect call in main+6"
    bool enables_interrupts = false;      // it, or what it calls, executes `sei`
};

struct StackBound {
    std::optional<unsigned> bytes;        // of the whole program; empty if unbounded
    std::vector<std::string> path;        // the deepest calls from main() or a constructor
    unsigned path_bytes = 0;              // bytes of this path, if bounded
    std::vector<std::string> interrupts;  // the deepest handlers that can be on the stack together
    unsigned interrupt_bytes = 0;         // bytes of these, if bounded
    std::vector<std::string> interruptible;  // handlers that must not be interrupted by themselves
    std::vector<std::string> unbounded;      // reasons; empty if bounded
    std::vector<FunctionBound> functions;    // all that are reachable, by name
};

// Throws simulator::ElfError for a program without main().
StackBound static_stack_bound(const simulator::Elf& elf);

}  // namespace profile
