// SPDX-License-Identifier: MIT
/// \file
/// A ring of bytes between an interrupt and the program: one writes and the other reads. Both
/// counts run modulo 256, so that all Capacity places are used.
#pragma once

#include <stdint.h>

namespace firmware {

/// A ring of Capacity bytes. Capacity must be a power of two up to 128.
template <uint8_t Capacity>
class RingBuffer {
  public:
    /// The number of bytes in the ring.
    uint8_t size() const { return static_cast<uint8_t>(written_ - read_); }
    /// Whether the ring is empty.
    bool empty() const { return written_ == read_; }
    /// The number of bytes that it has room for.
    uint8_t free() const { return static_cast<uint8_t>(Capacity - size()); }

    /// Appends a byte. There must be room for it.
    void push(uint8_t byte) {
        const uint8_t written = written_;
        bytes_[written % Capacity] = byte;
        written_ = static_cast<uint8_t>(written + 1);
    }
    /// Removes and returns the oldest byte. The ring must not be empty.
    uint8_t pop() {
        const uint8_t read = read_;
        const uint8_t byte = bytes_[read % Capacity];
        read_ = static_cast<uint8_t>(read + 1);
        return byte;
    }

  private:
    volatile uint8_t written_, read_;  // zero at reset, like all static data
    volatile uint8_t bytes_[Capacity];
};

}  // namespace firmware
