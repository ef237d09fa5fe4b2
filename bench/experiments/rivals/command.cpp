// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench rivals.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <memory>
#include <stdexcept>

#include "bench/experiments/rivals/rivals.hpp"
#include "bench/lab/program/experiment.hpp"
#include "bench/lab/program/names.hpp"

namespace rivals {
namespace {

const fixbench::Registration command({
    .name = "rivals",
    .description =
        "Other libraries on the simulated chip: cycles, error, flash, stack and what they\n"
        "return outside the range. A library is built from your checkout; what needs none\n"
        "(_Accum, 64-bit integers) is always measured. Figures of libraries that are not given\n"
        "are those of the last run, with their date, version and commit. File: rivals.csv.\n\n"
        "Example: fixbench rivals --source libfixmath=../libfixmath --keep results/data/rivals.csv",
    .prints = {"rivals.csv"},
    .add =
        [](CLI::App& command) {
            struct Asked {
                Options options;
                std::vector<std::string> sources;
            };
            const auto asked = std::make_shared<Asked>();
            command.add_option("--source", asked->sources,
                               "<rival>=<folder> of a checkout; may be given several times");
            command.add_option("--keep", asked->options.kept, "rivals.csv of the last run")
                ->check(CLI::ExistingFile);
            command.add_option("--samples", asked->options.samples, "operands of each class")
                ->capture_default_str()
                ->check(CLI::Range(std::uint64_t(1), std::uint64_t(1) << 40));
            return [asked](const fixbench::Call& call) {
                Options& options = asked->options;
                for (const std::string& source : asked->sources) {
                    const std::size_t equals = source.find('=');
                    const std::string name = source.substr(0, equals);
                    fixbench::check_names("--source", {name}, known_rivals());
                    const std::filesystem::path folder =
                        equals == source.npos ? "" : source.substr(equals + 1);
                    if (!std::filesystem::is_directory(folder))
                        throw std::invalid_argument(
                            fmt::format("--source {}: expected <rival>=<folder>, and the folder "
                                        "must exist",
                                        source));
                    options.sources[name] = folder;
                }
                options.output = call.output;
                options.threads = call.threads;
                options.date = fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)));
                measure_rivals(options);
                return fixbench::held;
            };
        },
    .steps = {{.name = "rivals",
               .arguments = [](const fixbench::Mode& mode) -> std::vector<std::string> {
                   return {"rivals",
                           "--samples",
                           mode.quick ? "200" : "2000",
                           "--keep",
                           mode.committed / "rivals.csv",
                           "--output",
                           mode.data};
               },
               .writes = {"rivals.csv"},
               .full_seconds = 3,
               .quick_seconds = 3}},
});

}  // namespace
}  // namespace rivals
