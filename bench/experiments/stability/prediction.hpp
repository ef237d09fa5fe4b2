// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a scene fits a plain fixed-point format, before it runs in that format: it runs in
// AnyFormat on the host, and each result is measured before it wraps.
#pragma once

#include <optional>
#include <string>

#include "bench/experiments/stability/any_format.hpp"
#include "bench/experiments/stability/subject.hpp"

namespace stability {

// The bits between a magnitude and the end of a format; below 0 if it is beyond.
double bits_to_overflow(double largest, double limit);

struct Prediction {
    // The bits left by the largest of each: a particle's numbers after a step, and any result of an
    // operation that wraps. Below 0, something wraps.
    double position = 0, velocity = 0, force = 0, result = 0;
};
// Of the whole run, whatever a measure would say of it. None if the scene does not begin: a number
// of it does not fit or vanishes, or the engine refuses it.
std::optional<Prediction> predict(const Description& description, Split split,
                                  const std::string& integrator);

// Of a run that has been done.
Prediction prediction_of(const Recorder& record, double limit);

// AnyFormat in each of the engine's methods.
std::vector<Subject> subjects_of_any_format(Split split);
// In those of more_subjects() that solve contacts.
std::vector<Subject> more_subjects_of_any_format(Split split);
// The split of a subject in a plain fixed-point format; none for every other.
std::optional<Split> split_of(const Subject& subject);

}  // namespace stability
