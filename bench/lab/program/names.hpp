// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the names that a user gives against those that exist.
#pragma once

#include <string>
#include <vector>

namespace fixbench {

// The known name that is most similar to `asked`, or nothing if none is similar.
std::string nearest_name(const std::string& asked, const std::vector<std::string>& known);

// Throws std::invalid_argument for the first of the `asked` names that is not known. The message is
// one line that lists the known names and suggests the most similar.
void check_names(const std::string& option, const std::vector<std::string>& asked,
                 std::vector<std::string> known);

}  // namespace fixbench
