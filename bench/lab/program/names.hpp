// SPDX-License-Identifier: GPL-3.0-or-later
// Names that a user gives are held against those that exist.
#pragma once

#include <string>
#include <vector>

namespace fixbench {

// The known name that is most like the asked one, or nothing where none is near.
std::string nearest_name(const std::string& asked, const std::vector<std::string>& known);

// Throws std::invalid_argument of one line for the first asked name that is not known; it lists
// what exists and says which of them may have been meant.
void check_names(const std::string& option, const std::vector<std::string>& asked,
                 std::vector<std::string> known);

}  // namespace fixbench
