// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>

#include "reference/error_statistics.hpp"

namespace operations {

// The raw operands of a witness, separated by spaces.
inline std::string text_of(const reference::Witness& witness) {
    return fmt::format("{}", fmt::join(witness.operands(), " "));
}

}  // namespace operations
