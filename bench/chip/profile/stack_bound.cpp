// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/profile/stack_bound.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "bench/chip/instructions/instruction.hpp"
#include "bench/chip/profile/function_map.hpp"
#include "bench/chip/simulator/chip.hpp"

namespace profile {
namespace {

using instructions::Flow;
using instructions::Instruction;

constexpr int return_address_bytes = 2;
constexpr int ram_bytes = simulator::Chip::ram_end - simulator::Chip::ram_begin;
constexpr int stack_low_port = 0x3d, stack_high_port = 0x3e;
constexpr std::string_view switch_jumps[] = {"__tablejump2__", "__tablejump__"};

// What is known of the byte in a register. An address in the stack is known by its depth: the bytes
// between it and the stack pointer at the function's start.
struct Byte {
    enum Kind { unknown, constant, low, high, low_after_subtraction, low_after_addition };
    Kind kind = unknown;
    int depth = 0;  // of low, high and low_after
    int value = 0;  // of constant; what a low_after was changed by
    bool operator==(const Byte&) const = default;
};

struct Registers {
    std::array<Byte, 32> bytes{};

    Byte& operator[](int number) { return bytes[static_cast<std::size_t>(number)]; }
    void forget(int number) { (*this)[number] = {}; }
    void forget_pair(int number) { forget(number), forget(number + 1); }

    // Keeps what both know. Returns whether that is less than before.
    bool join(const Registers& other) {
        bool changed = false;
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            if (bytes[i] == other.bytes[i] || bytes[i].kind == Byte::unknown) continue;
            bytes[i] = {};
            changed = true;
        }
        return changed;
    }
    void add(int first, int constant) { move(first, -constant); }
    void subtract(int first, int constant) { move(first, constant); }

    void subtract_low(int number, int constant) {
        Byte& byte = (*this)[number];
        byte = byte.kind == Byte::low ? Byte{Byte::low_after_subtraction, byte.depth, constant}
                                      : Byte{};
    }
    void add_low(int number, int constant) {
        Byte& byte = (*this)[number];
        byte =
            byte.kind == Byte::low ? Byte{Byte::low_after_addition, byte.depth, constant} : Byte{};
    }
    // The instruction with carry that follows one of those above, on the upper register.
    void carry(int number, int constant, Byte::Kind after) {
        Byte& upper = (*this)[number];
        const Byte lower = number ? (*this)[number - 1] : Byte{};
        if (upper.kind != Byte::high || lower.kind != after || lower.depth != upper.depth)
            return forget(number);
        const int amount = static_cast<std::int16_t>(constant << 8 | lower.value);
        const int depth = upper.depth + (after == Byte::low_after_subtraction ? amount : -amount);
        (*this)[number - 1] = {Byte::low, depth, 0};
        upper = {Byte::high, depth, 0};
    }

  private:
    void move(int first, int deeper) {
        Byte& lower = (*this)[first];
        Byte& upper = (*this)[first + 1];
        if (lower.kind == Byte::low && upper.kind == Byte::high && lower.depth == upper.depth)
            lower.depth = upper.depth = lower.depth + deeper;
        else
            forget_pair(first);
    }
};

// Everything that a call of one address can lead to.
struct Summary {
    int frame = 0;
    std::optional<int> stack = 0;
    std::string unbounded;
    bool enables_interrupts = false;
    bool returns = false;  // on any path
    std::optional<std::uint32_t> deepest_callee{};
};

class CallGraph {
  public:
    explicit CallGraph(const simulator::Elf& elf, const FunctionMap& names)
        : elf_(elf), names_(names) {
        for (const std::string_view name : switch_jumps)
            if (elf.has_function(name)) switch_jumps_.insert(elf.function(name).address);
    }

    Summary summary(std::uint32_t entry);
    const std::map<std::uint32_t, Summary>& summaries() const { return summaries_; }

  private:
    class Walk;

    const simulator::Elf& elf_;
    const FunctionMap& names_;
    std::set<std::uint32_t> switch_jumps_;
    std::map<std::uint32_t, Summary> summaries_;
    std::vector<std::uint32_t> in_progress_;
};

// Follows the instructions from one entry, into the targets of jumps but not of calls.
class CallGraph::Walk {
  public:
    explicit Walk(CallGraph& graph) : graph_(graph) {}

