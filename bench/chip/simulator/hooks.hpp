// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that run in place of simavr's own at an I/O register or a signal. A hook must live as
// long as the chip and must not be moved, and its function must not throw.
#pragma once

#include <sim_avr.h>

#include <cstdint>
#include <functional>
#include <utility>

namespace simulator {

class WriteHook {
  public:
    using AtWrite = std::function<void(const WriteHook& hook, std::uint8_t value)>;

    WriteHook(avr_t* avr, std::uint16_t address, AtWrite at_write)
        : avr_(avr), address_(address), at_write_(std::move(at_write)) {
        auto& slot = avr->io[AVR_DATA_TO_IO(address)].w;
        simavr_ = slot.c;
        simavr_parameter_ = slot.param;
        slot.c = [](avr_t*, avr_io_addr_t, std::uint8_t value, void* hook) {
            const WriteHook& self = *static_cast<WriteHook*>(hook);
            self.at_write_(self, value);
        };
        slot.param = this;
    }
    WriteHook(const WriteHook&) = delete;

    // Calls simavr's own function.
    void forward(std::uint8_t value) const {
        if (simavr_)
            simavr_(avr_, address_, value, simavr_parameter_);
        else
            avr_->data[address_] = value;
    }

  private:
    avr_t* avr_;
    std::uint16_t address_;
    AtWrite at_write_;
    avr_io_write_t simavr_;
    void* simavr_parameter_;
};

// Replaces what simavr returns for a read.
class ReadHook {
  public:
    ReadHook(avr_t* avr, std::uint16_t address, std::function<std::uint8_t()> at_read)
        : at_read_(std::move(at_read)) {
        auto& slot = avr->io[AVR_DATA_TO_IO(address)].r;
        slot.c = [](avr_t*, avr_io_addr_t, void* hook) {
            return static_cast<ReadHook*>(hook)->at_read_();
        };
        slot.param = this;
    }
    ReadHook(const ReadHook&) = delete;

  private:
    std::function<std::uint8_t()> at_read_;
};

class SignalHook {
  public:
    SignalHook(avr_irq_t* signal, std::function<void(std::uint32_t)> at_raise)
        : at_raise_(std::move(at_raise)) {
        avr_irq_register_notify(
            signal,
            [](avr_irq_t*, std::uint32_t value, void* hook) {
                static_cast<SignalHook*>(hook)->at_raise_(value);
            },
            this);
    }
    SignalHook(const SignalHook&) = delete;

  private:
    std::function<void(std::uint32_t)> at_raise_;
};

// The instruction that is being executed.
inline std::uint16_t current_opcode(const avr_t* avr) {
    return avr->flash[avr->pc] | avr->flash[avr->pc + 1] << 8;
}

}  // namespace simulator
