// SPDX-License-Identifier: GPL-3.0-or-later
// What a step of the box costs, by the number of its particles.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace growth {

struct Cost {
    std::string broad_phase;  // brute_force or sort_and_sweep
    unsigned particles;
    double per_step;          // cycles of the chip in the mean, or the host's median in ns
    std::uint32_t ram = 0;    // bytes of the chip
    std::uint32_t stack = 0;  // bytes of the chip
};

// On the simulated chip, up to what its memory holds. Throws std::runtime_error where a world
// reports an error or the stack meets the data.
std::vector<Cost> costs_on_chip();

// On this machine, in nanoseconds, from 2 to `most` particles, at most 4096.
std::vector<Cost> costs_on_host(unsigned most);

}  // namespace growth
