// SPDX-License-Identifier: MIT
/// \file
/// A ring of bytes between an interrupt and the program, one of which writes and the other reads.
/// Both counts run on modulo 256, so that every one of the Capacity places is used.
#pragma once

#include <stdint.h>

namespace firmware {

/// A ring of Capacity bytes, a power of two up to 128.
template <uint8_t Capacity>
class RingBuffer {
  public:
    /// The bytes in it.
    uint8_t size() const { return static_cast<uint8_t>(written_ - read_); }
    /// Whether there are none.
    bool empty() const { return written_ == read_; }
    /// The room for more.
    uint8_t free() const { return static_cast<uint8_t>(Capacity - size()); }

    /// Where there is room.
    void push(uint8_t byte) {
        const uint8_t written = written_;
        bytes_[written % Capacity] = byte;
        written_ = static_cast<uint8_t>(written + 1);
    }
    /// Where there is a byte.
    uint8_t pop() {
        const uint8_t read = read_;
        const uint8_t byte = bytes_[read % Capacity];
        read_ = static_cast<uint8_t>(read + 1);
        return byte;
    }

  private:
    volatile uint8_t written_, read_;  // zero at reset, as all static data
    volatile uint8_t bytes_[Capacity];
};

}  // namespace firmware
