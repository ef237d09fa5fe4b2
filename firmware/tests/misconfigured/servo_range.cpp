// SPDX-License-Identifier: MIT
// No hobby servo takes pulses outside 400 to 2600 microseconds.
#include <firmware/hardware/atmega328p.hpp>

struct Chosen : firmware::Configuration {
    static constexpr uint16_t servo_longest = 20000;
};
template class firmware::Atmega328p<Chosen>;
