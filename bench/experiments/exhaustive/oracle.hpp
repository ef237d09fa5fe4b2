// SPDX-License-Identifier: GPL-3.0-or-later
// Judges the results of a subject that is known only at run time: by the reference's bulk judge
// and, if the host has it, by the portable implementation that promises the same bits.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "bench/lab/subjects/host_subject.hpp"
#include "reference/error_statistics.hpp"
#include "reference/operation.hpp"

namespace machine_code {

struct Differences {
    std::uint64_t count = 0;
    reference::Witness witness;  // the first
};

struct Oracle {
    reference::Subject subject;
    // The raws of the calls follow one after the other. `regular` gets a value for each call, or is
    // empty.
    reference::Judgement (*judge)(std::span<const std::int64_t> operands,
                                  std::span<const std::int64_t> results);
    void (*judge_all)(std::span<const std::int64_t> operands, std::span<const std::int64_t> results,
                      reference::ErrorStatistics& statistics, std::span<bool> regular);
    // Null if the host does not have it.
    const operations::HostSubject* portable;

    // Counts the calls whose results differ from the portable ones. `portable` must not be null.
    void compare_all(std::span<const std::int64_t> operands, std::span<const std::int64_t> results,
                     Differences& found) const;
};

// None if the host has no subject with these definitions (float, _Accum, integers).
std::optional<Oracle> oracle_of(const reference::NamedSubject& named);

}  // namespace machine_code
