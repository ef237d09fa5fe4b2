// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace sequence {

// Empty where both files hold the same bytes; otherwise the first line in which they differ, both
// readings of it, and how many lines do. A file that is missing differs.
std::string first_difference(const std::filesystem::path& committed,
                             const std::filesystem::path& measured);

}  // namespace sequence
