// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/simulator/device_function.hpp"

#include <fmt/format.h>
#include <sim_avr.h>
#include <sim_core.h>

#include <algorithm>
#include <utility>

namespace simulator {
namespace {

// A `sleep` in the last word of flash is where functions return to: it stops the core's burst. Two
// illegal words before it stop who strays through the erased flash, which executes as `sbrs`.
constexpr std::uint32_t sentinel = Elf::flash_size - 2;
constexpr std::uint16_t end_of_flash[] = {0x00ff, 0x00ff, 0x9588};
constexpr Cycle sleep_cycles = 1;
constexpr Cycle call_cycles = 4;
constexpr int return_address_size = 2;
constexpr int first_call_saved = 2, register_y = 28;

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

// Interrupts off, and the program afterwards where it was before.
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
      signature_(std::move(signature)) {
    if (chip.elf().flash().size() > Elf::flash_size - sizeof end_of_flash)
        throw SimulationError("the program leaves no words of flash free to return to");
    std::memcpy(core_->flash + Elf::flash_size - sizeof end_of_flash, end_of_flash,
                sizeof end_of_flash);

    // Operands go from r25 downwards, each to an even register; from the first one that would begin
    // below r8 on, all go onto the stack, the first at the lowest address, without padding.
    int next_register = 26;
    std::uint16_t stack_bytes = 0;
    for (const int size : signature_.operands) {
        next_register -= size + size % 2;
        if (next_register < 8) {
            next_register = 0;
            stack_bytes += size;
        }
        places_.push_back({static_cast<std::uint16_t>(next_register), size});
    }
    std::uint16_t address = Chip::ram_end - stack_bytes;
    for (Place& place : places_)
        if (!place.address) place.address = std::exchange(address, address + place.size);
    entry_stack_pointer_ = Chip::ram_end - stack_bytes - return_address_size - 1;

    const int result_size = signature_.result + signature_.result % 2;
    result_register_ = 26 - result_size;
}

Outcome DeviceFunction::call(std::span<const std::uint64_t> operands) {
    if (operands.size() != places_.size())
        throw SimulationError(fmt::format("{} takes {} operands, got {}", symbol_.name,
                                          places_.size(), operands.size()));
    std::uint8_t* const data = chip_.data();
    const Interlude interlude(core_);

    // Registers without a meaning hold another value in each call: who relies on one is found out.
    pattern_ = pattern_ * 6364136223846793005u + 1442695040888963407u;
    for (int i = 0; i < 32; i += 8) std::memcpy(data + i, &pattern_, 8);
    data[1] = 0;
    for (std::size_t i = 0; i < places_.size(); ++i)
        for (int byte = 0; byte < places_[i].size; ++byte)
            data[places_[i].address + byte] = static_cast<std::uint8_t>(operands[i] >> 8 * byte);
    data[entry_stack_pointer_ + 1] = sentinel / 2 >> 8;
    data[entry_stack_pointer_ + 2] = sentinel / 2 & 0xff;
    data[R_SPL] = entry_stack_pointer_ & 0xff;
    data[R_SPH] = entry_stack_pointer_ >> 8;
    chip_.forget_lowest_stack_pointer();

    const auto saved_low = load<std::uint64_t>(data + first_call_saved);
    const auto saved_high = load<std::uint64_t>(data + first_call_saved + 8);
    const auto saved_y = load<std::uint16_t>(data + register_y);
    if (watch_writes_) std::copy(data + Chip::ram_begin, data + Chip::ram_end, memory_.begin());

    core_->pc = symbol_.address;
    const Cycle begin = core_->cycle;
    run();
    Outcome outcome;
    outcome.cycles = static_cast<std::uint32_t>(core_->cycle - begin - sleep_cycles + call_cycles);
    outcome.stack_bytes = entry_stack_pointer_ + return_address_size - chip_.lowest_stack_pointer();
    outcome.result = 0;
    std::memcpy(&outcome.result, data + result_register_, signature_.result);

    check_convention(saved_low, saved_high, saved_y);
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

void DeviceFunction::check_convention(std::uint64_t saved_low, std::uint64_t saved_high,
                                      std::uint16_t saved_y) {
    const std::uint8_t* const data = chip_.data();
    if (chip_.stack_pointer() != entry_stack_pointer_ + return_address_size)
        fail("the stack pointer is not balanced at return");
    if (data[1]) fail("r1 is not zero at return");
    if (core_->sreg[S_I]) fail("interrupts are on at return");
    if (load<std::uint64_t>(data + first_call_saved) != saved_low)
        fail("a call-saved register of r2..r9 is changed at return");
    if (load<std::uint64_t>(data + first_call_saved + 8) != saved_high)
        fail("a call-saved register of r10..r17 is changed at return");
    if (load<std::uint16_t>(data + register_y) != saved_y) fail("r29:r28 is changed at return");
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
