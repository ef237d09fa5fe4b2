// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench exhaustive and merge.
#include <fmt/format.h>

#include <memory>

#include "bench/chip/simulator/elf.hpp"
#include "bench/experiments/exhaustive/exhaustive.hpp"
#include "bench/lab/catalogue/catalogue.hpp"
#include "bench/lab/program/build.hpp"
#include "bench/lab/program/experiment.hpp"
#include "bench/lab/program/names.hpp"
#include "bench/lab/subjects/device_subject.hpp"
#include "this_build.hpp"

namespace machine_code {
namespace {

using fixbench::Call;

int held(std::uint64_t violations) {
    if (violations == 0) return fixbench::held;
    fmt::print(stderr, "fixbench: {} results contradict their definition\n", violations);
    return fixbench::check_failed;
}

const std::filesystem::path folder = build_folder() / "bench/device";

std::filesystem::path program_of(const std::string& name) { return folder / (name + ".elf"); }

// The programs of a full run.
std::vector<std::string> exhausted() {
    std::vector<std::string> names = catalogue::programs();
    std::erase(names, "rivals");
    return names;
}

const fixbench::Registration exhaustive({
    .name = "exhaustive",
    .description =
        "Kernels as machine code, translated instruction by instruction and run over all inputs\n"
        "if there are at most 2^32 (operands `all`), otherwise over a long search (`search`).\n"
        "About a minute a function. Rows go into exhaustive.csv; those of other functions stay.\n"
        "With --shard i/n a part of the work goes into files that `fixbench merge` joins. A\n"
        "worker that dies continues from its checkpoint when it is started again:\n\n"
        "  parallel --retries 3 fixbench exhaustive --output DIR --shard {}/16 ::: $(seq 16)\n"
        "  fixbench merge --output DIR DIR/*.json\n\n"
        "Example: fixbench exhaustive --symbol sqrt_q16_16_default,sin_q16_16_default",
    .prints = {"exhaustive.csv"},
    .add =
        [](CLI::App& command) {
            struct Asked {
                Options options;
                std::vector<std::filesystem::path> programs;
                std::string shard = "1/1";
            };
            const auto asked = std::make_shared<Asked>();
            command
                .add_option("--program", asked->programs, "device programs (default: q16_16.elf)")
                ->check(CLI::ExistingFile);
            command
                .add_option("--symbol", asked->options.symbols,
                            "only these functions (default: all that can be judged)")
                ->delimiter(',');
            command
                .add_option(
                    "--search-operands", asked->options.search_operands,
                    "operands of a search, for functions with more than 32 bits of operands")
                ->capture_default_str()
                ->check(CLI::Range(std::uint64_t(1), std::uint64_t(1) << 40));
            CLI::Option* const shard =
                command.add_option("--shard", asked->shard, "i/n: the i-th of n parts of the work")
                    ->capture_default_str();
            shard->needs(command.get_option("--output"));
            return [asked](const Call& call) {
                Options options = asked->options;
                options.output = call.output;
                options.threads = call.threads;
                options.shard = parse_shard(asked->shard);
                if (asked->programs.empty()) {
                    fixbench::build({"subjects"});
                    asked->programs = {program_of("q16_16")};
                }
                std::vector<std::string> known;
                for (const auto& program : asked->programs)
                    for (const std::string& symbol :
                         operations::subjects_of(simulator::Elf(program)))
                        known.push_back(symbol);
                fixbench::check_names("--symbol", options.symbols, known);
                std::uint64_t violations = 0;
                for (const auto& program : asked->programs) {
                    options.program = program;
                    options.symbols = asked->options.symbols;
                    const simulator::Elf elf(program);
                    std::erase_if(options.symbols, [&](const std::string& symbol) {
                        return !elf.has_function(symbol);
                    });
                    if (options.symbols.empty() && !asked->options.symbols.empty()) continue;
                    violations += run_exhaustive(options);
                }
                return held(violations);
            };
        },
    .steps =
        {{.name = "exhaustive",
          .arguments =
              [](const fixbench::Mode& mode) {
                  std::vector<std::string> arguments = {"exhaustive", "--output", mode.data};
                  for (const std::string& name : exhausted())
                      arguments.insert(arguments.end(), {"--program", program_of(name).string()});
                  if (mode.quick)
                      arguments.insert(arguments.end(), {"--search-operands", "1000000"});
                  return arguments;
              },
          .writes = {"exhaustive.csv"},
          .targets = {"subjects"},
          .reads = {folder},
          .full_seconds = 10800,
          .quick_seconds = 3600,
          .only_exhaustive = true}},
});

const fixbench::Registration merge({
    .name = "merge",
    .description =
        "Joins the files of all shards of `exhaustive` into exhaustive.csv, as a run without\n"
        "shards would have written it.",
    .prints = {"exhaustive.csv"},
    .add =
        [](CLI::App& command) {
            const auto files = std::make_shared<std::vector<std::filesystem::path>>();
            command.add_option("files", *files, "the files exhaustive.<symbol>.<i>-of-<n>.json")
                ->required()
                ->check(CLI::ExistingFile);
            return
                [files](const Call& call) { return held(merge_exhaustive(*files, call.output)); };
        },
});

}  // namespace
}  // namespace machine_code
