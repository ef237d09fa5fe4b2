// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stability {
namespace {

constexpr double runaway = 10;  // tolerances

// Whether the method alone holds: in double, where rounding is negligible.
bool holds_in_double(const Experiment& experiment, const Subject& subject) {
    static const std::vector<Subject> in_double = subjects_of_double();
    static const std::vector<Subject> chains = subjects_of_chains_in_double();
    static const std::vector<Subject> continuous = subjects_of_continuous_contacts_in_double();
    static const std::vector<Subject> ablated = subjects_of_ablated_in_double();
    for (const auto* list : {&in_double, &chains, &continuous, &ablated})
        for (const Subject& one : *list)
            if (one.integrator == subject.integrator) return attempt(one, experiment).held;
    return false;
}

// Determines what went wrong in an experiment that does not hold.
void diagnose(const Case& one, double parameter, const Subject& subject, Finding& finding) {
    finding.beyond = parameter;
    const auto again = [&] { return one.at(parameter); };  // a measure may remember its run
    const Experiment experiment = again();
    const Trial trial = attempt(subject, experiment, runaway);
    const Outcome& outcome = trial.outcome;
    if (!outcome.unfit.empty()) {
        finding.verdict = Verdict::overflows;
        finding.first_event = "overflow convert " + outcome.unfit;
        finding.step = outcome.steps;
        return;
    }
    if (!outcome.vanished.empty()) {
        finding.verdict = Verdict::underflows;
        finding.first_event = "underflow convert " + outcome.vanished;
        return;
    }
    finding.step = trial.failed_step;
    if (!outcome.error.empty()) {
        finding.verdict = Verdict::reports;
        finding.first_event = outcome.error;
        return;
    }
    const auto& failure = outcome.record.first_failure();
    const auto& saturation = outcome.record.first_saturation();
    const auto& underflow = outcome.record.first_underflow();
    const bool ran_away = !(trial.worst < runaway);
    if (failure && failure->step <= trial.failed_step) {
        finding.verdict = Verdict::overflows;
        finding.first_event = to_text(*failure);
        finding.step = failure->step;
    } else if (saturation && saturation->step <= trial.failed_step) {
        finding.verdict = Verdict::saturates;
        finding.first_event = to_text(*saturation);
        finding.step = saturation->step;
    } else if (!ran_away && underflow &&
               outcome.record.steps_with_underflow() >= trial.failed_step / 2 &&
               holds_in_double(again(), subject)) {
        finding.verdict = Verdict::underflows;
        finding.first_event = to_text(*underflow);
        finding.step = underflow->step;
    } else if (ran_away) {
        finding.verdict = Verdict::diverges;
    } else {
        finding.verdict = Verdict::drifts;
        finding.rate = trial.worst / (trial.failed_step * experiment.description.dt.value());
    }
}

Finding find_endurance(const Case& one, const Subject& subject, const Effort& effort) {
    const Experiment experiment = one.at(std::min(one.to, effort.longest_endurance));
    const Trial trial = attempt(subject, experiment);
    Finding finding;
    finding.beyond = finding.holds_again = std::numeric_limits<double>::quiet_NaN();
    finding.last_held = trial.outcome;
    finding.limit = trial.held ? experiment.description.steps : trial.failed_step - 1;
    if (!trial.held) diagnose(one, trial.failed_step, subject, finding);
    return finding;
}

}  // namespace

std::vector<const Subject*> subjects_of(const Case& one) {
    std::vector<const Subject*> all;
    for (const Subject& subject : subjects()) all.push_back(&subject);
    for (const Subject& subject : more_subjects())
        for (const std::string& method : one.more_methods)
            if (subject.integrator == method) all.push_back(&subject);
    return all;
}

std::string to_text(Verdict verdict) {
    constexpr const char* names[] = {"stable",    "drifts",     "diverges", "overflows",
                                     "saturates", "underflows", "reports"};
    return names[static_cast<int>(verdict)];
}

