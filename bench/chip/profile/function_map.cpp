// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/profile/function_map.hpp"

#include <cxxabi.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <map>
#include <memory>
#include <tuple>

#include "bench/chip/instructions/instruction.hpp"

namespace profile {
namespace {

using simulator::Symbol;

// ATmega328P data sheet, "Interrupt Vectors".
constexpr std::array<std::string_view, vector_count> vector_names = {
    "RESET",
    "INT0_vect",
    "INT1_vect",
    "PCINT0_vect",
    "PCINT1_vect",
    "PCINT2_vect",
    "WDT_vect",
    "TIMER2_COMPA_vect",
    "TIMER2_COMPB_vect",
    "TIMER2_OVF_vect",
    "TIMER1_CAPT_vect",
    "TIMER1_COMPA_vect",
    "TIMER1_COMPB_vect",
    "TIMER1_OVF_vect",
    "TIMER0_COMPA_vect",
    "TIMER0_COMPB_vect",
    "TIMER0_OVF_vect",
    "SPI_STC_vect",
    "USART_RX_vect",
    "USART_UDRE_vect",
    "USART_TX_vect",
    "ADC_vect",
    "EE_READY_vect",
    "ANALOG_COMP_vect",
    "TWI_vect",
    "SPM_READY_vect",
};
constexpr std::uint32_t vector_bytes = 4;
constexpr std::string_view vector_prefix = "__vector_";

// Labels of the C run-time's sections .vectors and .init0 to .init9.
bool is_start_up(const Symbol& symbol) {
    static constexpr std::string_view labels[] = {
        "__init",      "__ctors_start",     "__ctors_end",         "__dtors_start",
        "__dtors_end", "__do_copy_data",    "__do_clear_bss",      "__do_global_ctors",
        "__vectors",   "__do_global_dtors", "__trampolines_start", "__trampolines_end"};
    return symbol.address == 0 || std::ranges::find(labels, symbol.name) != std::end(labels);
}

// Of several names of one address, prefers the one that the program's author gave it. Unused
// vectors are all names of __bad_interrupt.
auto rank(const Symbol& symbol) {
    return std::tuple(symbol.name.starts_with(vector_prefix), symbol.name.starts_with('_'),
                      symbol.name);
}

std::string readable(const std::string& symbol) {
    if (symbol.starts_with(vector_prefix)) {
        int vector = 0;
        const char* const end = symbol.data() + symbol.size();
        const auto [rest, error] =
            std::from_chars(symbol.data() + vector_prefix.size(), end, vector);
        if (error == std::errc() && rest == end && vector > 0 && vector < vector_count)
            return std::string(vector_name(vector));
    }
    const std::unique_ptr<char, decltype(&std::free)> demangled(
        abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, nullptr), &std::free);
    return demangled ? demangled.get() : symbol;
}

// A label without a size that is not inside a function extends to the next label. So does a label
// of the start-up code, whose sections follow each other without further labels.
std::vector<Symbol> code_symbols(const simulator::Elf& elf) {
    std::map<std::uint32_t, Symbol> by_address;
    for (const auto& [name, symbol] : elf.functions()) {
        // The linker's absolute symbols for the sizes of memory regions look like labels.
        if (symbol.address % 2 || name.ends_with("_REGION_LENGTH__")) continue;
        const auto [at, is_new] = by_address.try_emplace(symbol.address, symbol);
        if (!is_new && rank(symbol) < rank(at->second)) at->second = symbol;
    }
    std::vector<Symbol> symbols;
    std::uint32_t covered = 0;
    for (const auto& [address, symbol] : by_address) {
        if (symbol.size == 0 && address < covered) continue;
        covered = std::max(covered, address + symbol.size);
        symbols.push_back(symbol);
    }
    const auto code_end = static_cast<std::uint32_t>(elf.flash().size());
    for (std::size_t i = 0; i < symbols.size(); ++i) {
        if (symbols[i].size && !is_start_up(symbols[i])) continue;
        const std::uint32_t end = i + 1 < symbols.size() ? symbols[i + 1].address : code_end;
        symbols[i].size = end - symbols[i].address;
    }
    return symbols;
}

}  // namespace

std::string_view vector_name(int vector) {
    return vector_names.at(static_cast<std::size_t>(vector));
}

FunctionMap::FunctionMap(const simulator::Elf& elf)
    : functions_{{"", "(no symbol)", 0}, {"", "(asleep)", 0}, {"", "(start-up)", 0}},
      by_word_(simulator::Elf::flash_size / 2, unnamed) {
    for (const Symbol& symbol : code_symbols(elf)) {
        Index index = start_up;
        if (!is_start_up(symbol)) {
            index = static_cast<Index>(functions_.size());
            functions_.push_back({symbol.name, readable(symbol.name), symbol.address});
        }
        const std::uint32_t end =
            std::min(symbol.address + symbol.size, simulator::Elf::flash_size);
        for (std::uint32_t at = symbol.address; at < end; at += 2) by_word_[at / 2] = index;
    }
    for (int vector = 0; vector < vector_count; ++vector) {
        const std::uint32_t slot = static_cast<std::uint32_t>(vector) * vector_bytes;
        handlers_.push_back(slot);
        if (slot + vector_bytes > elf.flash().size()) continue;
        const instructions::Instruction entry = instructions::decode(elf.flash(), slot);
        if (entry.row && entry.row->flow == instructions::Flow::jump)
            handlers_.back() = entry.target() % simulator::Elf::flash_size;
    }
}

std::string FunctionMap::describe(std::uint32_t flash_address) const {
    const Index index = at(flash_address);
    if (index <= start_up) return fmt::format("{} 0x{:04x}", functions_[index].name, flash_address);
    const Function& function = functions_[index];
    if (flash_address == function.address) return function.name;
    return fmt::format("{}+{}", function.name, flash_address - function.address);
}

}  // namespace profile
