// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/measure_stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bench/experiments/stability/ablations.hpp"
#include "bench/experiments/stability/advise.hpp"
#include "bench/experiments/stability/prediction.hpp"
#include "bench/experiments/stability/search.hpp"
#include "bench/lab/parallel.hpp"
#include "bench/lab/program/names.hpp"
#include "bench/lab/records/progress.hpp"
#include "bench/lab/records/record.hpp"

namespace stability {
namespace {

bool wanted(const std::vector<std::string>& names, const std::string& name) {
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

using records::column;

// A row of stability.csv.
struct CaseRow {
    std::string of_case, scalar, arithmetic, integrator, parameter, limit, unit, verdict;
    std::string first_event;
    std::optional<unsigned> step;  // of the first event
    std::string reference;
    // Of the largest result of any operation, as fixbench advise predicts them: at the limit, and
    // just beyond it. Plain fixed-point formats only.
    std::optional<double> bits_at_limit, bits_beyond;
    // Of the sweep over the whole range; none for an endurance, which is one run. How many of its
    // points contradict the limit, and the last beyond it that holds.
    std::optional<unsigned> swept, contradicting;
    std::optional<double> holds_again;
    // At the limit, or at the easy end if nothing holds: the step in s, how many of them are made,
    // and what must hold in each.
    double dt;
    unsigned steps;
    std::string holds;

    static constexpr auto columns = std::tuple(
        column("case", &CaseRow::of_case), column("scalar", &CaseRow::scalar),
        column("arithmetic", &CaseRow::arithmetic), column("integrator", &CaseRow::integrator),
        column("parameter", &CaseRow::parameter), column("limit", &CaseRow::limit),
        column("unit", &CaseRow::unit), column("verdict", &CaseRow::verdict),
        column("first_event", &CaseRow::first_event), column("step", &CaseRow::step),
        column("reference", &CaseRow::reference), column("bits_at_limit", &CaseRow::bits_at_limit),
        column("bits_beyond", &CaseRow::bits_beyond), column("swept", &CaseRow::swept),
        column("contradicting", &CaseRow::contradicting),
        column("holds_again", &CaseRow::holds_again), column("dt", &CaseRow::dt),
        column("steps", &CaseRow::steps), column("holds", &CaseRow::holds));
};

// Rounded down, so that what wraps by little stays below 0.
std::optional<double> predicted_bits(const Case& one, const Subject& subject, double parameter) {
    const std::optional<Split> split = split_of(subject);
    if (!split || std::isnan(parameter)) return {};
    const auto prediction = predict(one.at(parameter).description, *split, subject.integrator);
    if (!prediction) return {};
    return std::floor(prediction->result * 1000) / 1000;
}

template <class Number>
std::optional<Number> if_any(bool any, Number number) {
    return any ? std::optional(number) : std::nullopt;
}

CaseRow row(const Case& one, const Subject& subject, const Finding& finding, const Effort& effort) {
    const Experiment at_limit = one.at(one.endurance ? std::min(one.to, effort.longest_endurance)
                                       : std::isnan(finding.limit) ? one.from
                                                                   : finding.limit);
    std::string verdict = to_text(finding.verdict);
    if (finding.verdict == Verdict::drifts) verdict += fmt::format(" ({:.2g}/s)", finding.rate);
    if (finding.verdict == Verdict::diverges)
        verdict += fmt::format(" (after {} steps)", finding.step);
    return {one.name,
            subject.scalar,
            subject.arithmetic,
            subject.integrator,
            one.parameter,
            limit_of(finding),
            one.unit,
            verdict,
            finding.first_event,
            if_any(finding.verdict != Verdict::stable, finding.step),
            one.reference,
            predicted_bits(one, subject, finding.limit),
            predicted_bits(one, subject, finding.beyond),
            if_any(finding.swept > 0, finding.swept),
            if_any(finding.swept > 0, finding.contradicting),
            if_any(!std::isnan(finding.holds_again), finding.holds_again),
            at_limit.description.dt.value(),
            at_limit.description.steps,
            at_limit.measure.holds()};
}

// The abilities of a format and a method, each shown by a case.
constexpr struct {
    const char *quantity, *found_by;
} envelope[] = {
    {"largest position", "far_from_origin"},
    {"largest half distance between bodies", "distant_pair"},
    {"longest rod, half span", "rod_span"},
    {"shortest rod", "rod_short"},
    {"highest speed on a rod of 1 m", "rod_speed"},
    {"highest speed into a plane", "half_space"},
    {"slowest motion at steps of 1/256 s", "slow"},
    {"largest stiffness at steps of 1/1024 s", "spring_stiffness"},
    {"smallest stiffness", "spring_slow"},
    {"largest inverse mass", "light_body"},
    {"smallest inverse mass", "heavy_body"},
    {"strongest gravity on a rod", "rod_weight"},
    {"smallest step", "small_binary_step"},
    {"largest step of the lever", "lever_step"},
    {"largest mass ratio in a chain of 4", "rod_chain_of_4_heavy_end"},
};

// A point of a map: the limit of one case at a value of the other axis.
struct MapPoint {
    std::string map, x_name;
    double x;
    Case one;
    double bound;  // by theory, for undamped motion without rounding; NaN if there is none
};

std::vector<MapPoint> map_points() {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<MapPoint> points;
    for (int exponent = 1; exponent <= 14; ++exponent) {
        const double dt = std::ldexp(1.0, -exponent);
        points.push_back({"stiffness_upper", "time step", dt, stiffness_at_step(exponent, false),
                          4 / (dt * dt)});
        points.push_back(
            {"stiffness_lower", "time step", dt, stiffness_at_step(exponent, true), none});
    }
    for (const unsigned links : {2u, 3u, 4u, 6u, 8u, 12u, 16u})
        points.push_back({"mass_ratio", "links", double(links), mass_ratio_at_links(links), none});
    for (int power = -10; power <= 14; power += 2) {
        const double rod = std::ldexp(1.0, power);
        // A body that would pass the centre of its chord in one step loses its rod: v dt = r.
        points.push_back({"speed", "length", rod, speed_at_length(rod, 8), rod * 256});
    }
    return points;
}

// A row of envelope.csv.
struct EnvelopeRow {
    std::string quantity, unit, scalar, arithmetic, integrator, limit, limited_by, of_case;

    static constexpr auto columns = std::tuple(
        column("quantity", &EnvelopeRow::quantity), column("unit", &EnvelopeRow::unit),
        column("scalar", &EnvelopeRow::scalar), column("arithmetic", &EnvelopeRow::arithmetic),
        column("integrator", &EnvelopeRow::integrator), column("limit", &EnvelopeRow::limit),
        column("limited_by", &EnvelopeRow::limited_by), column("case", &EnvelopeRow::of_case));
};

template <class Found>
void save_envelope(const Options& options, const Found& found) {
    std::vector<EnvelopeRow> rows;
    for (const auto& [quantity, name] : envelope)
        for (const Subject& subject : subjects()) {
            const Finding& finding = found(name, subject);
            rows.push_back({quantity, case_named(name).unit, subject.scalar, subject.arithmetic,
                            subject.integrator, limit_of(finding), cause_of(finding), name});
        }
    records::table_of(rows).save(options.output / "envelope.csv");
}

// A row of stability_map.csv.
struct MapRow {
    std::string map, x_name;
    double x;
    std::string y_name, unit, scalar, arithmetic, integrator, limit, limited_by;
    std::optional<double> bound;

    static constexpr auto columns = std::tuple(
        column("map", &MapRow::map), column("x_name", &MapRow::x_name), column("x", &MapRow::x),
        column("y_name", &MapRow::y_name), column("unit", &MapRow::unit),
        column("scalar", &MapRow::scalar), column("arithmetic", &MapRow::arithmetic),
        column("integrator", &MapRow::integrator), column("limit", &MapRow::limit),
        column("limited_by", &MapRow::limited_by), column("bound", &MapRow::bound));
};

void save_map(const Options& options, const Effort& effort) {
    const std::vector<MapPoint> points = map_points();
    const std::size_t count = subjects().size();
    std::vector<MapRow> rows(points.size() * count);
    {
        records::Progress progress("stability map", rows.size());
        operations::in_parallel(options.threads, rows.size(), [&](std::size_t i) {
            const Effort coarse{1, options.quick ? 2u : 6u, effort.longest_endurance};
            const MapPoint& point = points[i / count];
            const Subject& subject = subjects()[i % count];
            const Finding finding = find_limit(point.one, subject, coarse);
            rows[i] = {point.map,
                       point.x_name,
                       point.x,
                       point.one.parameter,
                       point.one.unit,
                       subject.scalar,
                       subject.arithmetic,
                       subject.integrator,
                       limit_of(finding),
                       to_text(finding.verdict),
                       point.bound};
            progress.advance();
        });
    }
    records::table_of(rows).save(options.output / "stability_map.csv");
}

}  // namespace

bool is_selection(const Options& options) {
    return !options.cases.empty() || !options.scalars.empty() || !options.integrators.empty();
}

void check_selection(const Options& options) {
    std::vector<std::string> cases, scalars, integrators;
    for (const Case& one : all_cases()) cases.push_back(one.name);
    for (const auto* list : {&subjects(), &more_subjects()})
        for (const Subject& subject : *list) {
            scalars.push_back(subject.scalar);
            integrators.push_back(subject.integrator);
        }
    fixbench::check_names("--case", options.cases, cases);
    fixbench::check_names("--scalar", options.scalars, scalars);
    fixbench::check_names("--integrator", options.integrators, integrators);
}

void measure_stability(const Options& options) {
    const Effort effort = options.quick ? Effort{1, 3, 4000, 1} : Effort{2, 10, 1e9, 4};
    Effort to_the_end = effort;
    to_the_end.to_the_end = true;
    std::vector<std::pair<const Case*, const Subject*>> work;
    for (const Case& one : all_cases()) {
        if (!wanted(options.cases, one.name)) continue;
        for (const Subject* subject : subjects_of(one))
            if (wanted(options.scalars, subject->scalar) &&
                wanted(options.integrators, subject->integrator))
                work.emplace_back(&one, subject);
    }
    if (work.empty())
        throw std::invalid_argument(
            "no subject of these cases has this scalar and integrator together");
    std::vector<Finding> findings(work.size());
    std::vector<CaseRow> rows(work.size());
    {
        records::Progress progress("stability", work.size());
        operations::in_parallel(options.threads, work.size(), [&](std::size_t i) {
            findings[i] = find_limit(*work[i].first, *work[i].second, to_the_end);
            rows[i] = row(*work[i].first, *work[i].second, findings[i], effort);
            progress.advance();
        });
    }
    records::table_of(rows).save(options.output / "stability.csv");
    if (is_selection(options)) return;

    const auto found = [&](const std::string& name, const Subject& subject) -> const Finding& {
        for (std::size_t i = 0; i < work.size(); ++i)
            if (work[i].first->name == name && work[i].second == &subject) return findings[i];
        throw std::logic_error("no finding of " + name);
    };
    save_envelope(options, found);
    measure_ablations(options.output, effort, options.threads);
    save_map(options, effort);
    if (!options.quick) measure_suitability(options.output, options.threads);
}

}  // namespace stability
