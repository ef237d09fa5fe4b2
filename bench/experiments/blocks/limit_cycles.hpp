// SPDX-License-Identifier: GPL-3.0-or-later
// What remains of the outputs of the library's filters without input, and what remains of those of
// the same filters without error feedback. A fixed-point filter ends in a limit cycle: it comes to
// rest, perhaps not at 0, or oscillates for ever.
//
// OnePole starts from outputs of every magnitude, Biquad from pairs of outputs; only the poles of
// Biquad matter, here those of low-pass filters (Butterworth). Without feedback, the exact sum is
// rounded once.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "bench/lab/records/record.hpp"

namespace blocks {

// A row of limit_cycles.csv.
struct LimitCycle {
    std::string filter, format;
    int time_constant;  // steps; of Biquad, those of a period of its cut-off frequency
    bool feedback;      // of errors
    unsigned starts;
    // The largest magnitude of an output in a limit cycle, over all starts.
    std::uint64_t largest_ulp;
    // With feedback: 1/2 sum |g_n| for Biquad (biquad.hpp), 0 for OnePole (one_pole.hpp). Without:
    // for OnePole, the largest distance that a step rounds away.
    std::optional<double> bound_ulp;
    std::optional<unsigned> longest_period;  // steps; 1 is rest; none if longer than 2^20

    static constexpr auto columns =
        std::tuple(records::column("filter", &LimitCycle::filter),
                   records::column("format", &LimitCycle::format),
                   records::column("time_constant_steps", &LimitCycle::time_constant),
                   records::column("error_feedback", &LimitCycle::feedback),
                   records::column("starts", &LimitCycle::starts),
                   records::column("largest_ulp", &LimitCycle::largest_ulp),
                   records::column("bound_ulp", &LimitCycle::bound_ulp, "{:.3f}"),
                   records::column("longest_period_steps", &LimitCycle::longest_period));
};

// In every format of the blocks that can express the filter.
std::vector<LimitCycle> limit_cycles();

}  // namespace blocks
