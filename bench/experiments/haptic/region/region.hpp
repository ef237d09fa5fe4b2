// SPDX-License-Identifier: GPL-3.0-or-later
// The stable region of a lever that is held at rest: arm length x loop rate x stiffness of the
// hand, for each arithmetic, with and without the selective damping, over plants that behave as
// published.
#pragma once

#include <filesystem>

namespace haptic::region {

struct Options {
    std::filesystem::path output;
    bool quick = false;
    unsigned threads = 1;
};

// Determined on the host and checked on the simulated chip. Writes
//   identification.csv  the plants that were drawn, and which of them behave as published
//   stable_region.csv   how many plants of the family are at rest, over the whole region, and how
//                       many of them the linear theory calls stable
//   stable_limits.csv   for each plant: the shortest arm, the softest and the hardest hand
//   stable_changes.csv  the flashed lever with each of its stabilising measures left out in turn,
//                       and the other levers
//   stable_on_chip.csv  the verdicts of host and chip, plant by plant
//   oscillation.csv     a poked lever over time, on the chip, with and without the damping
void measure_region(const Options& options);

}  // namespace haptic::region
