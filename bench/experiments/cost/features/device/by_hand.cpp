// SPDX-License-Identifier: GPL-3.0-or-later
// The lever's step without the engine: the same sums and products of the library in the same order,
// simplified for this one scene. The arm is 1/4 m long, so that products with its length and its
// inverse are shifts; the end is always close to that distance; nothing else acts.
#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/portable/scale_down.hpp>

using Raw = int32_t;
using namespace fixedpoint::kernel;
using fixedpoint::portable::scale_down;

constexpr int fraction_bits = 16, step_bits = 10;
constexpr Raw one = Raw(1) << fraction_bits;
constexpr Raw raw(double x) { return static_cast<Raw>(x * one + (x < 0 ? -0.5 : 0.5)); }

struct Lever {
    Raw position[2], velocity[2];  // m, m/s
    Raw pivot[2], gravity[2];      // m, m/s^2
    Raw force[2], inverse_mass;    // N, in this step; 1/kg
};
Lever lever;

// sum += rate 2^-step_bits.
inline void integrate(Raw* sum, const Raw* rate) {
    sum[0] += scale_down<step_bits>(rate[0]);
    sum[1] += scale_down<step_bits>(rate[1]);
}

extern "C" {

__attribute__((noinline)) unsigned char build() {
    lever = {{raw(0.14), raw(0.08)}, {0, 0}, {raw(0.38), raw(0.15)}, {0, raw(-9.81)},
             {raw(0.3), raw(0.5)},   raw(10)};
    return 0;
}

__attribute__((noinline)) void step() {
    Lever& l = lever;
    Raw acceleration[2] = {l.gravity[0], l.gravity[1]};
    add_scaled2<Raw, fraction_bits>(acceleration, l.force, l.inverse_mass);
    integrate(l.velocity, acceleration);

    // The direction, and by how much its length exceeds 1.
    Raw n[2] = {(l.position[0] - l.pivot[0]) * 4, (l.position[1] - l.pivot[1]) * 4};
    Raw e = (square2<Raw, fraction_bits>(n) - one) >> 1;
    if (e > 4 || e < -4) {
        const Raw square = multiply<Raw, fraction_bits>(e, e);
        add_scaled2<Raw, fraction_bits>(n, n, square + (square >> 1) - e);
        e -= square >> 1;
    }

    // The velocity along the chord of the arc, and the end moved back onto the arc.
    const Raw half_way[2] = {scale_down<step_bits + 1>(l.velocity[0]),
                             scale_down<step_bits + 1>(l.velocity[1])};
    const Raw chord = project2<Raw, fraction_bits>(half_way, l.velocity) * 4;
    const Raw excess = scale_down<2>(e);
    if (excess != 0) add_scaled2<Raw, fraction_bits>(l.position, n, -excess);
    const Raw change = -chord - project2<Raw, fraction_bits>(n, l.velocity);
    if (change != 0) add_scaled2<Raw, fraction_bits>(l.velocity, n, change);
    integrate(l.position, l.velocity);
}
}

int main() {
    build();
    for (;;) step();
}
