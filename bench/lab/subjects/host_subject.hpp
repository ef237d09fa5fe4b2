// SPDX-License-Identifier: GPL-3.0-or-later
// The subjects on the host: the source that the device compiles, or the portable implementation of
// its assembly, with bit-identical results.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "reference/error_statistics.hpp"
#include "reference/operation.hpp"

namespace operations {

using Raws = std::span<const std::int64_t>;

// An exhaustive run is divided into this many parts, whatever the number of threads, so that its
// sums do not depend on the machine.
constexpr std::uint64_t exhaustive_parts = 256;
constexpr int exhaustive_bits = 32;

struct HostSubject {
    reference::Subject subject;
    std::string implementation;
    // Whether the results are those of the default by definition, and only the device's code
    // differs.
    bool same_as_default;

    // Evaluates any number of calls, whose raws follow one after the other.
    void (*evaluate)(Raws operands, std::span<std::int64_t> results);
    // Also reports for each call whether its result is regular; `regular` may be empty.
    void (*judge_all)(Raws operands, Raws results, reference::ErrorStatistics& statistics,
                      std::span<bool> regular);
    // Judges one call.
    reference::Judgement (*judge)(Raws operands, Raws results);

    std::string name() const;  // the symbol of the device subject
    int input_bits() const;    // of all operands together

    // Computes and judges one call.
    reference::Judgement judge_own(Raws operands) const;
    // The errors over one of exhaustive_parts parts of the input space, which must have at most
    // 2^exhaustive_bits points.
    reference::ErrorStatistics exhaust(std::uint64_t part) const;
};

// By format in the catalogue's order, then by implementation; conversions last.
const std::vector<HostSubject>& host_subjects();

// The name of the operation in symbols and tables; for a conversion it includes the format of the
// operand.
std::string operation_name(const reference::Subject& subject);

}  // namespace operations
