// SPDX-License-Identifier: MIT
// What must not compile, each with the sentence that says why: read by refused.cmake.
#include <engine.h>

using namespace engine::literals;

namespace {

struct Crowd : engine::Uses {
    static constexpr unsigned particles = 65536;
};
struct Chains : engine::Uses {
    static constexpr unsigned particles = 2, rods = 40000, ropes = 20000, contacts = 5536;
};
struct Opposed : engine::Uses {
    static constexpr unsigned particles = 2, rods = 32768;
    using Solver = engine::WorstFirst<4>;
};
struct Points : engine::Uses {
    static constexpr unsigned particles = 2, planes = 1, contacts = 2;
    static constexpr bool continuous_contacts = true;
};
struct Alone : engine::Uses {
    static constexpr unsigned particles = 1;
};

}  // namespace

engine::World<double, Crowd> crowd;    // refused: A pool holds at most 65535 elements
engine::World<double, Chains> chains;  // refused: Rods, ropes and contacts make at most 65535 rows
engine::World<double, Opposed>
    opposed;  // refused: Rods, ropes and contacts make at most 65535 rows

engine::World<double, Points> points;  // refused: continuous_contacts need radii.

void build() {
    engine::World<double, Alone> world;
    world.add_anchored_rod({}, {0_d, 0_d}, 1_d);  // refused: The scene's Uses does not state this
    // refused: A step of 1 s does not fit a format of one integer bit.
    engine::seconds<engine::Fixed<1, 31>>(engine::BinaryStep<0>());
    // A fraction is no integer of any kind.
    int whole = 0.5_d;            // refused: A decimal constant is a fixed-point
    if (0.5_d) whole = 1;         // refused: A decimal constant is a fixed-point
    unsigned char byte(1_d);      // refused: A decimal constant is a fixed-point
    char16_t letter = -1_d;       // refused: A decimal constant is a fixed-point
    __int128 wide = 0.5_d;        // refused: A decimal constant is a fixed-point
    engine::BinaryStep<-1> back;  // refused: A binary step is 2^-K seconds: K must be in 0..59.
}
