// SPDX-License-Identifier: GPL-3.0-or-later
// Which plants behave as the 2016 design is said to have behaved: its lever falls in the given
// time, and swings when a hand holds it, both without the selective damping that was added later to
// cure the swing. The data sheets leave 17 numbers of the plant open, so many plants do. This
// identifies a family, not the numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "bench/experiments/haptic/plant/parameters.hpp"
#include "bench/lab/records/record.hpp"

namespace haptic::region {

struct Identification {
    struct Draw {
        std::uint64_t seed;
        Parameters plant;
        std::optional<double> fall;  // s, undamped; none if it does not fall
        double swing;                // rad, held, undamped; 0 if the fall is not as published
        bool as_published;
    };
    std::vector<Draw> draws;  // by rising seed from 1

    // The first `count` plants that behave as published. Throws std::out_of_range if there are
    // fewer.
    std::vector<Parameters> plants(std::size_t count) const;
};

// Draws plants until `count` of them behave as published. Throws std::runtime_error if 50 times as
// many draws are not enough. `step_takes` is the time of a step of the 2016 device, in s.
Identification identify(std::size_t count, double step_takes, unsigned threads);

// A row of identification.csv: a draw, the falls of the 2016 device with and without selective
// damping, whether it behaves as published, and its numbers, each divided by the middle of its
// range.
struct DrawRow {
    std::uint64_t plant;
    bool as_published;
    std::optional<double> fall_undamped_s, fall_damped_s, swing_undamped_deg;
    std::vector<double> numbers;

    static std::vector<std::string> names();
    static constexpr auto columns =
        std::tuple(records::column("plant", &DrawRow::plant),
                   records::column("as_published", &DrawRow::as_published),
                   records::column("fall_undamped_s", &DrawRow::fall_undamped_s),
                   records::column("fall_damped_s", &DrawRow::fall_damped_s),
                   records::column("swing_undamped_deg", &DrawRow::swing_undamped_deg),
                   records::columns_of(&names, &DrawRow::numbers));
};
std::vector<DrawRow> rows_of(const Identification& identification, double step_takes,
                             unsigned threads);

}  // namespace haptic::region
