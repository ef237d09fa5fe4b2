// SPDX-License-Identifier: GPL-3.0-or-later
// A simulated ATmega328P at 16 MHz: libsimavr 1.6, with a workaround for each of its defects that
// changes a cycle count or a result (workarounds/, and Chip's constructor). Nothing can hang: a run
// that exceeds its cycle budget, an illegal opcode, a jump out of the program and a stack that runs
// into the data all end in a SimulationError of one line.
//
// The cycle that a callback gets is the one at which the instruction that caused it started.
// Callbacks must not throw.
#pragma once

#include <cstdarg>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>

#include "bench/chip/simulator/elf.hpp"

struct avr_t;

namespace simulator {

class SimulationError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

using Cycle = std::uint64_t;

struct Pin {
    char port;  // 'B', 'C' or 'D'
    int bit;
};

class Chip {
  public:
    static constexpr std::uint32_t frequency = 16'000'000;  // Hz
    static constexpr std::uint16_t ram_begin = Elf::ram_begin;
    static constexpr std::uint16_t ram_end = Elf::ram_end;      // one past the last byte
    static constexpr Cycle default_budget = 60ull * frequency;  // one minute
    static constexpr Cycle call_budget = frequency;  // a second: start-up code, or a function

    // Loads the program and resets.
    explicit Chip(Elf elf);
    ~Chip();
    Chip(const Chip&) = delete;
    Chip& operator=(const Chip&) = delete;

    const Elf& elf() const { return elf_; }

    // The state after power-on: the cycle count is 0, registers and I/O are cleared, RAM is kept.
    void reset();

    // Running. Each takes at most the budget of cycles and throws SimulationError beyond it.
    void step();  // one instruction, an interrupt's entry, or the time asleep until the next event
    void run_until_cycle(Cycle cycle);
    void run_until_address(std::uint32_t flash_address, Cycle budget = default_budget);
    void run_until_function(std::string_view name, Cycle budget = call_budget);
    template <class Predicate>  // evaluated after each instruction
    void run_until(Predicate&& reached, Cycle budget = default_budget) {
        const Cycle limit = cycle() + budget;
        while (!reached()) {
            if (cycle() >= limit) throw_budget_exceeded(budget);
            step();
        }
    }

    // State. Addresses of instructions are flash byte addresses.
    Cycle cycle() const;
    std::uint32_t program_counter() const;
    void set_program_counter(std::uint32_t flash_address);
    std::uint16_t stack_pointer() const {
        return static_cast<std::uint16_t>(data_[0x5d] | data_[0x5e] << 8);
    }
    std::uint16_t lowest_stack_pointer() const { return lowest_stack_pointer_; }
    void forget_lowest_stack_pointer() { lowest_stack_pointer_ = stack_pointer(); }
    std::uint8_t status() const;  // SREG
    std::uint8_t reg(int number) const { return data()[number]; }

    // The data space: 0..31 registers, 32..255 I/O as last written, then SRAM. Access has no side
    // effects.
    std::uint8_t* data() const { return data_; }
    std::uint8_t read(std::uint16_t address) const { return data_[address]; }
    void read(std::uint16_t address, std::span<std::uint8_t> bytes) const;
    void write(std::uint16_t address, std::span<const std::uint8_t> bytes);

    // Reserves bytes of SRAM above the program's variables, for operands that a function takes by
    // address, until the next reset. The stack must not grow into them either.
    std::uint16_t allocate(std::uint16_t bytes);

    // The outside world. A callback replaces the previous one, except for on_edge, where all are
    // called.
    using WriteCallback = std::function<void(Cycle, std::uint8_t value)>;
    using EdgeCallback = std::function<void(Cycle, bool level)>;
    using VoltageCallback = std::function<double(Cycle, int channel)>;
    void on_gpior0_write(
        WriteCallback callback);  // `out` takes 1 cycle: subtract it from an interval
    void on_edge(Pin pin,
                 EdgeCallback callback);        // at each change of level, driven from either side
    void set_pin(Pin pin, bool level);          // drives an input
    void on_conversion(VoltageCallback volts);  // asked at the start of each ADC conversion
    void on_uart_byte(WriteCallback callback);  // at the end of each frame that the chip sends
    void send_to_uart(std::uint8_t byte);       // arrives a frame later, after queued bytes

    // For code that works on the core itself (device_function.cpp, workarounds/).
    avr_t* core() const { return avr_; }
    void throw_if_crashed() const;
    [[noreturn]] void throw_budget_exceeded(Cycle budget) const;

  private:
    void advance(Cycle most);  // a burst; ends with the instruction that reaches that many cycles
    void note_stack_pointer();
    void expect_in_data_space(std::uint16_t address, std::size_t bytes) const;
    void fail(const std::string& reason);  // stops the core; thrown after it has returned
    static void on_message(avr_t* avr, int level, const char* format, va_list arguments);

    Elf elf_;
    avr_t* avr_;
    std::uint8_t* data_;
    std::uint16_t data_end_ = 0;
    std::uint16_t lowest_stack_pointer_ = 0;
    struct Attachments;  // workarounds and callbacks
    std::unique_ptr<Attachments> attachments_;
    std::string failure_;
};

}  // namespace simulator
