// SPDX-License-Identifier: GPL-3.0-or-later
// Where the data files of a run go: into the folder that the user named, or to the terminal as a
// table.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace fixbench {

// Writes a file to the folder and removes it again, including the folders that it made for it.
// Throws std::runtime_error with one line: a folder that is not writable is reported before an hour
// of measuring, not after.
void require_writable(const std::filesystem::path& folder);

struct Output {
    std::filesystem::path folder;     // empty: print
    std::vector<std::string> prints;  // data files, the first existing of which is printed
    bool json = false, csv = false;
    bool is_selection = false;  // part of the whole: existing files are not replaced

    // Calls `measure` with a folder to write to and returns its result. Throws
    // std::invalid_argument if a selection would replace a file, or if --json or --csv was given
    // with --output.
    int collect(const std::function<int(const std::filesystem::path&)>& measure) const;
};

}  // namespace fixbench
