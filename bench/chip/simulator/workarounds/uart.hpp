// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>

#include "bench/chip/simulator/hooks.hpp"

struct avr_uart_t;

namespace simulator {

// USART0. Only the registers and the interrupt vectors are still simavr's.
//
// simavr: every frame has 11 bits, whatever UCSR0C says; the transmitter has no buffer behind UDR0,
// so that UDRE0 returns a frame late; a byte counts as sent when it is written; the transmitter is
// on after reset; the receiver lets the program read bytes as fast as it can, and buffers 64 of
// them; polling UCSR0A makes the host sleep.
//
// Hardware (data sheet, "USART0"): a frame is a start bit, data bits, a parity bit if any, and one
// or two stop bits: 40 us at 250000 baud 8N1. UDR0 is double-buffered: UDRE0 is set as soon as the
// shift register takes the byte, TXC0 when the last frame ends. The receiver holds two bytes and a
// third in its shift register; a fourth is lost and sets DOR0. The interrupts of UDRE0 and RXC0 are
// requested as long as the flag is set. Here a frame starts immediately, where the hardware waits
// for the next tick of its baud rate clock, at most one bit later.
class Uart {
  public:
    using Sent = std::function<void(std::uint64_t cycle, std::uint8_t byte)>;

    explicit Uart(avr_t* avr);
    void reset();                                         // after each reset of simavr
    void on_sent(Sent sent) { sent_ = std::move(sent); }  // at the end of each frame's last bit
    void receive(std::uint8_t byte);                      // queues behind the byte on the line

  private:
    std::uint32_t frame_cycles() const;
    void write_data(std::uint8_t byte);
    std::uint8_t read_data();
    std::uint64_t end_sent_frame(std::uint64_t cycle);      // returns the next end, 0 for none
    std::uint64_t end_received_frame(std::uint64_t cycle);  // likewise
    void update_requests();

    avr_t* avr_;
    avr_uart_t* uart_;
    Sent sent_;
    std::optional<std::uint8_t> shift_register_, buffer_;
    std::deque<std::uint8_t> line_, received_;
    WriteHook data_, control_;
    ReadHook data_read_;
    SignalHook data_interrupt_, receive_interrupt_;
};

}  // namespace simulator
