// SPDX-License-Identifier: GPL-3.0-or-later
// The subjects on the host: the source that the device compiles, or the portable twin of its
// assembly, with the same results bit for bit.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "reference/error_statistics.hpp"
#include "reference/operation.hpp"

namespace operations {

using Raws = std::span<const std::int64_t>;

// An exhaustive run is divided into this many parts, whatever the number of threads: its sums then
// do not depend on the machine.
constexpr std::uint64_t exhaustive_parts = 256;

struct HostSubject {
    reference::Subject subject;
    std::string implementation;
    int input_bits;  // of all operands together
    // Whether the results are those of the default by definition, and only the device's code
    // differs.
    bool same_as_default;
    // Computes the results of the operands.
    std::function<void(Raws operands, std::span<std::int64_t> results)> evaluate;
    // Computes and judges.
    std::function<reference::Judgement(Raws operands)> judge;
    // The errors over one of exhaustive_parts parts of the input space; empty where it has more
    // than 2^32 points.
    std::function<reference::ErrorStatistics(std::uint64_t part)> exhaust;

    std::string name() const;  // as the symbol of the device subject
};

const std::vector<HostSubject>& host_subjects();

// The operation as symbols and tables name it: of a conversion with the format it starts from.
std::string operation_name(const reference::Subject& subject);

}  // namespace operations
