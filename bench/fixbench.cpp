// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench, the command line of the bench: the registered experiments as sub-commands.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/experiments/judge/corpus.hpp"
#include "bench/lab/program/experiment.hpp"
#include "bench/lab/records/record.hpp"
#include "bench/sequence/sequence.hpp"
#include "this_build.hpp"

namespace {

// The columns of each kind of data file and what they hold, as JSON: bench/report/data.py reads the
// files by it. Throws std::logic_error if equal names hold different things.
std::string columns_json() {
    std::map<std::vector<std::string>, records::Header> by_names;
    for (const auto header_of : records::headers()) {
        const records::Header header = header_of();
        std::vector<std::string> names;
        for (const auto& [name, held] : header) names.push_back(name);
        if (by_names.try_emplace(names, header).first->second != header)
            throw std::logic_error(
                fmt::format("two records have the columns {} and differ in what these hold",
                            fmt::join(names, ", ")));
    }
    nlohmann::ordered_json list = nlohmann::json::array();
    for (const auto& [names, header] : by_names) {
        nlohmann::ordered_json columns;
        for (const auto& [name, held] : header) columns[name] = held;
        list.push_back(std::move(columns));
    }
    return list.dump();
}

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
                const std::string script = source_folder() / "bench/report/report.py",
                                  experiments = sequence::json_list(), columns = columns_json();
                std::vector<const char*> call{
                    python(),        script.c_str(),      "--results", results->c_str(),
                    "--experiments", experiments.c_str(), "--columns", columns.c_str()};
                if (*check) call.push_back("--check");
                if (*here) call.push_back("--measured-here");
                call.push_back(nullptr);
                execv(python(), const_cast<char* const*>(call.data()));
                throw std::runtime_error(fmt::format("cannot run {}", python()));
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
