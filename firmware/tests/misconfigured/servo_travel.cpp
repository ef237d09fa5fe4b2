// SPDX-License-Identifier: MIT
// servo_shortest must be less than servo_longest.
#include <firmware/hardware/atmega328p.hpp>

struct Chosen : firmware::Configuration {
    static constexpr uint16_t servo_shortest = 1500;
    static constexpr uint16_t servo_longest = 1500;
};
template class firmware::Atmega328p<Chosen>;
