// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/instructions/translate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "bench/chip/simulator/chip.hpp"

namespace instructions {
namespace {

// Both areas cross a 256-byte page boundary, where a pointer's low byte wraps.
constexpr std::uint16_t operand_area = 0x01f9, result_area = 0x02fb;

constexpr std::size_t deepest_call = 16, max_states = 100000;
constexpr int budget = 1'000'000;  // cycles

[[noreturn]] void fail(const simulator::Elf& elf, const Instruction& at, std::string_view why) {
    throw TranslationError(fmt::format("{}: 0x{:04x}: opcode 0x{:04x}, {}: {}",
                                       elf.describe(at.address), at.address, at.opcode, at.text(),
                                       why));
}

// ld and st that change the pointer register they load or store: the manual leaves the result
// undefined.
bool moves_its_own_pointer(const Instruction& instruction) {
    if ((instruction.opcode & 0xfc00) != 0x9000 || instruction.row->two_words) return false;
    const int mode = instruction.opcode & 15, number = instruction.opcode >> 4 & 31;
    const bool z = mode == 1 || mode == 2 || mode == 5, y = mode == 9 || mode == 10,
               x = mode == 13 || mode == 14;
    return (x && number / 2 == 13) || (y && number / 2 == 14) || (z && number / 2 == 15);
}

bool is_other_io(const Instruction& instruction) {
    const std::string_view mnemonic = instruction.row->mnemonic;
    return (mnemonic == "in" || mnemonic == "out") && instruction.A < 0x3d;
}

// `rcall .+0`, with which avr-gcc reserves two bytes of stack.
bool only_pushes(const Instruction& instruction) {
    return instruction.row->flow == Flow::call && instruction.target() == instruction.next();
}

Instruction decode_usable(const simulator::Elf& elf, std::uint32_t address) {
    Instruction instruction;
    try {
        instruction = decode(elf.flash(), address);
    } catch (const std::out_of_range& error) {
        throw TranslationError(fmt::format("control flow leaves the program: {}", error.what()));
    }
    if (!instruction.row) fail(elf, instruction, "no such instruction");
    if (instruction.row->flow == Flow::unsupported)
        fail(elf, instruction, "not an instruction that a function of plain numbers may use");
    if (is_other_io(instruction)) fail(elf, instruction, "only SPL, SPH and SREG may be used");
    if (moves_its_own_pointer(instruction)) fail(elf, instruction, "its outcome is undefined");
    return instruction;
}

std::vector<int> call_saved() {
    std::vector<int> numbers;
    for (int i = 0; i < 32; ++i)
        if (simulator::is_call_saved(i)) numbers.push_back(i);
    return numbers;
}

std::vector<simulator::Place> array_at(std::uint16_t address, std::size_t count, int size) {
    std::vector<simulator::Place> places;
    for (std::size_t i = 0; i < count; ++i)
        places.push_back({std::uint16_t(address + int(i) * size), size});
    return places;
}

// An instruction and the calls that led to it, each by its return address.
struct State {
    std::vector<std::uint32_t> calls;
    std::uint32_t address;
    auto operator<=>(const State&) const = default;
};

class Translator {
  public:
    Translator(const simulator::Elf& elf, std::string_view symbol, const Interface& interface)
        : elf_(elf),
          entry_(elf.function(symbol).address),
          interface_(interface),
          flow_(control_flow(elf, symbol)) {
        for (const Instruction& instruction : flow_.instructions)
            instructions_.emplace(instruction.address, instruction);
        for (const std::uint32_t leader : flow_.leaders) {
            block_of_.emplace(leader, leaders_.size());
            leaders_.push_back(leader);
        }
    }

    Translation run() {
        find_blocks();
        begin();
        for (std::size_t i = 0; i < blocks_.size(); ++i) emit_block(i);
        end();
        return {std::move(source_), std::move(leaders_)};
    }

  private:
    template <class... Arguments>
    void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        source_ += fmt::format(format, std::forward<Arguments>(arguments)...);
        source_ += '\n';
    }

    // Blocks are numbered when they are first referred to, and each is emitted once.
    std::size_t label(const State& state) {
        const auto [place, fresh] = labels_.emplace(state, blocks_.size());
        if (fresh) {
            if (blocks_.size() == max_states)
                throw TranslationError(fmt::format("{}: too many paths of calls to translate",
                                                   elf_.describe(state.address)));
            blocks_.push_back(state);
        }
        return place->second;
    }
    void find_blocks() { label({{}, entry_}); }

    void go_to(const State& state, std::uint32_t from) {
        if (state.address <= from)
            line("  if (cycles > {}) throw Fault{{\"does not return, at address\", 0x{:x}}};",
                 budget, from);
        line("  goto block{};", label(state));
    }

