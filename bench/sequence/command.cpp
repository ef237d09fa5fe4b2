// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench all, and the commands that describe the program itself.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <thread>

#include "bench/lab/program/experiment.hpp"
#include "bench/sequence/manual.hpp"
#include "bench/sequence/sequence.hpp"

namespace sequence {
namespace {

using fixbench::Call;

const fixbench::Registration all({
    .name = "all",
    .description =
        "Runs every experiment and draws the report; `fixbench --list` names them. They share\n"
        "the cores, and the longest begins first; the time left is estimated from the last run\n"
        "on this machine. An experiment's files move into the results only when it has\n"
        "succeeded, so an interruption leaves no file lost or half-written.\n\n"
        "Example: fixbench all --quick --only cycles,accuracy",
    .add =
        [](CLI::App& command) {
            const auto options = std::make_shared<Options>();
            options->threads = std::max(1u, std::thread::hardware_concurrency());
            CLI::Option* const full = command.add_flag_callback(
                "--full", [options] { options->kind = Kind::full; },
                "all samples, an hour of the lever; writes results/ (default)");
            CLI::Option* const quick = command.add_flag_callback(
                "--quick", [options] { options->kind = Kind::quick; },
                "the same on fewer operands, in minutes; writes build/quick/");
            command
                .add_flag_callback(
                    "--check", [options] { options->kind = Kind::check; },
                    "measures as --full into build/check/ and fails if a deterministic file "
                    "differs from results/")
                ->excludes(full)
                ->excludes(quick);
            full->excludes(quick);
            command.add_flag("--exhaustive", options->exhaustive,
                             "also run all inputs of 2^32, on the host and as machine code, for "
                             "hours; otherwise the rows of the last such run are kept");
            command
                .add_option("--only", options->only, "only these experiments of `fixbench --list`")
                ->delimiter(',');
            command.add_flag("--resume", options->resume,
                             "skip what was already measured with the same programs and options");
            command.add_option("--results", options->results,
                               "folder to write instead of results/, build/quick/ or build/check/");
            command.add_option("--threads", options->threads, "cores to keep busy")
                ->capture_default_str()
                ->check(CLI::Range(1, 1024));
            return [options](const Call&) { return run_all(*options); };
        },
});

const fixbench::Registration completion({
    .name = "completion",
    .description = "Prints the bash completion of sub-commands and options.\n\n"
                   "Example: source <(fixbench completion)",
    .add =
        [](CLI::App& command) {
            return [&command](const Call&) {
                fmt::print("{}", bash_completion(*command.get_parent()));
                return fixbench::held;
            };
        },
});

const fixbench::Registration man({
    .name = "man",
    .description = "Prints the manual page, which is made from the help texts.\n\n"
                   "Example: fixbench man | man -l -",
    .add =
        [](CLI::App& command) {
            return [&command](const Call&) {
                fmt::print("{}", manual_page(*command.get_parent()));
                return fixbench::held;
            };
        },
});

}  // namespace
}  // namespace sequence
