// SPDX-License-Identifier: GPL-3.0-or-later
// How an experiment joins fixbench: command.cpp in its folder contains one static Registration for
// each sub-command. The command line, --help, the order of `fixbench all`, what --check compares
// and the list of who writes which file follow from these.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace fixbench {

// Exit statuses of a sub-command: 1 for a failed check, 2 for a wrong call or input, which throws.
constexpr int held = EXIT_SUCCESS, check_failed = 1, wrong_call = 2;

// What the framework passes to an experiment that runs.
struct Call {
    std::filesystem::path output;  // exists and is writable
    unsigned threads;
};

// One run of `fixbench all`, as seen by its steps.
struct Mode {
    bool quick, exhaustive;
    std::filesystem::path committed;              // data of the last full run
    std::filesystem::path data, figures, header;  // where the step writes
};

// A call of a sub-command that `fixbench all` makes.
struct Step {
    std::string name;
    // The arguments after `fixbench`, with or without --quick. The default is the sub-command,
    // --output, the folder of the data files, and --quick in a quick run if `passes_quick`.
    std::function<std::vector<std::string>(const Mode&)> arguments{};
    bool passes_quick = false;
    std::vector<std::string> writes;             // data files
    std::vector<std::string> full_only{};        // data files that the quick run does not write
    std::vector<std::string> figures{};          // files in the folder figures/
    std::vector<std::string> targets{};          // of the build, which the step reads
    std::vector<std::string> quick_targets{};    // those of the quick run, if it reads fewer
    std::vector<std::filesystem::path> reads{};  // inputs: files, and folders of programs
    // Seconds of one core, approximately: determines the order of the steps until they have been
    // timed on this machine.
    double full_seconds = 60, quick_seconds = 10;
    // The step times this machine: it runs alone, and its figures differ from run to run.
    bool times_host = false;
    // Runs only with --exhaustive, or if it is named.
    bool only_exhaustive = false;
    // The step writes the firmware's calibration header.
    bool writes_header = false;
};

struct Experiment {
    std::string name, description;
    // Without --output, the first of these data files that was written is printed. Empty if the
    // sub-command handles its own output.
    std::vector<std::string> prints{};
    // Adds the options and returns the function that runs.
    std::function<std::function<int(const Call&)>(CLI::App&)> add;
    std::vector<Step> steps{};
};

struct Registration {
    explicit Registration(Experiment experiment);
};

// Sorted by name.
const std::vector<Experiment>& experiments();

// An option that takes a list of names and makes the run a selection of the whole. A selection does
// not replace existing files.
CLI::Option* add_selection(CLI::App& command, const std::string& option,
                           std::vector<std::string>& names, const std::string& description);

// Adds the experiment's sub-command, with --output, --json, --csv and --threads if it prints files.
// The requested call is stored in `action`.
void add_to(CLI::App& app, const Experiment& experiment, std::function<int()>& action);

}  // namespace fixbench
