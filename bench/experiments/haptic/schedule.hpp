// SPDX-License-Identifier: GPL-3.0-or-later
// When the device does what: the schedule of firmware/hardware/atmega328p.hpp on the chip.
#pragma once

namespace haptic {

// In seconds; times are from reset.
struct Schedule {
    // One conversion after another: 13 of the converter's clocks, and the interrupt that starts the
    // next one. The inputs take turns.
    static constexpr double first_conversion = 0.32e-3, conversion = 106.7e-6;
    static constexpr double conversion_lasts = 106e-6;  // from its sample to its reading
    static constexpr unsigned inputs = 3, readings_in_sum = 2;

    static constexpr double first_frame = 1.32e-3, frame = 20e-3;

    // The mean age of the readings in a sum when a step uses it.
    static constexpr double mean_reading_age() {
        return conversion_lasts + inputs * conversion * readings_in_sum / 2;
    }
};

}  // namespace haptic
