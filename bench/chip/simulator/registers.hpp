// SPDX-License-Identifier: GPL-3.0-or-later
// Data-space addresses of the ATmega328P's I/O registers that the simulator uses (data sheet,
// section "Register Summary").
#pragma once

#include <cstdint>

namespace simulator::registers {

constexpr std::uint16_t pinb = 0x23, pinc = 0x26, pind = 0x29;
constexpr std::uint16_t tifr0 = 0x35, tifr1 = 0x36, tifr2 = 0x37;
constexpr std::uint16_t gpior0 = 0x3e;
constexpr std::uint16_t eearh = 0x42;
constexpr std::uint16_t spl = 0x5d, sph = 0x5e;
constexpr std::uint16_t adcl = 0x78, adch = 0x79, admux = 0x7c;
constexpr std::uint16_t ocr1al = 0x88, ocr1bl = 0x8a;
constexpr std::uint16_t ucsr0a = 0xc0, ucsr0b = 0xc1, ucsr0c = 0xc2, ubrr0l = 0xc4, ubrr0h = 0xc5,
                        udr0 = 0xc6;

}  // namespace simulator::registers
