// SPDX-License-Identifier: GPL-3.0-or-later
// Exhaustive ranges of raws, and how they are divided among shards and threads.
#pragma once

#include <cstdint>
#include <stdexcept>

#include "reference/number_format.hpp"

namespace operands {

// The raws first..last, both included.
struct Range {
    std::int64_t first, last;

    constexpr std::uint64_t size() const { return std::uint64_t(last - first) + 1; }
    bool operator==(const Range&) const = default;
};

// Every raw of a format of at most 32 bits, throws std::invalid_argument for a wider one. Of float
// every pattern, NaNs included.
constexpr Range every_raw(const reference::NumberFormat& format) {
    if (format.width > 32)
        throw std::invalid_argument("a 64-bit format has too many raws to visit them all");
    const std::int64_t half = std::int64_t(1) << (format.width - 1);
    return format.is_unsigned ? Range{0, format.max()} : Range{-half, half - 1};
}

// Part `index` (from 0) of `count` nearly equal parts that together make up the range, in order.
// `index` must be less than `count`, and `count` at most range.size(); throws std::invalid_argument
// otherwise.
constexpr Range part(const Range& range, std::uint64_t index, std::uint64_t count) {
    if (index >= count || count > range.size())
        throw std::invalid_argument(
            "a part of a range must be in 0 .. count - 1, and must not be empty");
    const std::uint64_t share = range.size() / count, larger = range.size() % count;
    const auto start = [&](std::uint64_t i) {
        return range.first + std::int64_t(i * share + (i < larger ? i : larger));
    };
    return {start(index), start(index + 1) - 1};
}

}  // namespace operands
