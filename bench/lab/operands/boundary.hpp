// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary tables: operands where arithmetic breaks, each with what it is. Made by rules, so that
// every split of every width has its own.
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

// Sorted by raw, none twice.
std::vector<BoundaryOperand> boundary_operands(const reference::NumberFormat& format);

struct BoundaryCase {
    std::vector<std::int64_t> operands;
    std::string what;  // one description an operand, or what makes the operands a case together
};

// Every operand of the table for operations of one operand, all pairs and the ties of the roundings
// for two, all combinations of a few for more. `format` is that of the operands.
std::vector<BoundaryCase> boundary_cases(reference::Operation operation,
                                         const reference::NumberFormat& format);

}  // namespace operands
