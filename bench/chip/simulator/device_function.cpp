// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/simulator/device_function.hpp"

#include <fmt/format.h>
#include <sim_avr.h>
#include <sim_core.h>

#include <algorithm>
#include <array>
#include <utility>

namespace simulator {
namespace {

// Functions return to a `sleep` in the last word of flash, which stops the core's burst. Two
// illegal words before it stop a program that strays through the erased flash, which executes as
// `sbrs`.
constexpr std::uint32_t sentinel = Elf::flash_size - 2;
constexpr std::uint16_t end_of_flash[] = {0x00ff, 0x00ff, 0x9588};
constexpr Cycle sleep_cycles = 1;
constexpr int registers = 32;

bool is_two_words(std::uint16_t opcode) {
    return (opcode & 0xfc0f) == 0x9000 /* lds, sts */ ||
           (opcode & 0xfe0c) == 0x940c /* jmp, call */;
}

template <class T>
T load(const std::uint8_t* from) {
    T value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

// Turns interrupts off, and restores the program counter at the end.
class Interlude {
  public:
    explicit Interlude(avr_t* core)
        : core_(core),
          program_counter_(core->pc),
          stack_low_(core->data[R_SPL]),
          stack_high_(core->data[R_SPH]),
          interrupt_flag_(std::exchange(core->sreg[S_I], 0)),
          interrupt_state_(std::exchange(core->interrupt_state, 0)) {}
    ~Interlude() {
        core_->state = cpu_Running;
        core_->pc = program_counter_;
        core_->data[R_SPL] = stack_low_;
        core_->data[R_SPH] = stack_high_;
        core_->sreg[S_I] = interrupt_flag_;
        core_->interrupt_state = interrupt_state_;
    }
    Interlude(const Interlude&) = delete;

  private:
    avr_t* core_;
    avr_flashaddr_t program_counter_;
    std::uint8_t stack_low_, stack_high_, interrupt_flag_;
    std::int8_t interrupt_state_;
};

}  // namespace

std::vector<std::uint32_t> Coverage::missed(const Elf& elf, const Symbol& symbol) const {
    std::vector<std::uint32_t> addresses;
    for (std::uint32_t at = symbol.address; at < symbol.address + symbol.size;) {
        if (!executed_[at / 2]) addresses.push_back(at);
        at += is_two_words(load<std::uint16_t>(&elf.flash().at(at))) ? 4 : 2;
    }
    return addresses;
}

DeviceFunction::DeviceFunction(Chip& chip, std::string_view symbol, Signature signature)
    : chip_(chip),
      core_(chip.core()),
      symbol_(chip.elf().function(symbol)),
      signature_(std::move(signature)),
      frame_(frame_of(signature_)) {
    if (chip.elf().flash().size() > Elf::flash_size - sizeof end_of_flash)
        throw SimulationError("the program leaves no words of flash free to return to");
    std::memcpy(core_->flash + Elf::flash_size - sizeof end_of_flash, end_of_flash,
                sizeof end_of_flash);
}

Outcome DeviceFunction::call(std::span<const std::uint64_t> operands) {
    if (operands.size() != frame_.operands.size())
        throw SimulationError(fmt::format("{} takes {} operands, got {}", symbol_.name,
                                          frame_.operands.size(), operands.size()));
    std::uint8_t* const data = chip_.data();
    const Interlude interlude(core_);

    // Registers without a meaning hold another value in each call, so that a function that relies
    // on one is detected.
    pattern_ = pattern_ * 6364136223846793005u + 1442695040888963407u;
    for (int i = 0; i < registers; i += 8) std::memcpy(data + i, &pattern_, 8);
    data[zero_register] = 0;
    for (std::size_t i = 0; i < operands.size(); ++i) {
        const Place& place = frame_.operands[i];
        for (int byte = 0; byte < place.size; ++byte)
            data[place.address + byte] = static_cast<std::uint8_t>(operands[i] >> 8 * byte);
    }
    const std::uint16_t entry = frame_.entry_stack_pointer;
    data[entry + 1] = sentinel / 2 >> 8;
    data[entry + 2] = sentinel / 2 & 0xff;
    data[R_SPL] = entry & 0xff;
    data[R_SPH] = entry >> 8;
    chip_.forget_lowest_stack_pointer();

    std::array<std::uint8_t, registers> at_entry;
    std::copy_n(data, registers, at_entry.begin());
    if (watch_writes_) std::copy(data + Chip::ram_begin, data + Chip::ram_end, memory_.begin());

    core_->pc = symbol_.address;
    const Cycle begin = core_->cycle;
    run();
    Outcome outcome;
    outcome.cycles = static_cast<std::uint32_t>(core_->cycle - begin - sleep_cycles + call_cycles);
    outcome.stack_bytes = frame_.caller_stack_pointer() - chip_.lowest_stack_pointer();
    outcome.result = 0;
    std::memcpy(&outcome.result, data + frame_.result.address, signature_.result);

    check_convention(at_entry);
    if (watch_writes_) check_writes();
    return outcome;
}

void DeviceFunction::run() {
    const Cycle limit = core_->cycle + budget_;
    core_->state = cpu_Running;
    while (core_->state == cpu_Running) {
        if (core_->cycle >= limit) chip_.throw_budget_exceeded(budget_);
        core_->run_cycle_count = coverage_ ? 1 : limit - core_->cycle;
        if (coverage_) coverage_->mark(core_->pc);
        core_->pc = avr_run_one(core_);
    }
    if (core_->state == cpu_Sleeping && core_->pc == sentinel + 2) return;
    chip_.throw_if_crashed();
    fail("stopped before it returned");
}

void DeviceFunction::check_convention(std::span<const std::uint8_t> at_entry) {
    const std::uint8_t* const data = chip_.data();
    if (chip_.stack_pointer() != frame_.caller_stack_pointer())
        fail("the stack pointer is not balanced at return");
    if (data[zero_register]) fail("r1 is not zero at return");
    if (core_->sreg[S_I]) fail("interrupts are on at return");
    for (int i = 0; i < registers; ++i)
        if (is_call_saved(i) && data[i] != at_entry[i])
            fail(fmt::format("call-saved register r{} is changed at return", i));
}

void DeviceFunction::forbid_writes_except(std::vector<Area> writable) {
    watch_writes_ = true;
    writable_ = std::move(writable);
    memory_.resize(Chip::ram_end - Chip::ram_begin);
}

void DeviceFunction::check_writes() {
    const std::uint8_t* const data = chip_.data();
    const auto permit = [&](std::uint16_t from, std::uint16_t size) {
        std::copy_n(data + from, size, memory_.begin() + (from - Chip::ram_begin));
    };
    for (const Area& area : writable_) permit(area.address, area.size);
    const std::uint16_t frame = chip_.lowest_stack_pointer() + 1;
    permit(frame, Chip::ram_end - frame);
    const auto [before, after] =
        std::mismatch(memory_.begin(), memory_.end(), data + Chip::ram_begin);
    if (before != memory_.end())
        fail(fmt::format("wrote to 0x{:04x}, outside of its stack frame and its results",
                         after - data));
}

void DeviceFunction::fail(const std::string& reason) const {
    throw SimulationError(fmt::format("{}: {}", symbol_.name, reason));
}

}  // namespace simulator
