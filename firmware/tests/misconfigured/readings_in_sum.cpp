// SPDX-License-Identifier: MIT
// readings_in_sum must be a power of two up to 32
#include <firmware/hardware/atmega328p.hpp>

struct Chosen : firmware::Configuration {
    static constexpr uint8_t readings_in_sum = 3;
};
template class firmware::Atmega328p<Chosen>;
