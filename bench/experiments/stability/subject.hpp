// SPDX-License-Identifier: GPL-3.0-or-later
// What a battery is run on: a scalar with a method, behind one function.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/experiments/stability/description.hpp"
#include "bench/experiments/stability/recorder.hpp"

namespace stability {

// Sees the world after each step, the first time with step 0; false ends the run.
using Watch = std::function<bool(const State& state, unsigned step)>;

struct Outcome {
    unsigned steps = 0;    // done
    std::string error;     // of the engine; empty where there was none
    std::string unfit;     // a number of the description beyond the format, or none
    std::string vanished;  // one that is 0 in the format, without which it is another scene
    Recorder record;
};

struct Subject {
    std::string scalar, arithmetic, integrator;
    double largest = 0, ulp = 0;  // of the format; of floating point, ulp is 0
    Outcome (*run)(const Description& description, const Watch& watch);
};

// Every scalar with every method.
const std::vector<Subject>& subjects();
// One of them, or of the ablated ones. Throws std::runtime_error where there is none such.
const Subject& subject(const std::string& scalar, const std::string& arithmetic,
                       const std::string& integrator);

// The parts of subjects(), each compiled on its own.
std::vector<Subject> subjects_of_q8_8();
std::vector<Subject> subjects_of_q16_16();
std::vector<Subject> subjects_of_q32_32();
std::vector<Subject> subjects_of_q8_24();
std::vector<Subject> subjects_of_q16_16_published();
std::vector<Subject> subjects_of_q16_16_saturating();
std::vector<Subject> subjects_of_float();
// Q16.16 with one ablation of the engine left out; not among subjects().
std::vector<Subject> subjects_of_ablated();
// Truth by the engine itself, where nothing is rounded to speak of; not among subjects().
std::vector<Subject> subjects_of_double();
std::vector<Subject> subjects_of_ablated_in_double();

}  // namespace stability
