// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/table_3_2/harness.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <map>

namespace table_3_2 {

namespace {

// Twice the most expensive pass, that of the square root at -O0.
constexpr simulator::Cycle pass_budget = 30'000;

int bytes_of(const std::string& type) {
    if (type == "int64_t") return 8;
    return type == "int16_t" || type == "fixed_8_8" ? 2 : 4;
}

std::uint64_t bits_of(const std::string& type, double integer, double real, bool raw) {
    if (type == "float") return std::bit_cast<std::uint32_t>(static_cast<float>(real));
    double value = integer;
    if (type.starts_with("fixed") && !raw) {
        value = std::trunc(std::ldexp(real, type == "fixed_8_8" ? 8 : 16));
    }
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(value));
}

// The backward branches of a function, the one that spans the most code first.
std::vector<std::uint32_t> back_edges(const std::vector<std::uint8_t>& flash,
                                      const simulator::Symbol& cell) {
    std::multimap<int, std::uint32_t> edges;
    for (std::uint32_t at = cell.address; at < cell.address + cell.size; at += 2) {
        const int word = flash[at] | flash[at + 1] << 8;
        int distance = 0;
        if ((word & 0xf800) == 0xf000) {  // brbs, brbc: 7 bits
            distance = static_cast<std::int8_t>((word >> 2) & 0xfe);
        } else if ((word & 0xf000) == 0xc000) {  // rjmp: 12 bits
            distance = static_cast<std::int16_t>(word << 4) >> 3;
        }
        const bool inside = static_cast<int>(at - cell.address) + 2 + distance >= 0;
        if (inside && distance < 0) edges.emplace(distance, at);
    }
    std::vector<std::uint32_t> longest_first;
    for (const auto& [distance, at] : edges) longest_first.push_back(at);
    return longest_first;
}

}  // namespace

std::string Operands::name() const {
    return fmt::format("{:.0f} and {:.0f}{} {:g} and {:g}", integer.a, integer.b,
                       raw ? " raw; float" : "; real", real.a, real.b);
}

double undisturbed_ms(double cycles) {
    return cycles * Harness::iterations * 1000 / simulator::Chip::frequency;
}

Harness::Harness(const std::filesystem::path& program) : chip_(simulator::Elf(program)) {}

void Harness::write(const std::string& object, std::uint64_t bits, int bytes) {
    std::uint8_t little_endian[8];
    for (int i = 0; i < bytes; ++i) little_endian[i] = static_cast<std::uint8_t>(bits >> (8 * i));
    chip_.write(static_cast<std::uint16_t>(chip_.elf().object(object).address),
                {little_endian, static_cast<std::size_t>(bytes)});
}

const simulator::Symbol& Harness::prepare(const std::string& form, const Cell& cell,
                                          const Operands& operands) {
    chip_.reset();
    chip_.run_until_function("main");
    const Operands& o = operands;
    const int bytes = bytes_of(cell.type);
    write(cell.type + "_a", bits_of(cell.type, o.integer.a, o.real.a, o.raw), bytes);
    write(cell.type + "_b", bits_of(cell.type, o.integer.b, o.real.b, o.raw), bytes);
    write(cell.type + "_c", 0, bytes);
    return chip_.elf().function(fmt::format("cell_{}_{}_{}", form, cell.type, cell.operation));
}

double Harness::cycles(const std::string& form, const Cell& cell, const Operands& operands,
                       int passes) {
    const simulator::Symbol& symbol = prepare(form, cell, operands);
    // The longest backward branch that each pass takes closes the loop, or lies in a block that the
    // compiler moved behind it; either is executed once per pass. Longer ones may be on paths that
    // these operands do not take.
    for (const std::uint32_t edge : back_edges(chip_.elf().flash(), symbol)) {
        prepare(form, cell, operands);
        chip_.set_program_counter(symbol.address);
        if (!reaches(edge)) continue;
        const simulator::Cycle start = chip_.cycle();
        int pass = 0;
        while (pass < passes && (chip_.step(), reaches(edge))) ++pass;
        if (pass == passes) return static_cast<double>(chip_.cycle() - start) / passes;
    }
    throw simulator::SimulationError(symbol.name + ": no loop found");
}

bool Harness::reaches(std::uint32_t address) {
    const simulator::Cycle limit = chip_.cycle() + pass_budget;
    while (chip_.program_counter() != address && chip_.cycle() < limit) chip_.step();
    return chip_.program_counter() == address;
}

std::uint32_t Harness::milliseconds(const std::string& form, const Cell& cell,
                                    const Operands& operands) {
    const simulator::Symbol& symbol = prepare(form, cell, operands);
    write("timed_cell", symbol.address / 2, 2);
    // In bursts of a millisecond, which is ten times faster than examining each instruction.
    const simulator::Symbol& finished = chip_.elf().function("finished");
    const simulator::Cycle limit = simulator::Chip::default_budget;
    while (chip_.program_counter() - finished.address >= finished.size) {
        if (chip_.cycle() > limit) chip_.throw_budget_exceeded(limit);
        chip_.run_until_cycle(chip_.cycle() + simulator::Chip::frequency / 1000);
    }
    std::uint32_t elapsed = 0;
    std::uint8_t bytes[4];
    chip_.read(static_cast<std::uint16_t>(chip_.elf().object("elapsed_ms").address), bytes);
    for (int i = 3; i >= 0; --i) elapsed = elapsed << 8 | bytes[i];
    return elapsed;
}

}  // namespace table_3_2
