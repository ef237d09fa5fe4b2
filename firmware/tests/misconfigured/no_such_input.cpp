// SPDX-License-Identifier: MIT
// The ATmega328P has the analogue inputs 0 to 7.
#include <firmware/hardware/atmega328p.hpp>

struct Chosen : firmware::Configuration {
    static constexpr uint8_t sensor_a_input = 8;
};
template class firmware::Atmega328p<Chosen>;
