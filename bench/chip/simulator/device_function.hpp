// SPDX-License-Identifier: GPL-3.0-or-later
// Calls a function of the loaded program by avr-gcc's convention, on the bare core: no peripheral
// runs and no interrupt occurs. If the function uses variables, the start-up code must have run
// before: `chip.run_until_function("main")`.
//
//     DeviceFunction multiply(chip, "multiply_q16_16_default", {.result = 4, .operands = {4, 4}});
//     const Outcome outcome = multiply(std::int32_t{1 << 16}, std::int32_t{3 << 16});
//     outcome.as<std::int32_t>(), outcome.cycles, outcome.stack_bytes
//
// What is counted:
// - cycles: `call` (4) and the function from its first instruction to its `ret` (4), which is
// included; not the loading of operands into registers or their pushing onto the stack.
// - stack_bytes: from the byte below the operands down to the lowest address that the stack pointer
// made free for pushes: the return address (2) plus everything that the function and its callees
// push or reserve. Operands on the stack belong to the caller.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "bench/chip/simulator/chip.hpp"
#include "bench/chip/simulator/convention.hpp"

namespace simulator {

struct Outcome {
    std::uint64_t result;  // the result's bytes, zero-extended
    std::uint32_t cycles;
    std::uint16_t stack_bytes;

    template <class T>
    T as() const {
        T value;
        std::memcpy(&value, &result, sizeof value);  // both machines are little-endian
        return value;
    }
};

// The flash words at which an executed instruction starts.
class Coverage {
  public:
    void mark(std::uint32_t flash_address) { executed_[flash_address / 2] = true; }
    // Adds the marks of the other, which must belong to the same program.
    void merge(const Coverage& other) {
        for (std::size_t i = 0; i < executed_.size(); ++i) {
            if (other.executed_[i]) executed_[i] = true;
        }
    }
    // Addresses of the instructions within a symbol's range that were not executed.
    std::vector<std::uint32_t> missed(const Elf& elf, const Symbol& symbol) const;

  private:
    std::vector<bool> executed_ = std::vector<bool>(Elf::flash_size / 2);
};

class DeviceFunction {
  public:
    DeviceFunction(Chip& chip, std::string_view symbol, Signature signature);

    // Only the low bytes of the operands count. Throws SimulationError if the function does not
    // return within the budget, crashes, or breaks the calling convention: r1 must be zero,
    // r2..r17, r28, r29 and the stack pointer unchanged, and interrupts off as before.
    Outcome call(std::span<const std::uint64_t> operands);

    template <class... Operands>
    requires(std::is_arithmetic_v<Operands>&&...) Outcome operator()(Operands... operands) {
        const std::uint64_t raw[sizeof...(operands) + 1] = {bits(operands)...};
        return call({raw, sizeof...(operands)});
    }

    void set_budget(Cycle cycles) { budget_ = cycles; }

    // Marks each executed instruction from now on, until set to nullptr.
    void record(Coverage* coverage) { coverage_ = coverage; }

    // From now on, a call fails, too, if it changes a byte of SRAM outside its stack frame, its
    // operands on the stack and the given areas.
    struct Area {
        std::uint16_t address;
        std::uint16_t size;
    };
    void forbid_writes_except(std::vector<Area> writable);

    const Symbol& symbol() const { return symbol_; }
    const Signature& signature() const { return signature_; }

  private:
    template <class T>
    static std::uint64_t bits(T value) {
        std::uint64_t raw = 0;
        std::memcpy(&raw, &value, sizeof value);
        return raw;
    }
    void run();
    void check_convention(std::span<const std::uint8_t> at_entry);
    void check_writes();
    [[noreturn]] void fail(const std::string& reason) const;

    Chip& chip_;
    avr_t* core_;
    Symbol symbol_;
    Signature signature_;
    Frame frame_;
    std::uint64_t pattern_ = 0;  // for the call-saved registers, different in each call
    Cycle budget_ = 1'000'000;
    Coverage* coverage_ = nullptr;
    bool watch_writes_ = false;
    std::vector<Area> writable_;
    std::vector<std::uint8_t> memory_;  // before the call
};

}  // namespace simulator
