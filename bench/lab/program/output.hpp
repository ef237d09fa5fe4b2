// SPDX-License-Identifier: GPL-3.0-or-later
// Where the data files of a run go: into the folder that was asked for, or as a table to the
// terminal.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace fixbench {

// Writes a file to the folder and removes it again, with the folders that it made for it. Throws
// std::runtime_error of one line: what takes no results is told of before an hour of measuring, not
// after.
void require_writable(const std::filesystem::path& folder);

struct Output {
    std::filesystem::path folder;     // none: print
    std::vector<std::string> prints;  // data files, of which the first that there is is printed
    bool json = false, csv = false;
    bool is_selection = false;  // of the whole: files that are there already stay

    // Calls `measure` with a folder to write to and returns its result. Throws
    // std::invalid_argument where a selection would replace a file.
    int collect(const std::function<int(const std::filesystem::path&)>& measure) const;
};

}  // namespace fixbench