    Summary run(std::uint32_t entry) {
        Registers registers;
        registers[1] = {Byte::constant, 0, 0};  // avr-gcc's zero register
        visit(entry, 0, registers);
        do {
            while (!pending_.empty() && summary_.unbounded.empty()) {
                const Place place = *pending_.begin();
                pending_.erase(pending_.begin());
                execute(place, states_.at(place));
            }
        } while (summary_.unbounded.empty() && visit_next_case());
        if (!summary_.unbounded.empty())
            summary_.stack.reset();
        else
            summary_.stack = std::max(*summary_.stack, summary_.frame);
        return summary_;
    }

  private:
    using Place = std::pair<std::uint32_t, int>;  // address, depth

    void give_up(std::string_view why, std::uint32_t address) {
        summary_.unbounded = fmt::format("{} in {}", why, graph_.names_.describe(address));
    }

    void visit(std::uint32_t address, int depth, const Registers& registers) {
        if (address == 0) return;  // a restart of the program
        if (depth > ram_bytes) return give_up("a loop that pushes", address);
        const auto [state, is_new] = states_.try_emplace({address, depth}, registers);
        if (is_new || state->second.join(registers)) pending_.insert({address, depth});
        summary_.frame = std::max(summary_.frame, depth);
    }

    void execute(Place place, Registers registers) {
        const auto [address, depth] = place;
        if (address + 2 > graph_.elf_.flash().size())
            return give_up("a jump out of the program", address);
        const Instruction now = instructions::decode(graph_.elf_.flash(), address);
        if (!now.row) return give_up("an illegal opcode", address);
        const std::string_view name = now.row->mnemonic;

        if (name == "call" || name == "rcall") {
            if (now.target() == now.next())  // reserves two bytes
                return visit(now.next(), depth + return_address_bytes, registers);
            if (graph_.switch_jumps_.contains(now.target()))
                return give_up("indirect call", address);
            call(now, depth, registers);
        } else if (name == "icall" || name == "eicall") {
            give_up("indirect call", address);
        } else if (name == "ijmp" || name == "eijmp") {
            const Byte low = registers[30], high = registers[31];
            if (low.kind != Byte::constant || high.kind != Byte::constant)
                return give_up("indirect jump", address);
            visit(static_cast<std::uint32_t>(high.value << 8 | low.value) * 2, depth, registers);
        } else if (name == "ret" || name == "reti") {
            if (depth != 0) give_up("a return with another depth than at the entry", address);
            summary_.returns = true;
        } else if (now.row->flow == Flow::jump) {
            if (graph_.switch_jumps_.contains(now.target())) {
                switches_.insert_or_assign(place, registers);
                return;
            }
            visit(now.target(), depth, registers);
        } else if (now.row->flow == Flow::branch) {
            visit(now.target(), depth, registers);
            visit(now.next(), depth, registers);
        } else if (now.row->flow == Flow::skip || name == "sbic" || name == "sbis") {
            visit(now.next(), depth, registers);
            visit(now.next() + instructions::decode(graph_.elf_.flash(), now.next()).size(), depth,
                  registers);
        } else {
            straight_on(now, depth, registers);
        }
    }

    void call(const Instruction& now, int depth, Registers registers) {
        const Summary callee = graph_.summary(now.target());
        if (!callee.stack) {
            summary_.unbounded = callee.unbounded;
            return;
        }
        summary_.enables_interrupts |= callee.enables_interrupts;
        const int below = depth + return_address_bytes;
        if (below + *callee.stack > *summary_.stack) {
            summary_.stack = below + *callee.stack;
            summary_.deepest_callee = now.target();
        }
        if (is_subroutine(now)) summary_.frame = std::max(summary_.frame, below + callee.frame);
        if (!callee.returns) return;
        for (int number = 0; number < 32; ++number)
            if (number < 2 || (number >= 18 && number < 28) || number >= 30)
                registers.forget(number);
        registers[1] = {Byte::constant, 0, 0};
        visit(now.next(), depth, registers);
    }

    // A call into the middle of the function that contains it.
    bool is_subroutine(const Instruction& call) const {
        const FunctionMap::Index function = graph_.names_.at(call.target());
        return function == graph_.names_.at(call.address) &&
               call.target() != graph_.names_[function].address;
    }

