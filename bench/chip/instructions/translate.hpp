// SPDX-License-Identifier: GPL-3.0-or-later
// Translates a function of a device program, instruction by instruction, to C++ with the same
// effect on registers, flags, memory and cycle count.
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

// The message names the address and the opcode.
class TranslationError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// The function's instructions, in the order in which a walk along its control flow reaches them.
// That order does not depend on where the linker put the parts.
struct ControlFlow {
    std::vector<Instruction> instructions;
    // Instructions that start a block: every other one is executed whenever its predecessor is.
    std::set<std::uint32_t> leaders;

    // The possible successors of an instruction within the function; of a call, its target.
    static std::vector<std::uint32_t> successors(const Instruction& instruction,
                                                 std::span<const std::uint8_t> flash);
};

ControlFlow control_flow(const simulator::Elf& elf, std::string_view symbol);

// Where the operands and results of a function are, in the order of the caller's raws.
struct Interface {
    std::vector<simulator::Place> operands, results;
    struct Pointer {
        simulator::Place place;
        std::uint16_t value;
    };
    std::vector<Pointer> pointers;  // operands that point to raws
    simulator::Place operand_area, result_area;
    std::uint16_t entry_stack_pointer;
};

// For a function that takes and returns plain numbers.
Interface interface_of(const simulator::Signature& signature);

// For a function that takes `vectors` pointers to arrays of `elements` raws each, or stores
// `results` raws through a pointer that comes last. 0 of either: by value, according to
// `signature`, in which the pointers count as operands.
struct Pointers {
    std::size_t vectors, elements;
    int element_size;
    std::size_t results;
    int result_size;
};
Interface interface_of(const simulator::Signature& signature, const Pointers& pointers);

// For a function that takes and returns nothing and works on the variables of the program.
Interface interface_of_variables(const simulator::Elf& elf);

struct Translation {
    std::string source;
    std::vector<std::uint32_t> leaders;  // the block that each byte of the coverage belongs to
};

// Throws TranslationError if a function of plain numbers must not use one of the instructions, if
// control flow depends on data (ijmp, icall), or if calls nest too deep (recursion).
//
// The source defines a function `instructions_run` of type Run (compiled_function.hpp) with C
// linkage.
Translation translate(const simulator::Elf& elf, std::string_view symbol,
                      const Interface& interface);

}  // namespace instructions
