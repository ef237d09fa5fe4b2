// SPDX-License-Identifier: GPL-3.0-or-later
// The limit of a case for a subject, by bisection, and what goes wrong just beyond it.
#pragma once

#include "bench/experiments/stability/cases.hpp"
#include "bench/experiments/stability/subject.hpp"

namespace stability {

enum class Verdict {
    stable,      // as far as the case goes
    drifts,      // away from the reference, by `rate` tolerances a second
    diverges,    // to ten tolerances and beyond, or to NaN
    overflows,   // by the first event
    saturates,   // by the first result that saturated, if everything saturates
    underflows,  // a product that moves something vanishes, and double holds
    reports,     // the engine reports that a capacity is too small
};
std::string to_text(Verdict verdict);

struct Finding {
    Verdict verdict = Verdict::stable;
    double limit = 0;   // the last parameter that held; NaN if none did
    double beyond = 0;  // the parameter just beyond it, which failed; NaN if all held
    // Of the sweep: its points, 0 if there was none; those that contradict a single limit, because
    // they fail before the first that holds, or hold beyond the limit; and the last of the latter,
    // NaN if there is none.
    unsigned swept = 0, contradicting = 0;
    double holds_again = 0;
    std::string first_event;
    unsigned step = 0;  // of the failure, just beyond the limit
    double rate = 0;    // of a drift
    Outcome last_held;  // at the limit
};

// The limit as it is in files: to four digits, or "none".
std::string limit_of(const Finding& finding);
// Its verdict, with the first event if there is one.
std::string cause_of(const Finding& finding);

// All that it runs with.
std::vector<const Subject*> subjects_of(const Case& one);

struct Effort {
    unsigned points_per_decade = 2;
    unsigned bisections = 10;
    double longest_endurance = 1e9;  // steps
    // The points from which the limit is searched are that many times as close, a power of two. The
    // bisection ends where it does without.
    unsigned closer = 1;
    bool to_the_end = false;  // whether to try what is beyond the limit, too
};

// One run: whether it held, and if not, in which step it failed.
struct Trial {
    Outcome outcome;
    unsigned failed_step = 0;
    bool held = false;
    double worst = 0;  // of the measure
};
// Runs until the measure passes `stop`.
Trial attempt(const Subject& subject, const Experiment& experiment, double stop = 1);

// The limit is the first failure after a parameter that holds, among the points of the effort and
// those of the bisection next to it. Nothing is known between points: whether the case is monotone
// among them is in `contradicting`.
Finding find_limit(const Case& one, const Subject& subject, const Effort& effort);

}  // namespace stability
