// SPDX-License-Identifier: GPL-3.0-or-later
// A program that uses only multiplication of the library.
#include <fixedpoint/fixed.hpp>

volatile int32_t raw;

int main() {
    using fixedpoint::Q16_16;
    raw = (Q16_16::from_raw(raw) * Q16_16::from_raw(raw)).raw();
}
