// SPDX-License-Identifier: GPL-3.0-or-later
// How an experiment joins fixbench: a file command.cpp in its folder holds one static Registration
// for each sub-command. The command line, --help, the order of `fixbench all`, what --check
// compares and the list of who writes which file follow from the list of them.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace fixbench {

// What a sub-command exits with: a failed check is 1; a wrong call or input, which is thrown, is 2.
constexpr int held = EXIT_SUCCESS, check_failed = 1, wrong_call = 2;

// What the framework hands to an experiment that runs.
struct Call {
    std::filesystem::path output;  // exists and can be written
    unsigned threads;
};

// One run of `fixbench all`, as its steps see it.
struct Mode {
    bool quick, exhaustive;
    std::filesystem::path committed;              // data of the last full run
    std::filesystem::path data, figures, header;  // where the step writes
};

// A call of a sub-command that `fixbench all` makes.
struct Step {
    std::string name;
    // Everything behind `fixbench`, with or without --quick; where it is not given, that is the
    // sub-command, --output, the folder of the data files, and --quick of a quick run if it passes
    // it.
    std::function<std::vector<std::string>(const Mode&)> arguments{};
    bool passes_quick = false;
    std::vector<std::string> writes;             // data files
    std::vector<std::string> full_only{};        // data files that the quick run does not write
    std::vector<std::string> figures{};          // files of the folder figures/
    std::vector<std::string> targets{};          // of the build, which it reads
    std::vector<std::string> quick_targets{};    // those of the quick run, where it reads fewer
    std::vector<std::filesystem::path> reads{};  // files, and folders of programs: inputs
    // Seconds of one core, roughly: orders the steps until they have been timed on this machine.
    double full_seconds = 60, quick_seconds = 10;
    // It times this machine: it runs alone, and its figures differ from run to run.
    bool times_host = false;
    // Only with --exhaustive, or where it is named.
    bool only_exhaustive = false;
    // It writes the firmware's calibration header.
    bool writes_header = false;
};

struct Experiment {
    std::string name, description;
    // The data files of which the first that was written is printed without --output; none where
    // the sub-command sees to its own output.
    std::vector<std::string> prints{};
    // Adds the options, returns what runs.
    std::function<std::function<int(const Call&)>(CLI::App&)> add;
    std::vector<Step> steps{};
};

struct Registration {
    explicit Registration(Experiment experiment);
};

// Sorted by name.
const std::vector<Experiment>& experiments();

// An option that takes a list of names and makes the run a selection of the whole. Where one is
// given, files that are there already are not replaced.
CLI::Option* add_selection(CLI::App& command, const std::string& option,
                           std::vector<std::string>& names, const std::string& description);

// Adds the experiment's sub-command with --output, --json, --csv and --threads where it prints
// files; what was asked for is stored in `action`.
void add_to(CLI::App& app, const Experiment& experiment, std::function<int()>& action);

}  // namespace fixbench
