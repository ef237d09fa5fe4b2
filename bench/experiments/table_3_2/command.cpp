// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench table.
#include <memory>

#include "bench/experiments/table_3_2/table_3_2.hpp"
#include "bench/lab/program/build.hpp"
#include "bench/lab/program/experiment.hpp"
#include "reference/published.hpp"
#include "this_build.hpp"

namespace table_3_2 {
namespace {

const std::filesystem::path folder = build_folder() / "bench/experiments/table_3_2";

const fixbench::Registration table({
    .name = "table",
    .description =
        "Measures the published timing table again, cell by cell, with a verdict for each; the\n"
        "cost of its division by operand; and computes Table 3.1.\n"
        "Files: table_3_2.csv, table_3_1.csv, division_cycles.csv and, with the search over\n"
        "hypotheses, table_3_2_hypotheses.csv.",
    .prints = {"table_3_2.csv"},
    .add =
        [](CLI::App& command) {
            const auto quick = std::make_shared<bool>(false);
            command.add_flag("--quick", *quick, "without the search over hypotheses");
            return [quick](const fixbench::Call& call) {
                fixbench::build({*quick ? "table_3_2_usual_programs" : "table_3_2_programs"});
                measure_table_3_2({.programs_csv = folder / "programs.csv",
                                   .division_elf = folder / "table_3_2_division.elf",
                                   .data = call.output,
                                   .search = !*quick});
                return fixbench::held;
            };
        },
    .steps = {{.name = "table",
               .passes_quick = true,
               .writes = {"table_3_2.csv", "table_3_1.csv", "division_cycles.csv"},
               .full_only = {"table_3_2_hypotheses.csv"},
               .targets = {"table_3_2_programs"},
               .quick_targets = {"table_3_2_usual_programs"},
               .reads = {folder, reference::published_folder()},
               .full_seconds = 15,
               .quick_seconds = 10}},
});

}  // namespace
}  // namespace table_3_2
