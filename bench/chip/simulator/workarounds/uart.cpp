// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/simulator/workarounds/uart.hpp"

#include <avr_uart.h>

#include <utility>

#include "bench/chip/simulator/registers.hpp"
#include "bench/chip/simulator/workarounds/peripheral.hpp"

namespace simulator {
namespace {

using namespace registers;

constexpr std::size_t receiver_capacity = 3;  // the buffer's two bytes and the shift register

template <auto end_of_frame>
void schedule(avr_t* avr, std::uint32_t cycles, Uart* uart) {
    avr_cycle_timer_register(
        avr, cycles,
        [](avr_t*, avr_cycle_count_t when, void* owner) -> avr_cycle_count_t {
            return (static_cast<Uart*>(owner)->*end_of_frame)(when);
        },
        uart);
}

}  // namespace

Uart::Uart(avr_t* avr)
    : avr_(avr),
      uart_(find_peripheral<avr_uart_t>(avr, "uart", '0')),
      data_(avr, udr0, [this](const WriteHook&, std::uint8_t byte) { write_data(byte); }),
      control_(avr, ucsr0b,
               [this](const WriteHook& hook, std::uint8_t value) {
                   hook.forward(value);
                   update_requests();
               }),
      data_read_(avr, udr0, [this] { return read_data(); }),
      // An interrupt whose cause persists when its handler returns is requested again.
      data_interrupt_(&uart_->udrc.irq[AVR_INT_IRQ_RUNNING],
                      [this](std::uint32_t running) {
                          if (!running) update_requests();
                      }),
      receive_interrupt_(&uart_->rxc.irq[AVR_INT_IRQ_RUNNING], [this](std::uint32_t running) {
          if (!running) update_requests();
      }) {
    std::uint32_t flags = 0;  // neither sleep at polling nor print to the console
    avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
}

void Uart::reset() {
    shift_register_.reset();
    buffer_.reset();
    line_.clear();
    received_.clear();
    avr_regbit_clear(avr_, uart_->txen);
}

std::uint32_t Uart::frame_cycles() const {
    const std::uint8_t* const data = avr_->data;
    const int character_size = (data[ucsr0c] >> 1 & 3) | (data[ucsr0b] & 4);
    const int data_bits = character_size == 7 ? 9 : 5 + (character_size & 3);
    const int parity_bits = data[ucsr0c] >> 5 & 1;
    const int stop_bits = 1 + (data[ucsr0c] >> 3 & 1);
    const int divider = 1 + (data[ubrr0l] | (data[ubrr0h] & 0x0f) << 8);
    const bool double_speed = data[ucsr0a] & 2;
    return (1 + data_bits + parity_bits + stop_bits) * divider * (double_speed ? 8 : 16);
}

// A byte written to a full buffer is lost.
void Uart::write_data(std::uint8_t byte) {
    if (!avr_regbit_get(avr_, uart_->txen) || buffer_) return;
    if (shift_register_) {
        buffer_ = byte;
    } else {
        shift_register_ = byte;
        schedule<&Uart::end_sent_frame>(avr_, frame_cycles(), this);
    }
    update_requests();
}

std::uint64_t Uart::end_sent_frame(std::uint64_t cycle) {
    const std::uint8_t byte = *std::exchange(shift_register_, std::exchange(buffer_, std::nullopt));
    if (shift_register_)
        update_requests();
    else
        avr_raise_interrupt(avr_, &uart_->txc);
    if (sent_) sent_(cycle, byte);
    return shift_register_ ? cycle + frame_cycles() : 0;
}

void Uart::receive(std::uint8_t byte) {
    line_.push_back(byte);
    if (line_.size() == 1) schedule<&Uart::end_received_frame>(avr_, frame_cycles(), this);
}

std::uint64_t Uart::end_received_frame(std::uint64_t cycle) {
    const std::uint8_t byte = line_.front();
    line_.pop_front();
    if (received_.size() == receiver_capacity)
        avr_regbit_set(avr_, uart_->dor);
    else if (avr_regbit_get(avr_, uart_->rxen))
        received_.push_back(byte);
    update_requests();
    return line_.empty() ? 0 : cycle + frame_cycles();
}

std::uint8_t Uart::read_data() {
    std::uint8_t byte = 0;
    if (!received_.empty()) {
        byte = received_.front();
        received_.pop_front();
    }
    avr_regbit_clear(avr_, uart_->dor);
    update_requests();
    return byte;
}

void Uart::update_requests() {
    if (!avr_regbit_get(avr_, uart_->rxen)) received_.clear();
    const auto request = [this](avr_int_vector_t& vector, bool flag) {
        if (flag && avr_regbit_get(avr_, vector.enable))
            avr_raise_interrupt(avr_, &vector);
        else
            avr_clear_interrupt(avr_, &vector);
        avr_regbit_setto(avr_, vector.raised, flag);
    };
    request(uart_->udrc, !buffer_);
    request(uart_->rxc, !received_.empty());
}

}  // namespace simulator