    // The cases of a switch are whatever else is in its function, once everything that is reachable
    // without them is known. Starts the first one that is new.
    bool visit_next_case() {
        const std::size_t size = graph_.elf_.flash().size();
        for (const auto& [jump, registers] : switches_) {
            const FunctionMap::Index function = graph_.names_.at(jump.first);
            std::uint32_t at = graph_.names_[function].address;
            while (at + 2 <= size && graph_.names_.at(at) == function) {
                const auto reached = states_.lower_bound({at, 0});
                if (reached == states_.end() || reached->first.first != at) {
                    visit(at, jump.second, registers);
                    return true;
                }
                at += instructions::decode(graph_.elf_.flash(), at).size();
            }
        }
        return false;
    }

    void straight_on(const Instruction& now, int depth, Registers registers) {
        const std::string_view name = now.row->mnemonic;
        if (name == "push") {
            ++depth;
        } else if (name == "pop") {
            --depth;
            registers.forget(now.d);
            if (depth < 0) return give_up("a pop of what was not pushed", now.address);
        } else if (name == "out" && (now.A == stack_low_port || now.A == stack_high_port)) {
            const bool is_low = now.A == stack_low_port;
            const Byte byte = registers[now.r];
            if (byte.kind != (is_low ? Byte::low : Byte::high))
                return give_up("a stack pointer set to a computed value", now.address);
            if (is_low) depth = byte.depth;
            if (depth < 0) return give_up("a stack pointer above the entry's", now.address);
        } else {
            if (name == "sei") summary_.enables_interrupts = true;
            change_registers(now, depth, registers);
        }
        visit(now.next(), depth, registers);
    }

    static void change_registers(const Instruction& now, int depth, Registers& registers) {
        const std::string_view name = now.row->mnemonic;
        const Byte source = registers[now.r];
        const auto constant = [](const Byte& byte) { return byte.kind == Byte::constant; };
        if (name == "in" && now.A == stack_low_port) {
            registers[now.d] = {Byte::low, depth, 0};
        } else if (name == "in" && now.A == stack_high_port) {
            registers[now.d] = {Byte::high, depth, 0};
        } else if (name == "ldi") {
            registers[now.d] = {Byte::constant, 0, now.K};
        } else if (name == "eor" && now.d == now.r) {
            registers[now.d] = {Byte::constant, 0, 0};
        } else if (name == "mov") {
            registers[now.d] = source;
        } else if (name == "movw") {
            registers[now.d] = source;
            registers[now.d + 1] = registers[now.r + 1];
        } else if (name == "adiw") {
            registers.add(now.d, now.K);
        } else if (name == "sbiw") {
            registers.subtract(now.d, now.K);
        } else if (name == "subi") {
            registers.subtract_low(now.d, now.K);
        } else if (name == "sbci") {
            registers.carry(now.d, now.K, Byte::low_after_subtraction);
        } else if (name == "sub" && constant(source)) {
            registers.subtract_low(now.d, source.value);
        } else if (name == "sbc" && constant(source)) {
            registers.carry(now.d, source.value, Byte::low_after_subtraction);
        } else if (name == "add" && constant(source)) {
            registers.add_low(now.d, source.value);
        } else if (name == "adc" && constant(source)) {
            registers.carry(now.d, source.value, Byte::low_after_addition);
        } else {
            forget_written(now, registers);
        }
    }

    static void forget_written(const Instruction& now, Registers& registers) {
        const std::string_view name = now.row->mnemonic;
        const std::string_view operands = now.row->operands;
        static constexpr std::string_view reads_only[] = {"cp", "cpc", "cpi", "bst"};
        if (name.starts_with("mul") || name.starts_with("fmul")) return registers.forget_pair(0);
        if (operands.starts_with("r{d}") &&
            std::ranges::find(reads_only, name) == std::end(reads_only))
            registers.forget(now.d);
        if (name == "lpm" && operands.empty()) registers.forget(0);
        constexpr std::pair<char, int> pointers[] = {{'X', 26}, {'Y', 28}, {'Z', 30}};
        for (const auto& [letter, number] : pointers) {
            const std::size_t at = operands.find(letter);
            if (at == operands.npos) continue;
            const std::string_view behind = operands.substr(at + 1);
            const bool before = at > 0 && operands[at - 1] == '-';
            if (before || (behind.starts_with('+') && !behind.starts_with("+{")))
                registers.forget_pair(number);
        }
    }

