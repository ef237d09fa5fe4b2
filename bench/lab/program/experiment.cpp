// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/program/experiment.hpp"

#include <algorithm>
#include <memory>
#include <thread>

#include "bench/lab/program/output.hpp"

namespace fixbench {
namespace {

constexpr const char* selection = "Selection";

std::vector<Experiment>& registered() {
    static std::vector<Experiment> all;
    return all;
}

bool selects(const CLI::App& command) {
    const auto options = command.get_options(
        [](const CLI::Option* option) { return option->get_group() == selection; });
    return std::any_of(options.begin(), options.end(),
                       [](const CLI::Option* option) { return option->count() > 0; });
}

}  // namespace

Registration::Registration(Experiment experiment) {
    for (Step& step : experiment.steps) {
        if (step.arguments) continue;
        step.arguments = [name = experiment.name,
                          passes_quick = step.passes_quick](const Mode& mode) {
            std::vector<std::string> arguments = {name, "--output", mode.data};
            if (mode.quick && passes_quick) arguments.push_back("--quick");
            return arguments;
        };
    }
    std::vector<Experiment>& all = registered();
    const auto place = std::find_if(all.begin(), all.end(), [&](const Experiment& each) {
        return each.name > experiment.name;
    });
    all.insert(place, std::move(experiment));
}

const std::vector<Experiment>& experiments() { return registered(); }

CLI::Option* add_selection(CLI::App& command, const std::string& option,
                           std::vector<std::string>& names, const std::string& description) {
    return command.add_option(option, names, description)->delimiter(',')->group(selection);
}

void add_to(CLI::App& app, const Experiment& experiment, std::function<int()>& action) {
    CLI::App* const command = app.add_subcommand(experiment.name, experiment.description);
    if (experiment.prints.empty()) {
        const auto run = experiment.add(*command);
        command->callback([run, &action] { action = [run] { return run({}); }; });
        return;
    }
    struct Options {
        Output output;
        unsigned threads = std::max(1u, std::thread::hardware_concurrency());
    };
    const auto options = std::make_shared<Options>();
    options->output.prints = experiment.prints;
    command
        ->add_option(
            "--output", options->output.folder,
            "folder for the data files; without it, the table is printed and nothing is written")
        ->check([](const std::string& text) {
            return text.empty() ? std::string("a folder is needed") : std::string();
        });
    CLI::Option* const json =
        command->add_flag("--json", options->output.json, "print the table as JSON");
    command->add_flag("--csv", options->output.csv, "print the table as CSV")->excludes(json);
    command->add_option("--threads", options->threads, "threads to run on")
        ->capture_default_str()
        ->check(CLI::Range(1, 1024));
    const auto run = experiment.add(*command);
    command->callback([command, run, options, &action] {
        options->output.is_selection = selects(*command);
        action = [run, options] {
            return options->output.collect([&](const std::filesystem::path& folder) {
                return run({folder, options->threads});
            });
        };
    });
}

}  // namespace fixbench
