// SPDX-License-Identifier: GPL-3.0-or-later
// The subjects and operand classes that a run is asked for.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reference/operation.hpp"

namespace operations {

// Empty lists select everything.
struct Selection {
    std::vector<std::string> operations;
    std::vector<std::string> formats;
    std::vector<std::string> implementations;
    std::vector<std::string> operands;

    bool selects(const reference::Subject& subject, std::string_view implementation) const;
    bool selects_operands(std::string_view operand_class) const;
};

}  // namespace operations
