// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of a step of the box, by the number of particles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace growth {

struct Cost {
    std::string broad_phase;  // brute_force, sort_and_sweep, or Box2D's: box2d
    unsigned particles;
    double per_step;           // mean cycles of the chip, or the host's median in ns
    double pairs = 0;          // tested in a step, on average; 0 if not counted, as in Box2D
    std::uint32_t ram = 0;     // bytes of the chip
    std::uint32_t stack = 0;   // bytes of the chip
    std::size_t runs = 0;      // runs on the host
    std::size_t rejected = 0;  // those of them that other load disturbed
};

// On the simulated chip, up to what its memory holds. Throws std::runtime_error if a world reports
// an error, if the stack meets the data, or if the counted run differs in its motion.
std::vector<Cost> costs_on_chip();

// For discs in the plane on this machine, in nanoseconds, from 16 to `most`, which must be at most
// 16,384. Every pair only up to 4,096. Each box is run `rounds` times, which must be at least 1.
std::vector<Cost> costs_on_host(unsigned most, unsigned rounds);

}  // namespace growth
