// SPDX-License-Identifier: GPL-3.0-or-later
// Times of a step on this machine, from runs that no other load disturbed.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace growth {

constexpr unsigned warm_steps = 256;  // until the lattice has dissolved

// Steps times particles is the same for every run. A processor learns the branches of a short run
// that is repeated: 64 steps of 16 discs then took a quarter less time.
constexpr unsigned timed_steps(unsigned particles) { return (1u << 20) / particles; }

// Makes a world and returns a function that makes that many steps of it.
using Start = std::function<std::function<void(unsigned)>()>;
struct Timed {
    Start start;
    unsigned steps;
};

struct Time {
    double per_step;  // ns of processor time; other programs may have run in between
    std::size_t runs, rejected;
};

// The time of each world. Every run makes the same steps of the same world. Rounds over all worlds,
// at least one, distribute the runs of a world over the whole time, so that a period of load does
// not affect only one. Runs that take over 5% longer than the fastest are rejected, and the result
// is the median of the others. The thread stays on its processor. `progress` is called after each
// world of each round.
std::vector<Time> time_steps(const std::vector<Timed>& worlds, unsigned rounds,
                             const std::function<void()>& progress);

}  // namespace growth
