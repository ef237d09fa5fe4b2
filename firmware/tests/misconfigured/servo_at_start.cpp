// SPDX-License-Identifier: MIT
// servo_at_start must be from servo_shortest to servo_longest.
#include <firmware/hardware/atmega328p.hpp>

struct Chosen : firmware::Configuration {
    static constexpr uint16_t servo_at_start = 900;
};
template class firmware::Atmega328p<Chosen>;
