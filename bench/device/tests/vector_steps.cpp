// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels of steps, most of which change vectors in place, and of shifts, for
// vector_kernels_test.cpp.
#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/portable/scale_down.hpp>

#define SCALE_DOWN(K) \
    extern "C" int32_t scale_down_##K(int32_t a) { return fixedpoint::portable::scale_down<K>(a); }
#define OF_8(X, a, b, c, d, e, f, g, h) X(a) X(b) X(c) X(d) X(e) X(f) X(g) X(h)
#define ALL_SHIFTS(X)                       \
    OF_8(X, 0, 1, 2, 3, 4, 5, 6, 7)         \
    OF_8(X, 8, 9, 10, 11, 12, 13, 14, 15)   \
    OF_8(X, 16, 17, 18, 19, 20, 21, 22, 23) \
    OF_8(X, 24, 25, 26, 27, 28, 29, 30, 31)
ALL_SHIFTS(SCALE_DOWN)

// References that keep the linker from dropping them.
#define KERNEL(name) reinterpret_cast<void (*)()>(fixedpoint_##name##_q16_16)
void (*const volatile kernels[])() = {
    KERNEL(multiply_short), KERNEL(square2),         KERNEL(square3),         KERNEL(project2),
    KERNEL(project3),       KERNEL(dot_difference2), KERNEL(dot_difference3), KERNEL(add_scaled2),
    KERNEL(add_scaled3),    KERNEL(exchange2),       KERNEL(exchange3)};
#define SHIFT(K) scale_down_##K,
int32_t (*const volatile shifts[])(int32_t) = {ALL_SHIFTS(SHIFT)};

int main() { return kernels[0] != nullptr && shifts[0] != nullptr; }
