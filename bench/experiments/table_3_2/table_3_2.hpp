// SPDX-License-Identifier: GPL-3.0-or-later
// Table 3.2: the published figures next to ours, cell by cell, each with a verdict; the hypotheses
// on the published harness and how well they fit; the cycles of its division; and Table 3.1,
// computed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "bench/experiments/table_3_2/hypothesis.hpp"
#include "bench/lab/records/csv.hpp"

namespace table_3_2 {

struct Options {
    std::filesystem::path programs_csv;  // what was built, from this folder's CMakeLists.txt
    std::filesystem::path division_elf;
    std::filesystem::path data;  // the folder to write to
    bool search = true;          // false: the best known hypothesis only
};

// Writes table_3_1.csv, table_3_2.csv, division_cycles.csv and, with the search,
// table_3_2_hypotheses.csv. Throws if a program, a published figure or a measurement fails.
void measure_table_3_2(const Options& options);

// A measurement of one cell under another hypothesis than that of the table.
struct Alternative {
    Hypothesis hypothesis;
    double ms;
};

// What was tried for a cell that the table's hypothesis misses.
struct Alternatives {
    std::optional<Alternative> nearest{};
    int tried = 0;
    int near = 0;  // those within 10% of the published figure, in a shortened run
};

struct Verdict {
    std::string verdict;  // reproduced, explained, not reproducible
    std::string reason;
};
// reproduced: within 10%. explained: within 10% after the change that the nearest alternative
// makes.
Verdict judge(double published_ms, double measured_ms, const Hypothesis& hypothesis,
              const Alternatives& alternatives);

records::Table table_3_1();

}  // namespace table_3_2
