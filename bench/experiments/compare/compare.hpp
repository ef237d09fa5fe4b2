// SPDX-License-Identifier: GPL-3.0-or-later
// Two runs held against each other: what got slower, larger or less exact.
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
    std::string verdict;  // worse, better, new, gone; score and its parts have none where equal

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

// operations.csv of a run: of a folder that holds it or data/operations.csv, or of a git revision
// of `repository`. Throws std::invalid_argument of one line where there is none.
records::Table operations_of(const std::string& folder_or_revision,
                             const std::filesystem::path& repository);

// The rows of all subjects that changed, in the order of the later run. Means are compared where
// both runs took the same number of samples.
std::vector<Change> changes(const records::Table& before, const records::Table& after);

// How many times better ours is than avr-libc's float, over a fixed list of operations: the
// geometric mean of cycles, flash and error, last; before it the three means, and before those
// their parts.
std::vector<Change> score(const records::Table& before, const records::Table& after);

}  // namespace compare
