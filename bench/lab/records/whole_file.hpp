// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are written completely or not at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace records {

// Writes `content` to `path` through a temporary file next to it, which is then renamed; creates
// the folder if it is missing. Throws std::runtime_error with one line that names the path.
void write_whole(const std::filesystem::path& path, std::string_view content);

}  // namespace records
