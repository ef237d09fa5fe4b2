// SPDX-License-Identifier: GPL-3.0-or-later
// How deep a program's stack can get at most, from its machine code alone: each function's
// instructions are followed along every path with the depth of the stack, calls along the call
// graph.
//
// What it takes for granted: a `jmp __tablejump2__` is a switch and stays in its function; no
// handler that enables interrupts is interrupted by itself (`interruptible` names them). What it
// cannot bound it names: indirect calls and jumps, recursion, a stack pointer set to a computed
// value (alloca, longjmp).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/chip/simulator/elf.hpp"

namespace profile {

struct FunctionBound {
    std::string name;
    std::optional<unsigned> frame_bytes;  // return address included, without what it calls
    std::optional<unsigned> stack_bytes;  // with what it calls; both none where unbounded
    std::string unbounded;                // the first reason, e.g. "indirect call in main+6"
    bool enables_interrupts = false;      // it, or what it calls, executes `sei`
};

struct StackBound {
    std::optional<unsigned> bytes;        // the whole program's; none where unbounded
    std::vector<std::string> path;        // the deepest calls from main() or a constructor
    unsigned path_bytes = 0;              // of it, where bounded
    std::vector<std::string> interrupts;  // the deepest handlers that can be on the stack at once
    unsigned interrupt_bytes = 0;         // of these, where bounded
    std::vector<std::string> interruptible;  // handlers that must not be interrupted by themselves
    std::vector<std::string> unbounded;      // reasons, empty where bounded
    std::vector<FunctionBound> functions;    // all that can be reached, by name
};

// Throws simulator::ElfError for a program without main().
StackBound static_stack_bound(const simulator::Elf& elf);

}  // namespace profile