std::string limit_of(const Finding& finding) {
    return std::isnan(finding.limit) ? "none" : fmt::format("{:.4g}", finding.limit);
}

std::string cause_of(const Finding& finding) {
    const std::string verdict = to_text(finding.verdict);
    return finding.first_event.empty() ? verdict : verdict + ": " + finding.first_event;
}

namespace {

// Runs until the measure passes `stop` or, if `ends_at_wrap`, a result wraps.
Trial attempt_until(const Subject& subject, const Experiment& experiment, double stop,
                    bool ends_at_wrap) {
    Trial trial;
    trial.outcome = subject.run(experiment.description, [&](const State& state, unsigned step) {
        const double measure = experiment.measure(state, step);
        const bool within = measure <= 1;
        if (!within && trial.failed_step == 0) trial.failed_step = std::max(step, 1u);
        trial.worst = std::isnan(measure) ? std::numeric_limits<double>::infinity()
                                          : std::max(trial.worst, measure);
        const Recorder* const record = ends_at_wrap ? active_recorder() : nullptr;
        if (record != nullptr && record->first_failure()) return false;
        return within || trial.worst < stop;
    });
    const Outcome& outcome = trial.outcome;
    // A run that wrapped has failed, whether or not the measure shows it.
    const auto& failure = outcome.record.first_failure();
    trial.held = trial.failed_step == 0 && outcome.unfit.empty() && outcome.vanished.empty() &&
                 outcome.error.empty() && !failure;
    if (!trial.held && trial.failed_step == 0)
        trial.failed_step = failure ? failure->step : outcome.steps;
    return trial;
}

// Only whether it holds: a run that has wrapped does not.
Trial attempt_short(const Subject& subject, const Experiment& experiment) {
    return attempt_until(subject, experiment, 1, true);
}

}  // namespace

Trial attempt(const Subject& subject, const Experiment& experiment, double stop) {
    return attempt_until(subject, experiment, stop, false);
}

Finding find_limit(const Case& one, const Subject& subject, const Effort& effort) {
    if (one.endurance) return find_endurance(one, subject, effort);
    const double decades = std::log10(one.to / one.from);
    const unsigned count =
        std::max(4u, unsigned(std::ceil(std::abs(decades) * effort.points_per_decade)));
    const auto parameter = [&](double i) { return one.from * std::pow(10, decades * i / count); };
    Finding finding;
    finding.limit = finding.beyond = finding.holds_again = std::numeric_limits<double>::quiet_NaN();
    // The easiest parameter that holds, then the next that does not.
    double held = -1, failed = -1;
    for (unsigned i = 0; i <= count * effort.closer && (failed < 0 || effort.to_the_end); ++i) {
        const double at = double(i) / effort.closer;
        Trial trial = attempt_short(subject, one.at(parameter(at)));
        ++finding.swept;
        if (failed >= 0) {
            if (!trial.held) continue;
            ++finding.contradicting;
            finding.holds_again = parameter(at);
        } else if (trial.held) {
            held = at;
            finding.last_held = std::move(trial.outcome);
        } else if (held >= 0) {
            failed = at;
        } else {
            ++finding.contradicting;
        }
    }
    if (held < 0) {
        finding.contradicting = 0;
        diagnose(one, one.from, subject, finding);
        return finding;
    }
    if (failed >= 0) {
        for (double apart = 1.0 / effort.closer; apart > std::ldexp(1, -int(effort.bisections));
             apart /= 2) {
            const double middle = (held + failed) / 2;
            Trial trial = attempt_short(subject, one.at(parameter(middle)));
            (trial.held ? held : failed) = middle;
            if (trial.held) finding.last_held = std::move(trial.outcome);
        }
        diagnose(one, parameter(failed), subject, finding);
    }
    finding.limit = parameter(held);
    return finding;
}

}  // namespace stability
