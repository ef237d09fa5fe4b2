// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/profile/profiler.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sim_avr.h>

#include <functional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "bench/chip/instructions/instruction.hpp"

namespace profile {
namespace {

constexpr std::uint16_t return_address_bytes = 2;
constexpr Cycle call_cycles = 4;
constexpr int stack_low_port = 0x3d;
constexpr int no_parent = -1;

}  // namespace

Profiler::Profiler(simulator::Chip& chip)
    : chip_(chip),
      core_(chip.core()),
      functions_(chip.elf()),
      watch_(chip.core()),
      kinds_(kinds_of(chip.elf())),
      contexts_(1),
      per_call_(functions_.size()),
      stack_(functions_.size()),
      vectors_(vector_count) {
    begin_root(chip.program_counter(), chip.stack_pointer());
    restart();
}

// Between the two `out` instructions that write the stack pointer, its value means nothing. avr-gcc
// writes the high byte first, so it is examined after the low byte.
std::vector<Profiler::Kind> Profiler::kinds_of(const simulator::Elf& elf) {
    std::vector<Kind> kinds(simulator::Elf::flash_size / 2, Kind::plain);
    for (std::uint32_t at = 0; at + 4 <= elf.flash().size(); at += 2) {
        const instructions::Instruction instruction = instructions::decode(elf.flash(), at);
        if (!instruction.row) continue;
        const std::string_view mnemonic = instruction.row->mnemonic;
        Kind& kind = kinds[at / 2];
        if (mnemonic == "call" || mnemonic == "rcall" || mnemonic == "icall")
            kind = Kind::call;
        else if (mnemonic == "ret" || mnemonic == "reti" || mnemonic == "ijmp")
            kind = Kind::ret;  // longjmp() ends in ijmp
        else if (mnemonic == "push" || (mnemonic == "out" && instruction.A == stack_low_port))
            kind = Kind::push;
    }
    return kinds;
}

void Profiler::step() {
    watch_.before_step();
    const Cycle before = core_->cycle;
    const bool asleep = core_->state == cpu_Sleeping;
    const Kind kind = kinds_[core_->pc / 2];
    chip_.step();

    std::uint32_t next = core_->pc;
    std::uint16_t stack_pointer = chip_.stack_pointer();
    Cycle end = core_->cycle;
    const std::optional<InterruptWatch::Entry>& interrupt = watch_.entry();
    if (interrupt) {  // after the instruction, in the same step
        end = interrupt->begin;
        stack_pointer += return_address_bytes;
        const std::uint8_t* const pushed = chip_.data() + stack_pointer;
        next = static_cast<std::uint32_t>(pushed[-1] << 8 | pushed[0]) * 2;
    }
    if (asleep) {
        Context& context = contexts_.back();
        context.clock += end - before;
        const int node = child(context.frames.back().node, FunctionMap::asleep);
        nodes_[static_cast<std::size_t>(node)].self += end - before;
    } else {
        account(kind, end - before, next, stack_pointer);
    }
    if (interrupt) begin_interrupt(*interrupt);
}

void Profiler::account(Kind kind, Cycle cycles, std::uint32_t next, std::uint16_t stack_pointer) {
    if (kind == Kind::call) {
        enter(next, stack_pointer, return_address_bytes);
        charge(cycles);
    } else {
        charge(cycles);
        if (kind == Kind::ret) unwind(next, stack_pointer);
    }
    if (kind == Kind::call || kind == Kind::push) {
        Frame& frame = contexts_.back().frames.back();
        frame.lowest_own = std::min(frame.lowest_own, stack_pointer);
        lowest_ = std::min(lowest_, stack_pointer);
    }
    const Context& context = contexts_.back();
    if (context.vector && !context.handler_began) {
        if (next == functions_.handler(context.vector)) note_handler_began();
    } else if (functions_.at(next) != context.frames.back().function) {
        follow_jump(next, stack_pointer);
    }
}

void Profiler::charge(Cycle cycles) {
    Context& context = contexts_.back();
    context.clock += cycles;
    nodes_[static_cast<std::size_t>(context.frames.back().node)].self += cycles;
}

int Profiler::child(int parent, Index function) {
    const auto siblings = [&]() -> std::vector<int>& {
        return parent == no_parent ? roots_ : nodes_[static_cast<std::size_t>(parent)].children;
    };
    for (const int node : siblings())
        if (nodes_[static_cast<std::size_t>(node)].function == function) return node;
    const int node = static_cast<int>(nodes_.size());
    siblings().push_back(node);
    nodes_.push_back({function, parent, {}});
    return node;
}

// Pushes a frame onto the context's others; the first is its root.
void Profiler::enter(std::uint32_t address, std::uint16_t stack_pointer,
                     std::uint16_t return_address) {
    Context& context = contexts_.back();
    const Index function = functions_.at(address);
    int parent = no_parent;
    bool subroutine = false;
    if (!context.frames.empty()) {
        const Frame& caller = context.frames.back();
        parent = caller.node;
        subroutine = function == caller.function && address != functions_[function].address;
    }
    const int node = subroutine ? parent : child(parent, function);
    if (!subroutine) ++nodes_[static_cast<std::size_t>(node)].calls;
    context.frames.push_back({function, node, stack_pointer, return_address, stack_pointer,
                              stack_pointer, context.clock, true, subroutine});
}

void Profiler::begin_root(std::uint32_t address, std::uint16_t stack_pointer) {
    enter(address, stack_pointer, 0);
    Frame& root = contexts_.back().frames.back();
    root.whole = false;
    --nodes_[static_cast<std::size_t>(root.node)].calls;  // it started before it was watched
}

void Profiler::note_depth(Stack& of, const Frame& frame) {
    const unsigned top = frame.floor + frame.return_address;
    of.frame = std::max(of.frame, top - frame.lowest_own);
    of.inclusive = std::max(of.inclusive, top - std::min(frame.lowest, frame.lowest_own));
}

void Profiler::leave() {
    Context& context = contexts_.back();
    const Frame frame = context.frames.back();
    context.frames.pop_back();
    if (!frame.subroutine) {
        if (frame.whole) per_call_[frame.function].add(context.clock - frame.began);
        note_depth(stack_[frame.function], frame);
    }
    if (context.frames.empty()) return;
    Frame& caller = context.frames.back();
    caller.lowest = std::min({caller.lowest, frame.lowest, frame.lowest_own});
    if (frame.subroutine) caller.lowest_own = std::min(caller.lowest_own, frame.lowest_own);
}

// Ends all calls whose return address is no longer on the stack.
void Profiler::unwind(std::uint32_t next, std::uint16_t stack_pointer) {
    for (;;) {
        std::vector<Frame>& frames = contexts_.back().frames;
        while (!frames.empty() && frames.back().floor < stack_pointer) leave();
        if (!frames.empty()) return;
        if (contexts_.size() == 1) return begin_root(next, stack_pointer);
        end_interrupt();
    }
}

void Profiler::follow_jump(std::uint32_t next, std::uint16_t stack_pointer) {
    std::vector<Frame>& frames = contexts_.back().frames;
    const Frame from = frames.back();
    const Index function = functions_.at(next);
    const auto same_call = [&](const Frame& frame) { return frame.floor == from.floor; };
    const auto back = std::find_if(frames.rbegin(), frames.rend(), [&](const Frame& frame) {
        return !same_call(frame) || frame.function == function;
    });
    if (back != frames.rend() && same_call(*back)) {
        while (frames.back().function != function) leave();
        return;
    }
    enter(next, from.floor, from.return_address);
    frames.back().lowest_own = frames.back().lowest = stack_pointer;
}

void Profiler::begin_interrupt(const InterruptWatch::Entry& entry) {
    Context context;
    context.vector = entry.vector;
    context.requested = entry.requested;
    contexts_.push_back(std::move(context));
    const std::uint32_t handler = functions_.handler(entry.vector);
    enter(handler, chip_.stack_pointer(), return_address_bytes);
    lowest_ = std::min(lowest_, chip_.stack_pointer());
    charge(core_->cycle - entry.begin);
    ++vectors_[static_cast<std::size_t>(entry.vector)].entries;
    if (core_->pc == handler) note_handler_began();
}

void Profiler::note_handler_began() {
    Context& context = contexts_.back();
    context.handler_began = context.clock;
    if (context.requested)
        vectors_[static_cast<std::size_t>(context.vector)].latency.add(core_->cycle -
                                                                       *context.requested);
}

void Profiler::end_interrupt() {
    const Context& context = contexts_.back();
    if (context.handler_began && context.whole)
        vectors_[static_cast<std::size_t>(context.vector)].duration.add(context.clock -
                                                                        *context.handler_began);
    contexts_.pop_back();
}

void Profiler::run_until_function(std::string_view name, Cycle budget) {
    const std::uint32_t address = chip_.elf().function(name).address;
    run_until([&] { return core_->pc == address; }, budget);
}

void Profiler::run_until_return(Cycle budget) {
    const std::size_t context = contexts_.size();
    const std::uint16_t floor = contexts_.back().frames.back().floor;
    run_until(
        [&] {
            return contexts_.size() < context ||
                   (contexts_.size() == context && contexts_.back().frames.back().floor > floor);
        },
        budget);
}

void Profiler::call(std::string_view name, Cycle budget) {
    const std::uint32_t function = chip_.elf().function(name).address;
    if (contexts_.size() > 1 || core_->state == cpu_Sleeping)
        throw std::logic_error("a function can be called neither from an interrupt nor asleep");
    const std::uint32_t return_to = core_->pc / 2;
    std::uint16_t stack_pointer = chip_.stack_pointer();
    const std::uint8_t pushed[] = {static_cast<std::uint8_t>(return_to >> 8),
                                   static_cast<std::uint8_t>(return_to)};
    stack_pointer -= return_address_bytes;
    chip_.write(static_cast<std::uint16_t>(stack_pointer + 1), pushed);
    chip_.data()[R_SPL] = static_cast<std::uint8_t>(stack_pointer);
    chip_.data()[R_SPH] = static_cast<std::uint8_t>(stack_pointer >> 8);
    chip_.set_program_counter(function);
    core_->cycle += call_cycles;
    account(Kind::call, call_cycles, function, stack_pointer);
    run_until_return(budget);
}

void Profiler::restart() {
    began_ = core_->cycle;
    lowest_ = chip_.stack_pointer();
    for (Node& node : nodes_) node.self = node.calls = 0;
    per_call_.assign(functions_.size(), {});
    stack_.assign(functions_.size(), {});
    vectors_.assign(vector_count, {});
    // A function that waits for another to return has a higher stack pointer than that one.
    std::uint16_t below = lowest_;
    for (auto context = contexts_.rbegin(); context != contexts_.rend(); ++context) {
        context->requested.reset();
        context->whole = false;
        for (auto frame = context->frames.rbegin(); frame != context->frames.rend(); ++frame) {
            const std::uint16_t top = frame->floor + frame->return_address;
            frame->whole = false;
            frame->lowest_own = frame->lowest = std::min(below, top);
            below = std::max(below, top);
        }
    }
}

Profile Profiler::profile() const {
    Profile profile;
    profile.elapsed = core_->cycle - began_;
    profile.stack_bytes = simulator::Chip::ram_end - 1u - lowest_;

    std::vector<FunctionCost> costs(functions_.size());
    std::vector<Stack> stack = stack_;
    for (const Context& context : contexts_) {  // the calls in progress
        std::uint16_t lowest = std::numeric_limits<std::uint16_t>::max();
        for (auto frame = context.frames.rbegin(); frame != context.frames.rend(); ++frame) {
            Frame so_far = *frame;
            so_far.lowest = lowest = std::min({lowest, frame->lowest, frame->lowest_own});
            note_depth(stack[frame->function], so_far);
        }
    }

    // Returns the cycles of a path and of all its continuations.
    std::vector<int> open(functions_.size());
    std::vector<std::string> path;
    Cycle sum = 0;
    const std::function<Cycle(int)> walk = [&](int index) {
        const Node& node = nodes_[static_cast<std::size_t>(index)];
        FunctionCost& cost = costs[node.function];
        path.push_back(functions_[node.function].name);
        if (node.self) profile.stacks.push_back({path, node.self});
        cost.self_cycles += node.self;
        cost.calls += node.calls;
        sum += node.self;
        ++open[node.function];
        Cycle inclusive = node.self;
        for (const int next : node.children) inclusive += walk(next);
        if (--open[node.function] == 0) cost.inclusive_cycles += inclusive;
        path.pop_back();
        return inclusive;
    };
    for (const int root : roots_) walk(root);
    if (sum != profile.elapsed)
        throw std::logic_error(
            fmt::format("{} cycles went by, {} were counted: the chip was run "
                        "without its profiler",
                        profile.elapsed, sum));

    for (std::size_t i = 0; i < costs.size(); ++i) {
        FunctionCost& cost = costs[i];
        if (!cost.inclusive_cycles && !cost.calls) continue;
        const Function& function = functions_[static_cast<Index>(i)];
        cost.name = function.name;
        cost.symbol = function.symbol;
        cost.per_call = per_call_[i];
        cost.frame_bytes = stack[i].frame;
        cost.stack_bytes = stack[i].inclusive;
        profile.functions.push_back(std::move(cost));
    }
    std::ranges::sort(profile.functions, [](const FunctionCost& a, const FunctionCost& b) {
        return std::tie(b.self_cycles, a.name) < std::tie(a.self_cycles, b.name);
    });
    std::ranges::sort(profile.stacks, {}, &StackCost::path);
    for (int vector = 1; vector < vector_count; ++vector) {
        const Vector& counted = vectors_[static_cast<std::size_t>(vector)];
        if (!counted.entries) continue;
        profile.interrupts.push_back({vector, std::string(vector_name(vector)),
                                      functions_.describe(functions_.handler(vector)),
                                      counted.entries, counted.latency, counted.duration});
    }
    return profile;
}

const FunctionCost* Profile::find(std::string_view name) const {
    const auto found = std::ranges::find_if(functions, [&](const FunctionCost& function) {
        return function.symbol == name || function.name == name;
    });
    return found == functions.end() ? nullptr : &*found;
}

std::string Profile::folded() const {
    std::string text;
    for (const StackCost& stack : stacks)
        text += fmt::format("{} {}\n", fmt::join(stack.path, ";"), stack.self_cycles);
    return text;
}

}  // namespace profile
