// SPDX-License-Identifier: MIT
// The servo's pulse at the start lies within its travel.
#include <firmware/hardware/atmega328p.hpp>

struct Chosen : firmware::Configuration {
    static constexpr uint16_t servo_at_start = 900;
};
template class firmware::Atmega328p<Chosen>;
