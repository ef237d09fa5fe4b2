// SPDX-License-Identifier: MIT
// transmit_capacity must be a power of two from 16
#include <firmware/hardware/atmega328p.hpp>

struct Chosen : firmware::Configuration {
    static constexpr uint8_t transmit_capacity = 100;
};
template class firmware::Atmega328p<Chosen>;
