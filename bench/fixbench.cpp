// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench, the command line of the bench: the registered experiments as sub-commands.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include "bench/experiments/judge/corpus.hpp"
#include "bench/lab/program/experiment.hpp"
#include "bench/sequence/sequence.hpp"

namespace {

const fixbench::Registration report({
    .name = "report",
    .description = "Makes figures, pages and corpora of operands from the data files; with "
                   "--check,\n"
                   "tests whether those that are there follow from them.\n\n"
                   "Example: fixbench report --results results --check",
    .add =
        [](CLI::App& command) {
            const auto results = std::make_shared<std::string>();
            command
                .add_option("--results", *results,
                            "folder that has data/ and gets figures/ and the pages")
                ->required();
            const auto check = std::make_shared<bool>(), here = std::make_shared<bool>();
            command.add_flag("--check", *check,
                             "write nothing; fail if a page or figure does not follow from the "
                             "data");
            command.add_flag("--measured-here", *here,
                             "the data were measured on this machine today: note its tools and "
                             "the date");
            return [results, check, here](const fixbench::Call&) -> int {
                const std::filesystem::path folder = *results;
                if (!*check && std::filesystem::exists(folder / "data" / "operations.csv"))
                    judge::write_corpora(folder / "data", folder / "corpus");
                const std::string experiments = sequence::json_list();
                std::vector<const char*> call{FIXBENCH_PYTHON, FIXBENCH_REPORT,
                                              "--results",     results->c_str(),
                                              "--experiments", experiments.c_str()};
                if (*check) call.push_back("--check");
                if (*here) call.push_back("--measured-here");
                call.push_back(nullptr);
                execv(FIXBENCH_PYTHON, const_cast<char* const*>(call.data()));
                throw std::runtime_error(fmt::format("cannot run {}", FIXBENCH_PYTHON));
            };
        },
});

// One line, whatever the library reports.
std::string one_line(const CLI::App*, const CLI::Error& error) {
    std::string text = error.what();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return fmt::format("fixbench: {}; see --help\n", text);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app(
        "Measures fixed-point arithmetic on a simulated ATmega328P: cycles, error, flash and "
        "stack.\n"
        "`fixbench all` runs every experiment; each also runs alone and prints its table.");
    app.get_formatter()->column_width(34);
    app.footer(
        "Exit status: 0 if everything was done and every check held, 1 if a check failed, 2 if\n"
        "the call or its input was wrong.");
    app.failure_message(one_line);
    app.set_version_flag("--version", std::string("fixbench " FIXBENCH_VERSION));
    bool list = false, json = false;
    CLI::Option* const list_flag = app.add_flag(
        "--list", list, "list the experiments, how long each took last, what each writes");
    app.add_flag("--json", json, "print the list as JSON")->needs(list_flag);

    std::function<int()> action;
    for (const fixbench::Experiment& experiment : fixbench::experiments())
        fixbench::add_to(app, experiment, action);
    app.require_subcommand(0, 1);
    try {
        app.parse(argc, argv);
        if (list) {
            fmt::print("{}", json ? sequence::json_list() : sequence::readable_list());
            return fixbench::held;
        }
        if (!action) throw CLI::RequiredError("A subcommand");
        return action();
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? fixbench::held : fixbench::wrong_call;
    } catch (const std::exception& error) {
        fmt::print(stderr, "fixbench: {}\n", error.what());
        return fixbench::wrong_call;
    }
}