    void emit_block(std::size_t number) {
        const State begin = blocks_[number];
        line("block{}: covered[{}] = 1;", number, block_of_.at(begin.address));
        int cycles = 0;
        for (std::uint32_t address = begin.address;;) {
            const Instruction& instruction = instructions_.at(address);
            line("  // {:04x} {}", address, instruction.text());
            cycles += instruction.row->cycles;
            const bool ends = emit(instruction, begin.calls, cycles);
            if (ends) return;
            address = instruction.next();
            if (flow_.leaders.contains(address)) {
                line("  cycles += {};", cycles);
                line("  goto block{};", label({begin.calls, address}));
                return;
            }
        }
    }

    // Emits the instruction. Returns whether it ends the block.
    bool emit(const Instruction& instruction, const std::vector<std::uint32_t>& calls, int cycles) {
        const std::uint32_t next = instruction.next();
        const InstructionRow& row = *instruction.row;
        switch (row.flow) {
            case Flow::next:
                if (!row.statement.empty()) line("  {};", instruction.statement());
                return false;
            case Flow::branch:
                line("  cycles += {};", cycles);
                line("  if ({}) {{ ++cycles;", instruction.statement());
                go_to({calls, instruction.target()}, instruction.address);
                line("  }}");
                line("  goto block{};", label({calls, next}));
                return true;
            case Flow::skip: {
                const Instruction skipped = instructions_.at(next);
                line("  cycles += {};", cycles);
                line("  if ({}) {{ cycles += {};", instruction.statement(), skipped.size() / 2);
                line("  goto block{}; }}", label({calls, skipped.next()}));
                line("  goto block{};", label({calls, next}));
                return true;
            }
            case Flow::jump:
                line("  cycles += {};", cycles);
                go_to({calls, instruction.target()}, instruction.address);
                return true;
            case Flow::call: {
                line("  m.push_address(0x{:x});", next / 2);
                if (only_pushes(instruction)) return false;
                if (calls.size() == deepest_call) fail(elf_, instruction, "calls nest too deep");
                line("  cycles += {};", cycles);
                std::vector<std::uint32_t> inner = calls;
                inner.push_back(next);
                line("  goto block{};", label({inner, instruction.target()}));
                return true;
            }
            case Flow::ret: {
                line("  cycles += {};", cycles);
                if (calls.empty()) {
                    line("  goto returned;");
                    return true;
                }
                line("  m.return_to(0x{:x});", calls.back() / 2);
                std::vector<std::uint32_t> outer = calls;
                outer.pop_back();
                line("  goto block{};", label({outer, calls.back()}));
                return true;
            }
            case Flow::unsupported:
                break;
        }
        fail(elf_, instruction, "cannot be translated");
    }

    void begin() {
        const simulator::Place &in = interface_.operand_area, &out = interface_.result_area;
        line("#include \"bench/chip/instructions/semantics.hpp\"");
        line("using namespace instructions::semantics;");
        line("using Area = Memory<{}, {}, {}, {}, {}>;", in.address, in.end(), out.address,
             out.end(), simulator::Chip::ram_end);
        line(
            "static inline __attribute__((always_inline)) unsigned call(const std::int64_t* "
            "operands,"
            " std::int64_t* results, Area m, const Byte* __restrict flash, Byte* __restrict "
            "covered,"
            " std::uint64_t pattern) {{");
        for (int i = 0; i < 32; ++i) line("  Byte r{} = unspecified(pattern, {});", i, i);
        line("  r1 = 0;");
        line("  Status f;");
        line("  unsigned cycles = {};", simulator::call_cycles);
        for (std::size_t i = 0; i < interface_.operands.size(); ++i) {
            const simulator::Place& place = interface_.operands[i];
            for (int byte = 0; byte < place.size; ++byte)
                line("  {} = Byte(operands[{}] >> {});", name_of(place.address + byte), i,
                     8 * byte);
        }
        for (const auto& [place, value] : interface_.pointers) {
            line("  r{} = {};", place.address, value & 0xff);
            line("  r{} = {};", place.address + 1, value >> 8);
        }
        for (const int i : call_saved()) line("  const Byte entry{0} = r{0};", i);
        // Unspecified results, in case a function forgets to write them.
        for (const simulator::Place& place : interface_.results)
            if (!place.in_registers())
                for (int byte = 0; byte < place.size; ++byte)
                    line("  {} = unspecified(pattern, {});", name_of(place.address + byte), byte);
    }

