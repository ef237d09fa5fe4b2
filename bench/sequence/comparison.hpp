// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace sequence {

// Empty if both files contain the same bytes; otherwise the first line in which they differ, in
// both versions, and how many lines do. A missing file differs.
std::string first_difference(const std::filesystem::path& committed,
                             const std::filesystem::path& measured);

}  // namespace sequence
