// SPDX-License-Identifier: GPL-3.0-or-later
// The search, compared with closed forms: a subject that does nothing, and a case that fails
// exactly at a parameter and in a step.
#include "bench/experiments/stability/search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace stability {
namespace {

using fixedpoint::Event;
using fixedpoint::Operation;

// What the run reports in addition to the steps; set by a test.
std::function<void(Outcome&, unsigned step)> incident;

Outcome run(const Description& description, const Watch& watch) {
    Outcome outcome;
    for (unsigned step = 0; step <= description.steps; ++step) {
        outcome.steps = outcome.record.step = step;
        if (incident) incident(outcome, step);
        if (!watch({}, step)) break;
    }
    return outcome;
}
const Subject nothing{"none", "exact", "no_such_method", 128, 0.125, run};
const Subject like_euler{"none", "exact", "explicit_euler", 128, 0.125, run};

class Search : public testing::Test {
  protected:
    ~Search() override { incident = nullptr; }

    // Holds up to `limit`, and fails beyond it in step `from`, from which on the measure is
    // `beyond`.
    Case breaking(double first, double last, double limit, double beyond = 20, unsigned from = 7) {
        Case one{"test", "springs", "parameter", "m", first, last, "closed form", {}};
        const bool rising = last > first;
        one.at = [=](double parameter) {
            Experiment experiment;
            experiment.description.steps = 100;
            experiment.description.dt = TimeStep::binary(3);
            const bool breaks = rising ? parameter > limit : parameter < limit;
            experiment.measure = [=](const State&, unsigned step) {
                return breaks && step >= from ? beyond : 1;
            };
            return experiment;
        };
        return one;
    }
};

// Point number k of `count` between the ends, on a logarithmic scale.
double point(double first, double last, double k, double count) {
    return first * std::pow(last / first, k / count);
}

// The last parameter that held is the limit, rounded down to the grid of the bisection.
TEST_F(Search, BisectsToTheLastPointBeforeTheLimit) {
    struct {
        double first, last, count;
    } const ranges[] = {{1, 1000, 6}, {1000, 1, 6}, {0.5, 5, 4}, {1e-6, 1e6, 24}};
    for (const auto& [first, last, count] : ranges) {
        for (const double place : {0.26, 1.01, 2.5, 3.37, count - 0.003}) {
            const Case one = breaking(first, last, point(first, last, place, count));
            for (const unsigned bisections : {0u, 1u, 5u, 10u}) {
                const double parts = std::ldexp(1, static_cast<int>(bisections));
                const double held = std::floor(place * parts + 1e-9) / parts;
                const Finding finding = find_limit(one, nothing, {2, bisections});
                EXPECT_NEAR(finding.limit / point(first, last, held, count), 1, 1e-12)
                    << first << " to " << last << " at " << place << ", " << bisections;
                EXPECT_EQ(finding.verdict, Verdict::diverges);
                EXPECT_EQ(finding.step, 7u);
            }
        }
    }
}

TEST_F(Search, HoldsThroughout) {
    const Finding finding = find_limit(breaking(1, 1000, 1000.5), nothing, {2, 10});
    EXPECT_EQ(finding.verdict, Verdict::stable);
    EXPECT_NEAR(finding.limit, 1000, 1e-9);
    EXPECT_EQ(finding.last_held.steps, 100u);
}

TEST_F(Search, NothingHolds) {
    const Finding finding = find_limit(breaking(1, 1000, 0.5), nothing, {2, 10});
    EXPECT_TRUE(std::isnan(finding.limit));
    EXPECT_EQ(finding.verdict, Verdict::diverges);
    EXPECT_EQ(finding.step, 7u);
}

// Points that are closer find the limit of a monotone case where the others do.
TEST_F(Search, CloserPointsMoveNoMonotoneLimit) {
    for (const double limit : {1.4, 7.3, 29.0, 430.0})
        for (const unsigned closer : {1u, 2u, 4u, 8u}) {
            const Case one = breaking(1, 1000, limit);
            const Finding finding = find_limit(one, nothing, {2, 10, 1e9, closer, true});
            EXPECT_DOUBLE_EQ(finding.limit, find_limit(one, nothing, {2, 10}).limit);
            EXPECT_EQ(finding.swept, 6 * closer + 1);
            EXPECT_EQ(finding.contradicting, 0u);
            EXPECT_TRUE(std::isnan(finding.holds_again));
        }
}

// A case that holds from 2 to 18 and from 24 to 150, with ten points a decade: it is not monotone,
// and its limit is where it fails first.
TEST_F(Search, FindsTheFirstFailureOfACaseThatHoldsAgain) {
    Case one = breaking(1, 1000, 1000);
    one.at = [](double parameter) {
        Experiment experiment;
        experiment.description.steps = 100;
        const bool holds = (parameter > 2 && parameter < 18) || (parameter > 24 && parameter < 150);
        experiment.measure = [=](const State&, unsigned) { return holds ? 0 : 20; };
        return experiment;
    };
    const Finding finding = find_limit(one, nothing, {5, 10, 1e9, 2, true});
    EXPECT_NEAR(finding.limit, 18, 0.02);
    EXPECT_NEAR(finding.beyond, 18, 0.02);
    EXPECT_EQ(finding.swept, 31u);
    // 1, 1.26, 1.58 and 1.995 fail; 25.1, 31.6, ... 126 hold.
    EXPECT_EQ(finding.contradicting, 4u + 8u);
    EXPECT_NEAR(finding.holds_again, 125.9, 0.1);
    // To the first failure only; and by points too far apart to meet it.
    const Finding brief = find_limit(one, nothing, {5, 10, 1e9, 2, false});
    EXPECT_EQ(brief.limit, finding.limit);
    EXPECT_EQ(brief.swept, 14u);
    EXPECT_EQ(brief.contradicting, 4u);
    EXPECT_NEAR(find_limit(one, nothing, {5, 10}).limit, 150, 0.2);
}

// Only the diagnosis runs on after a wrap, to see what the measure makes of it.
TEST_F(Search, AWrapEndsATrial) {
    static std::vector<unsigned> lengths;  // of the runs
    lengths.clear();
    const auto run_recorded = [](const Description& description, const Watch& watch) {
        Outcome outcome;
        const Recorded recorded(outcome.record);
        for (unsigned step = 0; step <= description.steps; ++step) {
            outcome.steps = outcome.record.step = step;
            if (step == 5) outcome.record.notify(Event::overflow, Operation::multiply);
            if (!watch({}, step)) break;
        }
        lengths.push_back(outcome.steps);
        return outcome;
    };
    const Subject wrapping{"none", "exact", "no_such_method", 128, 0.125, run_recorded};
    find_limit(breaking(1, 1000, 1000.5), wrapping, {2, 3});
    EXPECT_EQ(lengths, (std::vector<unsigned>{5, 5, 5, 5, 5, 5, 5, 100}));
    EXPECT_EQ(attempt(wrapping, breaking(1, 1000, 1000.5).at(1)).outcome.steps, 100u);
}

// Ten tolerances are a divergence, less is a drift by that many tolerances per second.
TEST_F(Search, TellsDriftFromDivergence) {
    const auto found = [&](double measure, unsigned from) {
        return find_limit(breaking(1, 1000, 30, measure, from), nothing, {2, 3});
    };
    EXPECT_EQ(found(10, 7).verdict, Verdict::diverges);
    EXPECT_EQ(found(std::numeric_limits<double>::quiet_NaN(), 7).verdict, Verdict::diverges);
    const Finding drift = found(9.75, 26);
    EXPECT_EQ(drift.verdict, Verdict::drifts);
    EXPECT_EQ(drift.step, 26u);
    EXPECT_DOUBLE_EQ(drift.rate, 9.75 / (26 / 8.0));
    EXPECT_EQ(find_limit(breaking(1, 1000, 30, 1), nothing, {2, 3}).verdict, Verdict::stable);
    EXPECT_EQ(found(std::nextafter(1.0, 2), 7).verdict, Verdict::drifts);
}

TEST_F(Search, AFailureAtTheStartBelongsToTheFirstStep) {
    const Trial trial = attempt(nothing, breaking(1, 1000, 0.5, 20, 0).at(1));
    EXPECT_FALSE(trial.held);
    EXPECT_EQ(trial.failed_step, 1u);
    EXPECT_EQ(trial.outcome.steps, 0u);
}

TEST_F(Search, AttemptRunsUntilTheMeasurePassesItsStop) {
    Experiment growing = breaking(1, 1000, 1000).at(1);
    growing.measure = [](const State&, unsigned step) { return step / 10.0; };
    const Trial trial = attempt(nothing, growing, 5);
    EXPECT_EQ(trial.failed_step, 11u);
    EXPECT_EQ(trial.outcome.steps, 50u);
    EXPECT_EQ(trial.worst, 5);
    EXPECT_EQ(attempt(nothing, growing).outcome.steps, 11u);
}

// An endurance ends with the last step before the failure.
TEST_F(Search, EnduranceCountsTheStepsThatHeld) {
    Case one = breaking(1, 50, 60);
    one.endurance = true;
    one.at = [](double steps) {
        Experiment experiment;
        experiment.description.steps = static_cast<unsigned>(steps);
        experiment.measure = [](const State&, unsigned step) { return step >= 41 ? 2 : 0; };
        return experiment;
    };
    const Finding broken = find_limit(one, nothing, {});
    EXPECT_EQ(broken.limit, 40);
    EXPECT_EQ(broken.step, 41u);
    EXPECT_EQ(broken.verdict, Verdict::drifts);
    EXPECT_EQ(find_limit(one, nothing, {2, 10, 40}).limit, 40);  // no longer than it is told
    EXPECT_EQ(find_limit(one, nothing, {2, 10, 40}).verdict, Verdict::stable);
    EXPECT_EQ(find_limit(one, nothing, {2, 10, 30}).limit, 30);
}

// What the subject itself reports takes precedence over the measure; the earliest cause counts.
TEST_F(Search, NamesWhatTheSubjectReports) {
    const Case one = breaking(1, 1000, 30, 20, 7);
    const auto found = [&](std::function<void(Outcome&, unsigned)> happens) {
        incident = std::move(happens);
        return find_limit(one, nothing, {2, 3});
    };
    Finding finding = found([](Outcome& outcome, unsigned) { outcome.unfit = "mass"; });
    EXPECT_EQ(finding.verdict, Verdict::overflows);
    EXPECT_EQ(finding.first_event, "overflow convert mass");
    EXPECT_TRUE(std::isnan(finding.limit));
    finding = found([](Outcome& outcome, unsigned) { outcome.vanished = "mass"; });
    EXPECT_EQ(finding.verdict, Verdict::underflows);
    EXPECT_EQ(finding.first_event, "underflow convert mass");
    finding = found([](Outcome& outcome, unsigned) { outcome.error = "too many contacts"; });
    EXPECT_EQ(finding.verdict, Verdict::reports);
    EXPECT_EQ(finding.first_event, "too many contacts");
}

TEST_F(Search, AWrapFailsWithoutAMeasure) {
    incident = [](Outcome& outcome, unsigned step) {
        if (step == 5) outcome.record.notify(Event::overflow, Operation::multiply);
    };
    const Finding finding = find_limit(breaking(1, 1000, 1000.5), nothing, {2, 3});
    EXPECT_TRUE(std::isnan(finding.limit));
    EXPECT_EQ(finding.verdict, Verdict::overflows);
    EXPECT_EQ(finding.first_event, "overflow multiply description");
    EXPECT_EQ(finding.step, 5u);
}

// A cause counts only up to the step in which the measure fails.
TEST_F(Search, ACauseIsNoLaterThanItsEffect) {
    // The measure passes 1 in step 7 and 10 in step 60, so that the run continues in between.
    Case one = breaking(1, 1000, 30);
    const auto at = one.at;
    one.at = [at](double parameter) {
        Experiment experiment = at(parameter);
        if (parameter > 30)
            experiment.measure = [](const State&, unsigned step) {
                return step < 7 ? 0 : step < 60 ? 2 : 20;
            };
        return experiment;
    };
    const auto found = [&](unsigned when, bool saturates) {
        incident = [=](Outcome& outcome, unsigned step) {
            if (step != when) return;
            if (saturates) {
                outcome.record.saturate(Operation::add);
            } else {
                outcome.record.notify(Event::overflow, Operation::add);
            }
        };
        const Experiment experiment = one.at(1000);
        const Trial trial = attempt(nothing, experiment, 10);
        EXPECT_EQ(trial.failed_step, 7u);
        Case broken = one;
        broken.from = 1000, broken.to = 2000;
        return find_limit(broken, nothing, {2, 3});
    };
    for (const bool saturates : {false, true}) {
        const Verdict verdict = saturates ? Verdict::saturates : Verdict::overflows;
        EXPECT_EQ(found(6, saturates).verdict, verdict);
        EXPECT_EQ(found(7, saturates).verdict, verdict);
        EXPECT_EQ(found(7, saturates).step, 7u);
        EXPECT_EQ(found(6, saturates).step, 6u);
        EXPECT_EQ(found(8, saturates).verdict, Verdict::diverges);
    }
}

// Vanishing products explain a drift if they vanish in half of the steps and double holds. The
// engine in double returns the one body of the description, the subject above returns none.
TEST_F(Search, UnderflowsWhereHalfOfTheStepsDoAndDoubleHolds) {
    const auto found = [&](const Subject& subject, unsigned steps, double measure,
                           double in_double) {
        incident = [=](Outcome& outcome, unsigned step) {
            if (step >= 1 && step <= steps)
                outcome.record.notify(Event::underflow, Operation::multiply);
        };
        Case one = breaking(1, 1000, 30);
        one.at = [=](double) {
            Experiment experiment;
            experiment.description.bodies.resize(1);
            experiment.description.steps = 100;
            experiment.measure = [=](const State& state, unsigned step) {
                return step < 40 ? 0 : state.empty() ? measure : in_double;
            };
            return experiment;
        };
        return find_limit(one, subject, {2, 3});
    };
    const Finding finding = found(like_euler, 20, 2, 1);
    EXPECT_EQ(finding.verdict, Verdict::underflows);
    EXPECT_EQ(finding.step, 1u);
    EXPECT_EQ(finding.first_event, "underflow multiply description");
    EXPECT_EQ(found(like_euler, 19, 2, 1).verdict, Verdict::drifts);
    EXPECT_EQ(found(like_euler, 20, 2, 2).verdict, Verdict::drifts);  // the method itself fails
    EXPECT_EQ(found(like_euler, 20, 20, 1).verdict, Verdict::diverges);
    EXPECT_EQ(found(nothing, 20, 2, 1).verdict, Verdict::drifts);  // no such method in double
}

TEST(SubjectsOf, AddsTheMethodsThatTheCaseNames) {
    Case one;
    EXPECT_EQ(subjects_of(one).size(), subjects().size());
    one.more_methods = {"warm_started", "direct_rods"};
    const auto all = subjects_of(one);
    ASSERT_EQ(all.size(), subjects().size() + 2 * 3);
    for (std::size_t i = subjects().size(); i < all.size(); ++i)
        EXPECT_TRUE(all[i]->integrator == "warm_started" || all[i]->integrator == "direct_rods");
}

TEST(VerdictText, IsTheDataFiles) {
    EXPECT_EQ(to_text(Verdict::stable), "stable");
    EXPECT_EQ(to_text(Verdict::drifts), "drifts");
    EXPECT_EQ(to_text(Verdict::diverges), "diverges");
    EXPECT_EQ(to_text(Verdict::overflows), "overflows");
    EXPECT_EQ(to_text(Verdict::saturates), "saturates");
    EXPECT_EQ(to_text(Verdict::underflows), "underflows");
    EXPECT_EQ(to_text(Verdict::reports), "reports");
}

}  // namespace
}  // namespace stability