    void end() {
        line("returned:");
        line("  if (m.sp != {}) throw Fault{{\"leaves the stack pointer unbalanced at\", m.sp}};",
             interface_.entry_stack_pointer);
        line("  if (r1) throw Fault{{\"does not leave zero in r1 but\", r1}};");
        line("  if (f.i) throw Fault{{\"leaves interrupts on, flag\", f.i}};");
        for (const int i : call_saved())
            line("  if (r{0} != entry{0}) throw Fault{{\"changes call-saved register\", {0}}};", i);
        for (std::size_t i = 0; i < interface_.results.size(); ++i) {
            const simulator::Place& place = interface_.results[i];
            line("  results[{}] = 0;", i);
            for (int byte = 0; byte < place.size; ++byte)
                line("  results[{}] |= std::int64_t(std::uint64_t({}) << {});", i,
                     name_of(place.address + byte), 8 * byte);
            const int excess = 64 - 8 * place.size;
            line("  results[{0}] = std::int64_t(std::uint64_t(results[{0}]) << {1}) >> {1};", i,
                 excess);
        }
        line("  return cycles;\n}}");
        line(
            R"(extern "C" std::size_t instructions_run(const std::int64_t* operands, std::size_t count,
    std::int64_t* __restrict results, std::uint32_t* __restrict cycles, Byte* memory,
    const Byte* flash, Byte* covered, std::uint64_t pattern, const char** what, unsigned* where) {{
  std::size_t i = 0;
  try {{
    for (; i < count; ++i) {{
      cycles[i] = call(operands + {} * i, results + {} * i, Area{{memory, {}}}, flash, covered, pattern);
      pattern = pattern * 6364136223846793005u + 1442695040888963407u;
    }}
  }} catch (const Fault& fault) {{
    *what = fault.what;
    *where = fault.where;
  }}
  return i;
}})",
            interface_.operands.size(), interface_.results.size(), interface_.entry_stack_pointer);
    }

    static std::string name_of(int address) {
        return address < 32 ? fmt::format("r{}", address) : fmt::format("m.bytes[{}]", address);
    }

    const simulator::Elf& elf_;
    std::uint32_t entry_;
    const Interface& interface_;
    ControlFlow flow_;
    std::map<std::uint32_t, Instruction> instructions_;
    std::map<std::uint32_t, std::size_t> block_of_;
    std::vector<std::uint32_t> leaders_;
    std::map<State, std::size_t> labels_;
    std::vector<State> blocks_;
    std::string source_;
};

}  // namespace

std::vector<std::uint32_t> ControlFlow::successors(const Instruction& instruction,
                                                   std::span<const std::uint8_t> flash) {
    switch (instruction.row->flow) {
        case Flow::branch:
            return {instruction.next(), instruction.target()};
        case Flow::skip:
            return {instruction.next(), decode(flash, instruction.next()).next()};
        case Flow::jump:
            return {instruction.target()};
        case Flow::call:
            return {instruction.next(), instruction.target()};
        case Flow::ret:
            return {};
        default:
            return {instruction.next()};
    }
}

ControlFlow control_flow(const simulator::Elf& elf, std::string_view symbol) {
    ControlFlow flow;
    const std::uint32_t entry = elf.function(symbol).address;
    flow.leaders.insert(entry);
    std::set<std::uint32_t> met;
    std::vector<std::uint32_t> open = {entry};
    while (!open.empty()) {
        const std::uint32_t address = open.back();
        open.pop_back();
        if (!met.insert(address).second) continue;
        const Instruction instruction = decode_usable(elf, address);
        flow.instructions.push_back(instruction);
        const auto successors = ControlFlow::successors(instruction, elf.flash());
        const bool falls_through = instruction.row->flow == Flow::next || only_pushes(instruction);
        if (!falls_through) flow.leaders.insert(successors.begin(), successors.end());
        // The next instruction is popped first.
        open.insert(open.end(), successors.rbegin(), successors.rend());
    }
    return flow;
}

Interface interface_of(const simulator::Signature& signature) {
    return interface_of(signature, Pointers{});
}

Interface interface_of(const simulator::Signature& signature, const Pointers& pointers) {
    const simulator::Frame frame = simulator::frame_of(signature);
    Interface interface {};
    interface.entry_stack_pointer = frame.entry_stack_pointer;
    const std::size_t scalars = frame.operands.size() - pointers.vectors - (pointers.results != 0);
    interface.operands.assign(frame.operands.begin(),
                              frame.operands.begin() + std::ptrdiff_t(scalars));
    if (pointers.vectors) {
        const std::size_t raws = pointers.vectors * pointers.elements;
        const auto areas = array_at(operand_area, raws, pointers.element_size);
        interface.operands.insert(interface.operands.end(), areas.begin(), areas.end());
        interface.operand_area = {operand_area, int(raws) * pointers.element_size};
        for (std::size_t i = 0; i < pointers.vectors; ++i)
            interface.pointers.push_back(
                {frame.operands[scalars + i], areas[i * pointers.elements].address});
    }
    if (pointers.results) {
        interface.results = array_at(result_area, pointers.results, pointers.result_size);
        interface.result_area = {result_area, int(pointers.results) * pointers.result_size};
        interface.pointers.push_back({frame.operands.back(), result_area});
    } else if (signature.result) {
        interface.results = {frame.result};
    }
    return interface;
}

Interface interface_of_variables(const simulator::Elf& elf) {
    Interface interface = interface_of({0, {}});
    interface.operand_area =
        interface.result_area = {simulator::Chip::ram_begin, int(elf.ram_bytes())};
    return interface;
}

Translation translate(const simulator::Elf& elf, std::string_view symbol,
                      const Interface& interface) {
    return Translator(elf, symbol, interface).run();
}

}  // namespace instructions
