// SPDX-License-Identifier: GPL-3.0-or-later
// The instruction set of the AVR, one row per instruction: its bits, its assembler text, its effect
// as a C++ statement, its cycles. Decoding, disassembly and translation all use these rows.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace instructions {

// Where control flow goes after an instruction.
enum class Flow {
    next,         // to the next instruction
    branch,       // to `target` if `statement` is true, else to the next; taken, one cycle more
    skip,         // over the next instruction if `statement` is true; a cycle more per word
    jump,         // to `target`
    call,         // to `target`, then back to the next
    ret,          // back to the caller
    unsupported,  // not in an ATmega328P, or not allowed in a function of plain numbers
};

struct InstructionRow {
    // Sixteen characters, most significant bit first: 0, 1, or the letter of a field.
    //   d, r  register (5 letters: r0..r31; 4: r16..r31; 3: r16..r23; 2: r24, r26, r28, r30)
    //   D, R  register pair (4 letters: r1:r0 .. r31:r30)
    //   K q A b  constant, displacement, I/O address, bit
    //   k     words from the next instruction, signed
    //   h     upper bits of a word address whose lower 16 bits are the second word
    std::string_view pattern;
    std::string_view mnemonic;
    std::string_view operands;  // as avr-objdump prints them, with {field}
    Flow flow;
    int cycles;                  // on the ATmega328P; of a branch or skip, when not taken
    std::string_view statement;  // C++ over semantics.hpp; for branch and skip, a condition
    bool two_words = false;
};

std::span<const InstructionRow> instruction_set();

struct Instruction {
    std::uint32_t address = 0;  // flash byte address
    std::uint16_t opcode = 0, second_word = 0;
    const InstructionRow* row = nullptr;  // null if the opcode is not an instruction

    // Fields; registers as numbers, pairs as the lower number.
    int d = 0, r = 0, K = 0, q = 0, A = 0, b = 0, k = 0, h = 0;

    std::uint32_t size() const { return row && row->two_words ? 4 : 2; }
    std::uint32_t next() const { return address + size(); }
    std::uint32_t target() const;  // of a branch, jump or call
    std::uint32_t absolute() const { return std::uint32_t(h) << 16 | second_word; }

    std::string text() const;       // "adiw r24, 0x01", as avr-objdump prints it
    std::string statement() const;  // the row's statement with the fields filled in
};

// The instruction at a flash byte address. Throws std::out_of_range if the flash ends before it
// does.
Instruction decode(std::span<const std::uint8_t> flash, std::uint32_t address);

}  // namespace instructions
