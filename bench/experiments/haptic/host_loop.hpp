// SPDX-License-Identifier: GPL-3.0-or-later
// The firmware's lever on the host, wired to a plant by the chip's schedule: the same code with, in
// fixed point, bit-identical arithmetic, some forty times as fast as the simulated chip. The
// schedule ignores the jitter caused by interrupts, a few microseconds.
//
//     HostLoop<firmware::LeverChoices<firmware::LeverScalar>> loop(parameters, script, 0.36e-3);
//     loop.run_until(2.5);
//     loop.plant().lever_angle(), loop.pulse() ...
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <firmware/lever.hpp>
#include <optional>
#include <utility>

#include "bench/experiments/haptic/plant/plant.hpp"
#include "bench/experiments/haptic/schedule.hpp"

namespace haptic {

template <class Choices>
class HostLoop {
  public:
    using Lever = firmware::Lever<Choices>;

    // `step_takes` is the time in s from a step's readings to its pulse.
    HostLoop(Parameters parameters, Script script, double step_takes)
        : plant_(std::move(parameters), std::move(script)), step_takes_(step_takes) {}

    // Processes each event at its time: a sample, its reading, a step that is due, the servo's
    // edges.
    void run_until(double seconds) {
        for (;;) {
            const double rise =
                Schedule::first_frame + Schedule::frame * static_cast<double>(frames_);
            const double reading = sample_time() + Schedule::conversion_lasts;
            if (fall_ && *fall_ <= std::min(rise, reading)) {
                if (*fall_ > seconds) break;
                plant_.servo_pulse(pulse_, *fall_);
                fall_.reset();
            } else if (rise <= reading) {
                if (rise > seconds) break;
                ++frames_;
                // The length of a pulse is fixed when it starts.
                take_command(rise);
                pulse_ = static_cast<double>(commanded_) / firmware::ticks_per_second;
                fall_ = rise + pulse_;
            } else {
                if (reading > seconds) break;
                convert(reading);
            }
        }
        plant_.advance_to(seconds);
    }

    Plant& plant() { return plant_; }
    Lever& lever() { return lever_; }
    double pulse() const { return pulse_; }  // the last pulse, s
    std::uint64_t steps() const { return steps_done_; }

  private:
    static constexpr std::uint16_t shortest = 1000 * firmware::ticks_per_microsecond;
    static constexpr std::uint16_t longest = 1667 * firmware::ticks_per_microsecond;

    double sample_time() const {
        return Schedule::first_conversion +
               Schedule::conversion * static_cast<double>(conversions_);
    }

    // The interrupt at the end of a conversion wakes the program, which then makes a step if one is
    // due.
    void convert(double now) {
        const int input = static_cast<int>(conversions_ % Schedule::inputs);
        plant_.advance_to(sample_time());
        const ElectricalParameters& electrical = plant_.parameters().electrical;
        const double counts = plant_.voltage(input) / electrical.supply * 1024;
        history_[conversions_ % history_.size()] =
            static_cast<std::uint16_t>(std::min(counts, 1023.0));
        ++conversions_;
        take_command(now);
        if (now < busy_until_) return;
        const auto ticks = static_cast<std::uint32_t>(now * firmware::ticks_per_second);
        if (const auto length = scheduled_.due(ticks)) {
            firmware::Readings readings{};
            for (std::size_t i = 0; i < history_.size(); ++i)
                readings.sum[i % Schedule::inputs] =
                    static_cast<std::uint16_t>(readings.sum[i % Schedule::inputs] + history_[i]);
            next_command_ = lever_.step(readings, Choices::time_step(length));
            busy_until_ = now + step_takes_;
            scheduled_.done(static_cast<std::uint32_t>(busy_until_ * firmware::ticks_per_second));
            ++steps_done_;
        }
    }
    void take_command(double now) {
        if (!next_command_ || now < busy_until_) return;
        commanded_ = std::clamp(*next_command_, shortest, longest);
        next_command_.reset();
    }

    Plant plant_;
    Lever lever_;
    const double step_takes_;
    typename Choices::Steps scheduled_{
        static_cast<std::uint32_t>(Schedule::first_conversion * firmware::ticks_per_second)};
    std::array<std::uint16_t, Schedule::inputs * Schedule::readings_in_sum> history_{};
    std::uint64_t conversions_ = 0, frames_ = 0, steps_done_ = 0;
    std::optional<std::uint16_t> next_command_;
    std::uint16_t commanded_ = shortest;
    double busy_until_ = 0, pulse_ = 0;
    std::optional<double> fall_;
};

}  // namespace haptic
