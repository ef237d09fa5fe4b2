// SPDX-License-Identifier: GPL-3.0-or-later
// Assigns every cycle of a program in the simulated chip to the function that spends it.
//
//     Chip chip{Elf("firmware.elf")};
//     Profiler profiler(chip);
//     profiler.run_until_cycle(5 * Chip::frequency);
//     const Profile profile = profiler.profile();
//
// To profile a single function from the program's present state, e.g. at main():
//
//     chip.run_until_function("main");
//     Profiler profiler(chip);
//     profiler.call("step");
//     profiler.profile().find("fixedpoint_sqrt_q16_16")->inclusive_cycles;
//
// While a profiler exists, the chip must be advanced only through it.
//
// What is counted:
// - A function's cycles include those of the `call` or `rcall` that enters it and of its `ret`, as
// in DeviceFunction. An interrupt handler's include the entry (4, or 8 out of sleep) and the jump
// in the vector table.
// - An interrupt is not part of the function that it interrupts, neither in cycles nor in stack:
// its handler is a separate root.
// - A jump or branch into another function, or execution that runs into it, is a tail call: a call
// from the function that is left, which ends when its callee returns. A jump back into a function
// left in this way continues it, so that __prologue_saves__ and the like count as functions that
// were called.
// - A recursive function counts once in its inclusive cycles, while each of its calls has its own.
// A call into its own middle is a subroutine and not a call (avr-gcc reserves stack by calling the
// next instruction).
// - Inlined code belongs to the function that it was inlined into.
// - Time asleep is the function "(asleep)", called from the one that sleeps.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/chip/profile/function_map.hpp"
#include "bench/chip/profile/interrupt_watch.hpp"
#include "bench/chip/simulator/chip.hpp"

namespace profile {

using simulator::Cycle;

// Statistics of a number of samples. Without samples, min is above max and there is no mean.
struct Spread {
    std::uint64_t count = 0;
    Cycle total = 0;
    Cycle min = std::numeric_limits<Cycle>::max();
    Cycle max = 0;

    void add(Cycle sample) {
        ++count;
        total += sample;
        min = std::min(min, sample);
        max = std::max(max, sample);
    }
    double mean() const { return static_cast<double>(total) / static_cast<double>(count); }
};

struct FunctionCost {
    std::string name;    // for display
    std::string symbol;  // as in the ELF file; empty for the names in parentheses
    std::uint64_t calls = 0;
    Cycle self_cycles = 0;
    Cycle inclusive_cycles = 0;  // including everything that it calls
    Spread per_call;             // inclusive; of the calls that started and ended while counting
    // The deepest stack, from the return address (included) downwards: of the function alone, and
    // including everything that it calls.
    unsigned frame_bytes = 0;
    unsigned stack_bytes = 0;
};

struct StackCost {
    std::vector<std::string> path;  // names, the root first
    Cycle self_cycles;
};

struct InterruptCost {
    int vector;
    std::string name;     // e.g. TIMER1_COMPA_vect
    std::string handler;  // the function that the vector jumps to
    std::uint64_t entries = 0;
    Spread latency;   // from the request (interrupt_watch.hpp) to the handler's first instruction
    Spread duration;  // from there to the end of `reti`, without nested interrupts
};

struct Profile {
    Cycle elapsed = 0;                    // the sum of all self_cycles, exactly
    std::vector<FunctionCost> functions;  // the most expensive by self_cycles first
    std::vector<StackCost> stacks;        // by path
    std::vector<InterruptCost> interrupts;
    unsigned stack_bytes = 0;  // from the top of RAM to the lowest byte, interrupts included

    // By symbol or by name; nullptr if it did not run.
    const FunctionCost* find(std::string_view name) const;

    // A line per path, "main;step;sqrt 1234", the format of flame graph tools.
    std::string folded() const;
};

class Profiler {
  public:
    // Starts at the program's present state: the root is the function that continues now.
    explicit Profiler(simulator::Chip& chip);

    void step();
    template <class Predicate>  // evaluated after each instruction
    void run_until(Predicate&& reached, Cycle budget = simulator::Chip::default_budget) {
        const Cycle limit = chip_.cycle() + budget;
        while (!reached()) {
            if (chip_.cycle() >= limit) chip_.throw_budget_exceeded(budget);
            step();
        }
    }
    void run_until_cycle(Cycle cycle) {
        while (chip_.cycle() < cycle) step();
    }
    void run_until_function(std::string_view name, Cycle budget = simulator::Chip::default_budget);
    // Runs to the end of the current function.
    void run_until_return(Cycle budget = simulator::Chip::default_budget);

    // Calls a function as if the program did so here, with the present registers and interrupts.
    // Operands can be put into chip.data() according to avr-gcc's convention. Must not be called
    // within an interrupt or while asleep.
    void call(std::string_view name, Cycle budget = simulator::Chip::default_budget);

    // Forgets all counts and counts from here on. The calls in progress remain known.
    void restart();

    Profile profile() const;

  private:
    using Index = FunctionMap::Index;

    // A path of calls.
    struct Node {
        Index function;
        int parent;  // -1 at a root
        std::vector<int> children;
        Cycle self = 0;
        std::uint64_t calls = 0;
    };
    // A call in progress.
    struct Frame {
        Index function;
        int node;
        std::uint16_t floor;           // stack pointer at its start; above it, it has returned
        std::uint16_t return_address;  // its bytes: 2, and 0 at the program's root
        std::uint16_t lowest_own;      // stack pointer while the function itself ran
        std::uint16_t lowest;          // including everything that it called
        Cycle began;                   // by the clock of its context
        bool whole;                    // started while counting
        bool subroutine;               // a call into the middle of its caller
    };
    // The program, or an interrupt of the contexts below. Its clock stands still in interrupts.
    struct Context {
        std::vector<Frame> frames;
        Cycle clock = 0;
        int vector = 0;
        std::optional<Cycle> requested;
        std::optional<Cycle> handler_began;  // by the clock, once its first instruction is due
        bool whole = true;                   // started while counting
    };
    struct Stack {
        unsigned frame = 0, inclusive = 0;
    };
    struct Vector {
        std::uint64_t entries = 0;
        Spread latency, duration;
    };
    enum class Kind : std::uint8_t { plain, push, call, ret };

    static std::vector<Kind> kinds_of(const simulator::Elf& elf);
    int child(int parent, Index function);
    void charge(Cycle cycles);
    void account(Kind kind, Cycle cycles, std::uint32_t next, std::uint16_t stack_pointer);
    void enter(std::uint32_t address, std::uint16_t stack_pointer, std::uint16_t return_address);
    void begin_root(std::uint32_t address, std::uint16_t stack_pointer);
    void leave();
    void unwind(std::uint32_t next, std::uint16_t stack_pointer);
    void follow_jump(std::uint32_t next, std::uint16_t stack_pointer);
    void begin_interrupt(const InterruptWatch::Entry& entry);
    void end_interrupt();
    void note_handler_began();
    static void note_depth(Stack& of, const Frame& frame);

    simulator::Chip& chip_;
    avr_t* core_;
    FunctionMap functions_;
    InterruptWatch watch_;
    std::vector<Kind> kinds_;  // by flash word
    std::vector<Context> contexts_;
    std::vector<Node> nodes_;
    std::vector<int> roots_;
    std::vector<Spread> per_call_;  // by function, like the next
    std::vector<Stack> stack_;
    std::vector<Vector> vectors_;
    Cycle began_ = 0;
    std::uint16_t lowest_ = 0;
};

}  // namespace profile
