// SPDX-License-Identifier: GPL-3.0-or-later
// Times of a step on this machine, of runs that had the processor to themselves.
#pragma once

#include <functional>

namespace growth {

constexpr unsigned warm_steps = 64, timed_steps = 64;  // until the lattice has dissolved; after it

// Nanoseconds of a step: `start` makes a world, and gives a function that takes that many steps of
// it. Every run makes the same steps of the same world; the result is the median over the runs that
// the scheduler did not interrupt, at least five of them and a fifth of a second in all. Where
// three seconds do not bring five, all runs count, and stderr says so. The thread stays on its
// processor meanwhile.
double nanoseconds_per_step(const char* what,
                            const std::function<std::function<void(unsigned)>()>& start);

}  // namespace growth
