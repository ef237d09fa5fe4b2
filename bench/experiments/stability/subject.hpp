// SPDX-License-Identifier: GPL-3.0-or-later
// What a battery runs on: a scalar with a method, behind one function.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/experiments/stability/description.hpp"
#include "bench/experiments/stability/recorder.hpp"
#include "bench/lab/catalogue/formats.h"

namespace stability {

// Called with the world after each step, first with step 0. Returns false to end the run.
using Watch = std::function<bool(const State& state, unsigned step)>;

struct Outcome {
    unsigned steps = 0;    // done
    std::string error;     // of the engine; empty if there was none
    std::string unfit;     // a number of the description that the format cannot hold, or none
    std::string vanished;  // one that is 0 in the format, which makes it another scene
    Recorder record;
};

struct Subject {
    std::string scalar, arithmetic, integrator;
    double largest = 0, ulp = 0;  // of the format; for floating point, ulp is 0
    Outcome (*run)(const Description& description, const Watch& watch);
};

// Every scalar with every method.
const std::vector<Subject>& subjects();
// Methods that only some cases run with. For chains and heaps, in three scalars: one iteration,
// iterations begun where the last step ended, all rods solved together, and all springs; the world
// of rods has nothing but them and gravity. For fast particles: continuous contacts.
const std::vector<Subject>& more_subjects();
// One of these, of the ablated ones, or of those with features that no case needs. Throws
// std::runtime_error if there is none.
const Subject& subject(const std::string& scalar, const std::string& arithmetic,
                       const std::string& integrator);

// The parts of subjects(), each compiled separately.
#define SUBJECTS_OF(format, I, F) std::vector<Subject> subjects_of_##format();
STABILITY_FORMATS(SUBJECTS_OF)
#undef SUBJECTS_OF
std::vector<Subject> subjects_of_q16_16_published();
std::vector<Subject> subjects_of_q16_16_saturating();
std::vector<Subject> subjects_of_float();
std::vector<Subject> subjects_of_chains();
std::vector<Subject> subjects_of_continuous_contacts();
// Q16.16 with one measure of the engine left out; not in subjects().
std::vector<Subject> subjects_of_ablated();
// Q16.16 with features of the engine that no case needs; not in subjects().
std::vector<Subject> subjects_of_features();
// Truth by the engine itself, where rounding is negligible; not in subjects().
std::vector<Subject> subjects_of_double();
std::vector<Subject> subjects_of_chains_in_double();
std::vector<Subject> subjects_of_continuous_contacts_in_double();
std::vector<Subject> subjects_of_ablated_in_double();

}  // namespace stability
