// SPDX-License-Identifier: GPL-3.0-or-later
// Translates a function of a device program, instruction by instruction, to C++ that does the same
// to registers, flags, memory and cycle count.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "bench/chip/instructions/convention.hpp"
#include "bench/chip/instructions/instruction.hpp"
#include "bench/chip/simulator/elf.hpp"

namespace machine_code {

// Names the address and the opcode.
class TranslationError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// The function's instructions, in the order in which a walk along its control flow meets them: that
// order does not depend on where the linker put the parts.
struct ControlFlow {
    std::vector<Instruction> instructions;
    // Instructions that begin a block: each other one is executed whenever the one before it is.
    std::set<std::uint32_t> leaders;

    // What an instruction may be followed by within the function; calls by their target.
    static std::vector<std::uint32_t> successors(const Instruction& instruction,
                                                 std::span<const std::uint8_t> flash);
};

ControlFlow control_flow(const simulator::Elf& elf, std::string_view symbol);

struct Translation {
    std::string source;
    std::vector<std::uint32_t> leaders;  // the block that each byte of the coverage stands for
};

// Throws TranslationError where an instruction is not one that a function of plain numbers may use,
// control flow depends on data (ijmp, icall), or calls nest too deep (recursion).
//
// The source defines, with C linkage, a function of type Run (compiled_function.hpp) named
// `machine_code_run`.
Translation translate(const simulator::Elf& elf, std::string_view symbol,
                      const Convention& convention);

}  // namespace machine_code
