// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench compare.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "bench/experiments/compare/compare.hpp"
#include "bench/lab/program/experiment.hpp"
#include "this_build.hpp"

namespace compare {
namespace {

const fixbench::Registration command({
    .name = "compare",
    .description =
        "Compares two runs: which subjects became slower, larger or less exact. It also prints\n"
        "a score: by how much ours is better than avr-libc's float, as the geometric mean of\n"
        "cycles, flash and error over a fixed list of operations, with its parts. File:\n"
        "compare.csv. Exit status 1 if a figure is worse or a subject is gone.\n\n"
        "Example: fixbench compare HEAD~1 results",
    .prints = {"compare.csv"},
    .add =
        [](CLI::App& command) {
            struct Asked {
                std::string before, after;
            };
            const auto asked = std::make_shared<Asked>();
            command
                .add_option("old", asked->before,
                            "folder of a run, or a git revision with results/data/operations.csv")
                ->required();
            command.add_option("new", asked->after, "the same for the later run")->required();
            return [asked](const fixbench::Call& call) {
                const records::Table before = operations_of(asked->before, source_folder()),
                                     after = operations_of(asked->after, source_folder());
                std::vector<Change> rows = changes(before, after);
                const auto worse = std::count_if(rows.begin(), rows.end(), [](const Change& each) {
                    return each.verdict == "worse" || each.verdict == "gone";
                });
                const std::vector<Change> scores = score(before, after);
                rows.insert(rows.end(), scores.begin(), scores.end());
                records::table_of(rows).save(call.output / "compare.csv");
                if (worse == 0) return fixbench::held;
                fmt::print(stderr, "fixbench: {} figures are worse or gone\n", worse);
                return fixbench::check_failed;
            };
        },
});

}  // namespace
}  // namespace compare
