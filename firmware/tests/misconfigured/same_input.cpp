// SPDX-License-Identifier: MIT
// The two sensors and the dial need an analogue input each.
#include <firmware/hardware/atmega328p.hpp>

struct Chosen : firmware::Configuration {
    static constexpr uint8_t dial_input = 1;
};
template class firmware::Atmega328p<Chosen>;
