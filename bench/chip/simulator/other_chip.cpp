// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/simulator/other_chip.hpp"

#include <fmt/format.h>
#include <sim_avr.h>
#include <sim_core.h>
#include <sim_elf.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <new>

#include "bench/chip/simulator/chip.hpp"

namespace simulator {
namespace {

constexpr std::uint64_t call_budget = 4'000'000;  // cycles; the slowest portable function: 500000
constexpr int registers = 32;

// simavr reports a fault by a message and continues; the run ends by its budget.
void silence(avr_t*, int, const char*, va_list) {}

}  // namespace

OtherChip::OtherChip(const std::string& name, const std::filesystem::path& program)
    : avr_(avr_make_mcu_by_name(name.c_str())) {
    if (!avr_) throw SimulationError(fmt::format("simavr does not know the chip '{}'", name));
    avr_global_logger_set(silence);
    avr_init(avr_);
    // simavr lets a program write beyond the RAM; its addresses have 16 bits.
    constexpr std::size_t address_space = 0x10000;
    auto* const wider = static_cast<std::uint8_t*>(std::realloc(avr_->data, address_space));
    if (!wider) throw std::bad_alloc();
    std::fill(wider + avr_->ramend + 1, wider + address_space, 0);
    data_ = avr_->data = wider;

    elf_firmware_t firmware{};
    if (elf_read_firmware(program.c_str(), &firmware) != 0 ||
        firmware.flashbase + firmware.flashsize > avr_->flashend)
        throw SimulationError(fmt::format("{}: no program for the {}", program.string(), name));
    avr_load_firmware(avr_, &firmware);
    for (std::uint32_t i = 0; i < firmware.symbolcount; ++i)
        symbols_.emplace(firmware.symbol[i]->symbol, firmware.symbol[i]->addr);
    const auto main = symbols_.find("main"), end = symbols_.find("_end");
    if (main == symbols_.end() || end == symbols_.end())
        throw SimulationError(fmt::format("{}: has no main() or no _end", program.string()));
    free_ = static_cast<std::uint16_t>(end->second);
    run_to(main->second, call_budget, "start-up code");
    // Functions return to a `sleep` in the last word of flash, which stops the core.
    constexpr std::uint16_t sleep = 0x9588;
    std::memcpy(avr_->flash + avr_->flashend - 1, &sleep, sizeof sleep);
}

OtherChip::~OtherChip() { avr_terminate(avr_); }

void OtherChip::run_to(std::uint32_t address, std::uint64_t budget, std::string_view what) {
    const std::uint64_t limit = avr_->cycle + budget;
    avr_->state = cpu_Running;
    while (avr_->pc != address) {
        if (avr_->state != cpu_Running || avr_->cycle >= limit)
            throw SimulationError(fmt::format("{}: does not return", what));
        avr_->run_cycle_count = 1;
        avr_->pc = avr_run_one(avr_);
    }
}

std::uint16_t OtherChip::allocate(std::size_t bytes) {
    const std::uint16_t address = free_;
    free_ = static_cast<std::uint16_t>(free_ + bytes);
    return address;
}

OtherChip::Outcome OtherChip::call(const std::string& function, const Signature& signature,
                                   std::span<const std::uint64_t> operands) {
    const auto symbol = symbols_.find(function);
    if (symbol == symbols_.end())
        throw SimulationError(fmt::format("{}: the program has no such function", function));
    const Frame frame = frame_of(signature);
    // The frame is that of the ATmega328P. On other chips the RAM ends at another address.
    const int shift = avr_->ramend + 1 - Chip::ram_end;
    for (int i = 0; i < registers; ++i) data_[i] = static_cast<std::uint8_t>(0xa5 ^ 37 * i);
    data_[zero_register] = 0;
    for (std::size_t i = 0; i < operands.size(); ++i) {
        const Place& place = frame.operands[i];
        std::memcpy(data_ + place.address + (place.in_registers() ? 0 : shift), &operands[i],
                    static_cast<std::size_t>(place.size));
    }
    std::array<std::uint8_t, registers> at_entry;
    std::copy_n(data_, registers, at_entry.begin());

    // The low byte of the return address is on top.
    const std::uint32_t sentinel = avr_->flashend - 1;
    const int caller = frame.caller_stack_pointer() + shift, entry = caller - avr_->address_size;
    for (int i = 0; i < avr_->address_size; ++i)
        data_[caller - i] = static_cast<std::uint8_t>(sentinel / 2 >> 8 * i);
    data_[R_SPL] = static_cast<std::uint8_t>(entry);
    data_[R_SPH] = static_cast<std::uint8_t>(entry >> 8);
    avr_->pc = symbol->second;
    avr_->sreg[S_I] = 0;
    const std::uint64_t begin = avr_->cycle;
    run_to(sentinel, call_budget, function);

    const int stack = data_[R_SPL] | data_[R_SPH] << 8;
    bool kept = stack == caller && data_[zero_register] == 0;
    for (int i = 0; i < registers; ++i) kept &= !is_call_saved(i) || data_[i] == at_entry[i];
    if (!kept) throw SimulationError(fmt::format("{}: breaks the calling convention", function));
    // `call` takes two cycles more than the bytes of its address; a chip of 8 KB has only `rcall`.
    const int of_call = avr_->flashend < 0x2000 ? 3 : 2 + avr_->address_size;
    Outcome outcome{0, static_cast<std::uint32_t>(avr_->cycle - begin) + of_call};
    std::memcpy(&outcome.result, data_ + frame.result.address,
                static_cast<std::size_t>(signature.result));
    return outcome;
}

}  // namespace simulator
