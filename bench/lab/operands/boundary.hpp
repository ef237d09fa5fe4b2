// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary tables: operands where arithmetic is likely to fail, each with a description. Generated
// by rules, so that every split of every width has its own.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reference/operation.hpp"

namespace operands {

struct BoundaryOperand {
    std::int64_t raw;
    std::string what;
};

// Sorted by raw, without duplicates.
std::vector<BoundaryOperand> boundary_operands(const reference::NumberFormat& format);

struct BoundaryCase {
    std::vector<std::int64_t> operands;
    std::string what;  // a description of each operand, or of the combination
};

// For operations of one operand, every operand of the table; of two, all pairs and the ties of the
// roundings; of more, all combinations of a few. `format` is that of the operands.
std::vector<BoundaryCase> boundary_cases(reference::Operation operation,
                                         const reference::NumberFormat& format);

}  // namespace operands
