// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/haptic/device_loop.hpp"

#include <fmt/format.h>
#include <sim_avr.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "firmware/src/firmware/hardware/readings.hpp"

namespace haptic {
namespace {

using simulator::Chip;
using simulator::Elf;

enum DevicePin { step_pin = 2, render_pin = 3, servo_pin = 7 };

// A frame starts with the first rendering after a pause. Its rows follow every 0.1 ms, except for
// the steps in between, which take at most 12 ms.
constexpr Cycle pause_between_frames = 15 * Chip::frequency / 1000;

}  // namespace

DeviceLoop::DeviceLoop(const Elf& elf, Parameters parameters, Script script)
    : chip_(elf), plant_(std::move(parameters), std::move(script)) {
    is_float_ = std::any_of(elf.objects().begin(), elf.objects().end(), [](const auto& object) {
        return object.first.find("LeverChoicesIf") != std::string::npos;
    });
    chip_.on_conversion([this](Cycle at, int channel) {
        plant_.advance_to(seconds_of(at));
        return plant_.voltage(channel);
    });
    for (int pin = first_pin; pin <= last_pin; ++pin)
        chip_.on_edge({'D', pin}, [this, pin](Cycle at, bool level) { at_edge(at, pin, level); });
    chip_.on_uart_byte([this](Cycle at, std::uint8_t byte) {
        last_byte_ = at;
        at_byte(byte);
    });
}

void DeviceLoop::wrap_clock_at(double seconds) {
    chip_.run_until_function("main");
    constexpr double overflow = 65536.0 / firmware::ticks_per_second;
    const auto ahead = static_cast<std::uint16_t>(std::lround(seconds / overflow));
    const std::uint16_t overflows = 0 - ahead;
    const std::uint8_t bytes[] = {static_cast<std::uint8_t>(overflows),
                                  static_cast<std::uint8_t>(overflows >> 8)};
    chip_.write(address_of("overflows_"), bytes);
}

// One step at a time while awake, so that the cycles of sleep are counted exactly.
void DeviceLoop::run_until(double seconds) {
    const auto end = static_cast<Cycle>(std::llround(seconds * Chip::frequency));
    while (chip_.cycle() < end) {
        const bool asleep = chip_.core()->state == cpu_Sleeping;
        const Cycle before = chip_.cycle();
        chip_.step();
        if (asleep && !timing_.step_begins.empty()) timing_.asleep += chip_.cycle() - before;
    }
    plant_.advance_to(seconds);
}

void DeviceLoop::at_edge(Cycle at, int pin, bool level) {
    if (edges_) edges_->push_back({at, pin, level});
    const Cycle length = at - rise_[pin];
    if (pin == step_pin) {
        if (level) {
            timing_.step_begins.push_back(at);
        } else {
            timing_.step_lengths.push_back(static_cast<std::uint32_t>(length));
        }
    } else if (pin == render_pin) {
        if (level && at - last_render_ > pause_between_frames) {
            if (!timing_.frame_begins.empty())
                timing_.frame_lengths.push_back(last_render_ - timing_.frame_begins.back());
            timing_.frame_begins.push_back(at);
        }
        if (!level) timing_.rendering += length;
        last_render_ = at;
    } else if (pin == servo_pin) {
        if (level && timing_.pulses != 0)
            timing_.longest_period = std::max(timing_.longest_period, seconds_of(length));
        if (!level) {
            pulse_ = seconds_of(length);
            ++timing_.pulses;
            timing_.shortest_pulse = std::min(timing_.shortest_pulse, pulse_);
            timing_.longest_pulse = std::max(timing_.longest_pulse, pulse_);
            plant_.servo_pulse(pulse_, seconds_of(at));
        }
    }
    if (level) rise_[pin] = at;
}

void DeviceLoop::at_byte(std::uint8_t byte) {
    ++timing_.bytes_sent;
    timing_.lines_sent += byte == '\n';
    terminal_.take(static_cast<char>(byte));
}

// A static member of the program's classes, by the end of its mangled name. The guard of its
// initialisation ends with the same name.
std::uint16_t DeviceLoop::address_of(std::string_view member) const {
    const std::string end = fmt::format("{}{}E", member.size(), member);
    for (const auto& [name, object] : chip_.elf().objects())
        if (name.starts_with("_ZN") && name.ends_with(end))
            return static_cast<std::uint16_t>(object.address);
    throw simulator::SimulationError(
        fmt::format("{}: no variable '{}', as firmware/lever_program.hpp has",
                    chip_.elf().path().string(), member));
}

double DeviceLoop::arm_length() const {
    const std::uint16_t address = address_of("lever");
    std::uint32_t bits = 0;
    for (int i = 3; i >= 0; --i)
        bits = bits << 8 | chip_.read(static_cast<std::uint16_t>(address + i));
    const double inverse = is_float_ ? static_cast<double>(std::bit_cast<float>(bits))
                                     : static_cast<std::int32_t>(bits) / 65536.0;
    return 1 / inverse;
}

// The renderer starts with a flag whether the screen is known, followed by two bits per cell of it.
bool DeviceLoop::screen_is_right() const {
    const bool under_way = chip_.cycle() - last_byte_ < Chip::frequency / 1000 ||
                           chip_.cycle() - last_render_ < Chip::frequency / 1000;
    if (under_way || timing_.lines_sent != 0) return true;
    const std::uint16_t address = address_of("renderer");
    if (!chip_.read(address)) return true;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const auto at =
                static_cast<std::uint16_t>(address + 1 + row * columns / 4 + column / 4);
            const int colour = chip_.read(at) >> column % 4 * 2 & 3;
            if (terminal_.screen()[static_cast<std::size_t>(rows - 1 - row)]
                                  [static_cast<std::size_t>(column)] != " .o#"[colour])
                return false;
        }
    return true;
}

}  // namespace haptic
