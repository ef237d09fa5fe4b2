// SPDX-License-Identifier: MIT
// Numbers for a debugger to display.
#include <fixedpoint.h>

#include <engine/pool.hpp>
#include <engine/vector.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>

using namespace fixedpoint;
using namespace fixedpoint::literals;

struct Point {
    Q16_16 x, y;
};

// The debugger stops here.
template <class Object>
__attribute__((noinline)) void inspect(const Object&) {}

int main() {
    Q16_16 x = 0.38_q16_16;
    Q16_16 negative = -x, least = Q16_16::min(), zero;
    Q4_4 narrow = Q4_4::from_raw(-1);
    Q8_8 rounded = Q8_8::from_raw(0x17f);
    Q32_32 wide = 3.14159265358979323846_q32_32;
    Fixed<1, 15, Saturating> sine = Fixed<1, 15, Saturating>::max();
    Fixed<8, 0> whole = Fixed<8, 0>::from_raw(-7);
    Point point = {x, negative};
    Q16_16 row[2] = {x, x};
    engine::Vector<Q16_16, 2> position;
    position[0] = x;
    position[1] = negative;
    engine::Pool<Q8_8, 4> pool;
    pool.append(rounded);
    pool.append(1.5_q8_8);
    engine::Pool<Q8_8, 0> empty;
    inspect(least);
    inspect(zero);
    inspect(narrow);
    inspect(wide);
    inspect(sine);
    inspect(whole);
    inspect(point);
    inspect(row);
    inspect(empty);
    // The expressions of the natvis files are evaluated in these members.
    return x.raw() == pool.size() || position[1] == x;
}
