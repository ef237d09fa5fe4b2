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

#include "bench/chip/instructions/instruction.hpp"
#include "bench/chip/simulator/convention.hpp"
#include "bench/chip/simulator/elf.hpp"

namespace instructions {

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

// Where a function's numbers lie as it is called, in the order of the caller's raws.
struct Interface {
    std::vector<simulator::Place> operands, results;
    struct Pointer {
        simulator::Place place;
        std::uint16_t value;
    };
    std::vector<Pointer> pointers;  // operands that say where the raws lie
    simulator::Place operand_area, result_area;
    std::uint16_t entry_stack_pointer;
};

// Of a function that takes and returns plain numbers.
Interface interface_of(const simulator::Signature& signature);

// Of a function that takes `vectors` pointers to arrays of `elements` raws each, or that leaves
// `results` raws through a pointer that comes last; 0 of either: by value, as `signature` has it,
// in which the pointers stand as operands.
struct Pointers {
    std::size_t vectors, elements;
    int element_size;
    std::size_t results;
    int result_size;
};
Interface interface_of(const simulator::Signature& signature, const Pointers& pointers);

// Of a function that takes and returns nothing, and works on the program's variables.
Interface interface_of_variables(const simulator::Elf& elf);

struct Translation {
    std::string source;
    std::vector<std::uint32_t> leaders;  // the block that each byte of the coverage stands for
};

// Throws TranslationError where an instruction is not one that a function of plain numbers may use,
// control flow depends on data (ijmp, icall), or calls nest too deep (recursion).
//
// The source defines, with C linkage, a function of type Run (compiled_function.hpp) named
// `instructions_run`.
Translation translate(const simulator::Elf& elf, std::string_view symbol,
                      const Interface& interface);

}  // namespace instructions
