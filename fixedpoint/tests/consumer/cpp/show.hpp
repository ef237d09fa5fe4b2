// SPDX-License-Identifier: MIT
// show(NAME, NUMBER) prints a line.
#pragma once

#include <fixedpoint/text.hpp>

#include "../console.h"

template <class Number>
static void show(const char* name, Number value) {
    char digits[fixedpoint::text_capacity<Number>()];
    const size_t count = fixedpoint::print(value, digits, sizeof digits);
    while (*name) put(*name++);
    put(' ');
    for (size_t i = 0; i < count; ++i) put(digits[i]);
    put('\n');
}