    CallGraph& graph_;
    Summary summary_;
    std::map<Place, Registers> states_;
    std::set<Place> pending_;
    std::map<Place, Registers> switches_;
};

Summary CallGraph::summary(std::uint32_t entry) {
    if (const auto known = summaries_.find(entry); known != summaries_.end()) return known->second;
    const auto again = std::ranges::find(in_progress_, entry);
    if (again != in_progress_.end()) {
        std::vector<std::string> cycle;
        for (auto at = again; at != in_progress_.end(); ++at) cycle.push_back(names_.describe(*at));
        cycle.push_back(cycle.front());
        return {.stack = std::nullopt,
                .unbounded = fmt::format("recursion: {}", fmt::join(cycle, " > "))};
    }
    in_progress_.push_back(entry);
    const Summary found = Walk(*this).run(entry);
    in_progress_.pop_back();
    summaries_.emplace(entry, found);
    return found;
}

// The flash addresses of the functions that the start-up code calls for global objects.
std::vector<std::uint32_t> constructors(const simulator::Elf& elf) {
    std::vector<std::uint32_t> found;
    if (!elf.has_function("__ctors_start") || !elf.has_function("__ctors_end")) return found;
    const std::uint32_t end = elf.function("__ctors_end").address;
    for (std::uint32_t at = elf.function("__ctors_start").address; at + 2 <= end; at += 2)
        found.push_back(static_cast<std::uint32_t>(elf.flash()[at] | elf.flash()[at + 1] << 8) * 2);
    return found;
}

}  // namespace

StackBound static_stack_bound(const simulator::Elf& elf) {
    const FunctionMap names(elf);
    CallGraph graph(elf, names);
    StackBound bound;
    const auto add_reason = [&](const std::string& reason) {
        if (std::ranges::find(bound.unbounded, reason) == bound.unbounded.end())
            bound.unbounded.push_back(reason);
    };
    // The bytes of a call, or 0 if it is unbounded.
    const auto bytes_of = [&](std::uint32_t entry) {
        const Summary summary = graph.summary(entry);
        if (!summary.stack) add_reason(summary.unbounded);
        return static_cast<unsigned>(return_address_bytes + summary.stack.value_or(0));
    };

    std::vector<std::uint32_t> roots = constructors(elf);
    roots.push_back(elf.function("main").address);
    for (const std::uint32_t root : roots) {
        const unsigned bytes = bytes_of(root);
        if (bytes <= bound.path_bytes) continue;
        bound.path_bytes = bytes;
        bound.path.clear();
        for (std::optional<std::uint32_t> at = root; at; at = graph.summary(*at).deepest_callee)
            bound.path.push_back(names.describe(*at));
    }

    unsigned deepest = 0;
    std::string deepest_name;
    const std::uint32_t unused =
        elf.has_function("__bad_interrupt") ? elf.function("__bad_interrupt").address : 0;
    const int vectors = elf.has_function("__vectors") ? vector_count : 0;
    for (int vector = 1; vector < vectors; ++vector) {
        const std::uint32_t handler = names.handler(vector);
        if (handler == unused || handler == 0) continue;
        const unsigned bytes = bytes_of(handler);
        if (graph.summary(handler).enables_interrupts) {
            bound.interrupts.emplace_back(vector_name(vector));
            bound.interruptible.emplace_back(vector_name(vector));
            bound.interrupt_bytes += bytes;
        } else if (bytes > deepest) {
            deepest = bytes;
            deepest_name = vector_name(vector);
        }
    }
    if (deepest) bound.interrupts.push_back(deepest_name);
    bound.interrupt_bytes += deepest;
    if (bound.unbounded.empty()) bound.bytes = bound.path_bytes + bound.interrupt_bytes;

    for (const auto& [entry, summary] : graph.summaries()) {
        FunctionBound function{names.describe(entry), std::nullopt, std::nullopt, summary.unbounded,
                               summary.enables_interrupts};
        if (summary.stack) {
            function.frame_bytes = static_cast<unsigned>(summary.frame + return_address_bytes);
            function.stack_bytes = static_cast<unsigned>(*summary.stack + return_address_bytes);
        }
        bound.functions.push_back(std::move(function));
    }
    std::ranges::sort(bound.functions, {}, &FunctionBound::name);
    return bound;
}

}  // namespace profile
