// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels that change vectors in place, for vector_kernels_test.cpp.
#include <fixedpoint/kernel/dispatch.hpp>

// The linker keeps what is referred to.
#define KERNEL(name) reinterpret_cast<void (*)()>(fixedpoint_##name##_q16_16)
void (*const volatile kernels[])() = {
    KERNEL(project2),    KERNEL(project3),    KERNEL(dot_difference2), KERNEL(dot_difference3),
    KERNEL(add_scaled2), KERNEL(add_scaled3), KERNEL(exchange2),       KERNEL(exchange3)};

int main() { return kernels[0] != nullptr; }
