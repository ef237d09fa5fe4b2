// SPDX-License-Identifier: GPL-3.0-or-later
// What a step of the box costs, by the number of its particles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace growth {

struct Cost {
    std::string broad_phase;  // brute_force, sort_and_sweep, or Box2D's: box2d
    unsigned particles;
    double per_step;           // cycles of the chip in the mean, or the host's median in ns
    double pairs = 0;          // tested in a step, in the mean; 0 where nobody counts, in Box2D
    std::uint32_t ram = 0;     // bytes of the chip
    std::uint32_t stack = 0;   // bytes of the chip
    std::size_t runs = 0;      // on the host, and of them
    std::size_t rejected = 0;  // those that were loaded
};

// On the simulated chip, up to what its memory holds. Throws std::runtime_error where a world
// reports an error, the stack meets the data, or the pairs counted are not of the same motion.
std::vector<Cost> costs_on_chip();

// Of discs in the plane on this machine, in nanoseconds, from 16 to `most`, at most 16,384; every
// pair up to 4,096.
std::vector<Cost> costs_on_host(unsigned most);

}  // namespace growth
