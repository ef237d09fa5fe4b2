// SPDX-License-Identifier: GPL-3.0-or-later
// The two divisions whose cycles are studied by operand.
#include <fixedpoint/published/divide.hpp>

extern "C" {
int32_t divide_q16_16_published(int32_t a, int32_t b) {
    return fixedpoint::published::divide<int32_t, 16>(a, b);
}
float divide_float_libc(float a, float b) { return a / b; }
}

int main() {}
