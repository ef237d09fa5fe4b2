// SPDX-License-Identifier: MIT
// receive_capacity must be a power of two up to 128.
#include <firmware/hardware/atmega328p.hpp>

struct Chosen : firmware::Configuration {
    static constexpr uint8_t receive_capacity = 0;
};
template class firmware::Atmega328p<Chosen>;
