// SPDX-License-Identifier: GPL-3.0-or-later
// Compares two runs: what became slower, larger or less accurate.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/lab/records/record.hpp"

namespace compare {

// A row of compare.csv.
struct Change {
    std::string operation, format, implementation, operands, quantity;
    std::optional<double> before, after;
    std::string verdict;  // worse, better, new, gone; the score and its parts: none if equal

    static constexpr auto columns = [] {
        using records::column;
        return std::tuple(column("operation", &Change::operation),
                          column("format", &Change::format),
                          column("implementation", &Change::implementation),
                          column("operands", &Change::operands),
                          column("quantity", &Change::quantity), column("before", &Change::before),
                          column("after", &Change::after), column("verdict", &Change::verdict));
    }();
};

// operations.csv of a run: of a folder that contains it or data/operations.csv, or of a git
// revision of `repository`. Throws std::invalid_argument with one line if there is none.
records::Table operations_of(const std::string& folder_or_revision,
                             const std::filesystem::path& repository);

// The rows of all subjects that changed, in the order of the later run. Means are compared only if
// both runs took the same number of samples.
std::vector<Change> changes(const records::Table& before, const records::Table& after);

// How many times better ours is than avr-libc's float, over a fixed list of operations. The last
// row is the geometric mean of cycles, flash and error, the three before it their means, and those
// before them the parts.
std::vector<Change> score(const records::Table& before, const records::Table& after);

}  // namespace compare
