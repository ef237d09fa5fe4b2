// SPDX-License-Identifier: GPL-3.0-or-later
// `fixbench all`: the steps of all experiments as processes that share the cores, the longest
// first. A step writes into its own folder in the build folder. Its files move into the results
// when it has succeeded, so that an interruption leaves every file whole, old or new.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/lab/program/experiment.hpp"

namespace sequence {

enum class Kind { full, quick, check };

struct Options {
    Kind kind = Kind::full;
    bool exhaustive = false, resume = false;
    std::vector<std::string> only;  // names of steps; empty: all
    unsigned threads = 1;
    std::filesystem::path results;  // empty: results/, build/quick/ or build/check/
};

// Every step, by name.
std::vector<fixbench::Step> all_steps();

// The steps that the options select. Throws std::invalid_argument for an unknown name.
std::vector<fixbench::Step> chosen_steps(const Options& options);

// Returns the exit code.
int run_all(const Options& options);

// All steps with what each writes and how long it took last time: for readers, and as JSON.
std::string readable_list();
std::string json_list();

}  // namespace sequence
