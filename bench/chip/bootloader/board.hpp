// SPDX-License-Identifier: GPL-3.0-or-later
// An Arduino Nano on a serial port, without the Nano: the simulated chip with a real bootloader in
// its flash and its UART on a pseudo-terminal, which any program that talks to a board can open.
//
// Opening the port resets the chip, as the adapter's DTR line does. Simulated time follows the wall
// clock and never runs ahead of it; if the machine is too busy it falls behind.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/chip/simulator/chip.hpp"

namespace bootloader {

// A bit of the flash that cannot be written.
struct StuckBit {
    std::uint16_t address;
    std::uint8_t mask;
    bool level;
};

class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor();
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    operator int() const { return number_; }

  private:
    int number_;
};

class Board {
  public:
    // Starts a program whose function `bootloader` is the chip's entry after a reset. The rest of
    // the flash is empty. Throws std::system_error if no pseudo-terminal is available.
    //
    // A bootloader gives up on a host that is silent for a second. A `patient` board stops
    // simulated time before that, so that a test whose host gets no processor time still ends well.
    // In return, a program starts only when the host says goodbye or closes the port.
    explicit Board(const std::filesystem::path& bootloader, bool patient);

    const std::string& port() const { return port_; }

    // Waits at most a millisecond for bytes from the port, then lets the chip catch up with the
    // wall clock. Throws simulator::SimulationError if the application runs wild.
    void serve();

    bool in_bootloader() const { return chip_.program_counter() >= entry_; }

    std::vector<std::uint8_t> flash() const;  // all of it, bootloader included
    std::uint32_t bootloader_entry() const { return entry_; }
    // What the application has sent since the last reset.
    const std::string& sent_by_application() const { return sent_by_application_; }
    void set_stuck_bit(std::optional<StuckBit> bit) { stuck_bit_ = bit; }

  private:
    void press_reset(std::uint8_t cause);
    void watch_port();
    void receive();
    bool same_speed() const;
    bool host_is_late() const;
    void run(simulator::Cycle until);
    void send();

    using Clock = std::chrono::steady_clock;

    simulator::Chip chip_;
    std::uint32_t entry_;
    Descriptor terminal_;
    std::string port_;
    const bool patient_;
    bool open_ = false, held_in_reset_ = true;
    std::vector<std::uint8_t> sent_;  // in the run that just ended
    simulator::Cycle last_byte_ = 0;
    Clock::time_point start_;  // of cycle 0, plus the time for which the machine was too busy
    std::string sent_by_application_;
    std::optional<StuckBit> stuck_bit_;
};

}  // namespace bootloader
