// SPDX-License-Identifier: GPL-3.0-or-later
// Which plants behave as the report says of the device of 2016: its lever falls in the time that is
// given, and swings when a hand holds it, both without the selective damping that the report added
// later to cure the swing. The data sheets leave 17 numbers of the plant open, so that many plants
// do: the numbers are not known by this, the family is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "bench/experiments/haptic/plant/parameters.hpp"
#include "bench/lab/records/csv.hpp"

namespace haptic::region {

struct Identification {
    struct Draw {
        std::uint64_t seed;
        Parameters plant;
        std::optional<double> fall;  // s, undamped; none where it does not fall
        double swing;                // rad, held, undamped; 0 where the fall is not as published
        bool as_published;
    };
    std::vector<Draw> draws;  // by rising seed from 1

    // The first `count` plants that behave as published. Throws std::out_of_range where there are
    // fewer.
    std::vector<Parameters> plants(std::size_t count) const;
};

// Draws plants until so many behave as published; std::runtime_error where of 50 times as many not
// enough do. A step of the device of 2016 takes so long, in s.
Identification identify(std::size_t count, double step_takes, unsigned threads);

// A row a draw: its numbers, each over the middle of its range, the falls of the device of 2016, in
// s, with and without the selective damping, and whether it behaves as published.
records::Table table_of(const Identification& identification, double step_takes, unsigned threads);

}  // namespace haptic::region
