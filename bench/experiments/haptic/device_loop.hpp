// SPDX-License-Identifier: GPL-3.0-or-later
// The device in the loop: a firmware's ELF in the simulated chip, wired to a plant. The plant
// advances only when it is observed: at each conversion, at the end of each servo pulse, and where
// run_until() stops. Everything is measured from outside: at pins, serial port and sleep.
//
//     DeviceLoop loop(Elf("lever.elf"), scenario.adapted(published_parameters()), scenario.script);
//     loop.run_until(2.5);
//     loop.plant().lever_angle(), loop.terminal().screen(), loop.timing().step_begins ...
//
// Pins: PD2 is high while a step is computed, PD3 while a frame is drawn or sent; PD7 is the
// servo's pulse. The program must be a LeverProgram of firmware/lever_program.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/chip/simulator/chip.hpp"
#include "bench/experiments/haptic/plant/plant.hpp"
#include "firmware/tests/terminal_emulator.hpp"

namespace haptic {

using simulator::Cycle;

constexpr double seconds_of(Cycle cycles) {
    return static_cast<double>(cycles) / simulator::Chip::frequency;
}

struct PinEdge {
    Cycle at;
    int pin;  // of port D
    bool level;
};

// From the first step on, in cycles.
struct Timing {
    std::vector<Cycle> step_begins;
    std::vector<std::uint32_t> step_lengths;         // including interrupts
    std::vector<Cycle> frame_begins, frame_lengths;  // from the first drawing to the last sending
    Cycle asleep = 0, rendering = 0;
    std::uint64_t bytes_sent = 0, lines_sent = 0;
    // Of the servo: the number of pulses, and the longest time from the start of one to the next,
    // in s.
    std::uint64_t pulses = 0;
    double shortest_pulse = 1, longest_pulse = 0, longest_period = 0;
};

class DeviceLoop {
  public:
    static constexpr int first_pin = 2, last_pin = 7;
    static constexpr int columns = 20, rows = 20;

    DeviceLoop(const simulator::Elf& elf, Parameters parameters, Script script);

    // Sets the firmware's clock so that its 32 bits wrap this many seconds after reset.
    void wrap_clock_at(double seconds);

    void run_until(double seconds);
    double time() const { return seconds_of(chip_.cycle()); }

    // Like a key pressed on the terminal: requests a full frame.
    void send(std::uint8_t byte) { chip_.send_to_uart(byte); }

    Plant& plant() { return plant_; }
    simulator::Chip& chip() { return chip_; }
    const Timing& timing() const { return timing_; }
    const std::vector<std::string>& screen() const { return terminal_.screen(); }
    double pulse() const { return pulse_; }  // the last pulse, s
    // The length of the virtual arm in the firmware's memory, in m.
    double arm_length() const;
    // Whether the terminal shows what the firmware believes it shows. True while bytes are under
    // way, and always if every frame is sent completely.
    bool screen_is_right() const;

    // Appends all edges from here on.
    void record_edges(std::vector<PinEdge>& edges) { edges_ = &edges; }

  private:
    void at_edge(Cycle at, int pin, bool level);
    void at_byte(std::uint8_t byte);
    std::uint16_t address_of(std::string_view member) const;

    simulator::Chip chip_;
    Plant plant_;
    TerminalEmulator terminal_{columns, rows};
    Timing timing_;
    std::vector<PinEdge>* edges_ = nullptr;
    std::array<Cycle, last_pin + 1> rise_{};
    Cycle last_render_ = 0, last_byte_ = 0;
    double pulse_ = 0;
    bool is_float_;
};

}  // namespace haptic
