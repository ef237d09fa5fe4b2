// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/instructions/fingerprint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace instructions {
namespace {

// The table in flash that contains an address.
const simulator::Symbol* table_at(const simulator::Elf& elf, std::uint32_t address) {
    for (const simulator::Symbol& table : elf.flash_objects())
        if (table.address <= address && address < table.address + table.size) return &table;
    return nullptr;
}

}  // namespace

std::string fingerprint(const simulator::Elf& elf, std::string_view symbol) {
    if (elf.relocations().empty())
        throw TranslationError(fmt::format(
            "{}: linked without --emit-relocs, so that a function's tables are not known",
            elf.path().string()));
    const ControlFlow flow = control_flow(elf, symbol);
    std::map<std::uint32_t, std::size_t> ordinal;
    for (const Instruction& instruction : flow.instructions)
        ordinal.emplace(instruction.address, ordinal.size());
    std::vector<const simulator::Symbol*> tables;
    const auto ordinal_of_table = [&](const simulator::Symbol* table) {
        const auto index = std::find(tables.begin(), tables.end(), table) - tables.begin();
        if (index == std::ssize(tables)) tables.push_back(table);
        return index;
    };

    std::string text;
    for (const Instruction& instruction : flow.instructions) {
        text += instruction.row->mnemonic;
        if (instruction.row->flow != Flow::next) {
            // The operands of a skip are its register and bit; of the others, the target.
            if (instruction.row->flow == Flow::skip) text += instruction.text();
            for (const std::uint32_t address : ControlFlow::successors(instruction, elf.flash()))
                text += fmt::format(" {}", ordinal.at(address));
        } else if (const auto found = elf.relocations().find(instruction.address);
                   found != elf.relocations().end()) {
            const auto& [type, target] = found->second;
            const simulator::Symbol* const table = table_at(elf, target);
            if (!table)
                throw TranslationError(fmt::format("{}: {}: 0x{:x} is no table's address",
                                                   elf.describe(instruction.address),
                                                   instruction.text(), target));
            text += fmt::format(" r{} table {} relocation {} offset {}", instruction.d,
                                ordinal_of_table(table), type, target - table->address);
        } else {
            text += ' ' + instruction.text();
        }
        text += '\n';
    }
    for (const simulator::Symbol* table : tables)
        text.append(elf.flash().begin() + table->address,
                    elf.flash().begin() + table->address + table->size);
    return simulator::sha256_of({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace instructions
