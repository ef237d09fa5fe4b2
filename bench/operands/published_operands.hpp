// SPDX-License-Identifier: GPL-3.0-or-later
// The operands that the rebuilt published timing harness runs with.
#pragma once

#include <stdexcept>

#include "reference/number_format.hpp"

namespace operands {

struct PublishedOperands {
    reference::FormatKind kind;
    double first, second;  // rounded to the format; operations of more operands repeat them in turn
};

inline constexpr PublishedOperands published_operands[] = {
    {reference::FormatKind::fixed, 3.25, 1.75},
    {reference::FormatKind::integer, 13, 7},
    {reference::FormatKind::accum, 3.25, 1.75},
    {reference::FormatKind::single, 3.25, 1.75},
};

constexpr const PublishedOperands& published_operands_of(const reference::NumberFormat& format) {
    for (const PublishedOperands& row : published_operands) {
        if (row.kind == format.kind) return row;
    }
    throw std::logic_error("a kind of format without published operands");
}

}  // namespace operands
