// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/advise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>

#include "bench/experiments/scenes/any_program.hpp"
#include "bench/experiments/scenes/measure_scenes.hpp"
#include "bench/experiments/stability/prediction.hpp"
#include "bench/experiments/stability/scene_description.hpp"
#include "bench/experiments/stability/search.hpp"
#include "bench/lab/catalogue/subjects.h"
#include "bench/lab/parallel.hpp"
#include "bench/lab/records/progress.hpp"
#include "reference/trajectories/trajectory.hpp"

namespace stability {

using records::column;

namespace {

constexpr int first_exponent = 5, last_exponent = 12;
constexpr unsigned looks_per_second = 4;

// A format (width 0: float), a method by its index, and steps of 2^-exponent s.
struct Choice {
    Split split;
    std::size_t method;
    int exponent;
};
struct Result {
    Choice choice;
    std::string format, method;
    double error = std::numeric_limits<double>::infinity();  // m
    std::string fault;
    Prediction bits;
    void cost(const Cost& cost) {
        cycles = std::ldexp(cost.cycles_per_step, choice.exponent);
        flash = cost.flash_bytes;
    }
    double cycles = 0, flash = 0;  // per simulated second, bytes; 0 if not known
    bool estimated = false;        // from another split, method or step
    bool too_large = false;        // for the flash
    bool named = false;            // by the library or the data
    // Whether its cost on the chip is known.
    bool is_measured() const { return too_large || (cycles != 0 && !estimated); }
};

std::string scalar_of(const Split& split) {
    return split.width() == 0 ? "float"
                              : fmt::format("q{}_{}", split.integer_bits, split.fraction_bits);
}

// Whether the library has kernels for this split in particular.
bool is_in_catalogue(const Split& split) {
#define IS_SPLIT(name, Raw, F, ...) \
    || (split.width() == 8 * sizeof(Raw) && split.fraction_bits == F)
    return false LIBRARY_FORMATS(IS_SPLIT);
#undef IS_SPLIT
}

// The measured scalars whose cost stands for that of a split until it is measured itself. No scene
// is among the data in 24 bits: numbers of three bytes cost about as much as those of four.
std::vector<std::string> scalars_like(const Split& split) {
    return {scalar_of(split),
            fmt::format("q{0}_{0}", split.width() == 24 ? 16 : split.width() / 2)};
}

std::vector<Split> splits() {
    std::vector<Split> list = {{0, 0}};
    for (int i = 2; i <= 12; ++i) list.push_back({i, 16 - i});
    for (int i = 3; i <= 16; ++i) list.push_back({i, 24 - i});
    for (int i = 4; i <= 24; ++i) list.push_back({i, 32 - i});
    for (int i = 12; i <= 40; i += 4) list.push_back({i, 64 - i});
    return list;
}

Result run(const std::string& scene, const reference::Trajectory& truth, const Choice& choice) {
    const bool floating = choice.split.width() == 0;
    const Subject subject =
        (floating ? subjects_of_float() : subjects_of_any_format(choice.split))[choice.method];
    const Description description = describe_scene(scene, choice.exponent);
    const unsigned between = (1u << choice.exponent) / looks_per_second;
    double worst = 0;
    const Trial trial =
        attempt(subject, {description, [&](const State& state, unsigned step) {
                              if (step == 0 || step % between != 0) return 0.0;
                              const auto& true_state = truth.at(step / between);
                              for (std::size_t i = 0; i < state.size(); ++i) {
                                  const double apart =
                                      std::hypot(state[i].position.x - true_state[i].position[0],
                                                 state[i].position.y - true_state[i].position[1]);
                                  if (!(apart <= worst)) worst = apart;
                              }
                              return std::isfinite(worst) ? 0.0 : worst;
                          }});
    Result result;
    result.choice = choice;
    result.format =
        floating ? "float"
                 : fmt::format("Q{}.{}", choice.split.integer_bits, choice.split.fraction_bits);
    result.method = subject.integrator;
    const Recorder& record = trial.outcome.record;
    if (trial.held) {
        result.error = worst;
    } else if (!trial.outcome.unfit.empty()) {
        result.fault = trial.outcome.unfit + " does not fit";
    } else if (!trial.outcome.vanished.empty()) {
        result.fault = trial.outcome.vanished + " rounds to 0";
    } else if (!trial.outcome.error.empty()) {
        result.fault = trial.outcome.error;
    } else if (record.first_failure()) {
        result.fault = to_text(*record.first_failure());
    } else {
        result.fault = "diverges";
    }
    result.bits = prediction_of(record, subject.largest);
    return result;
}

// Cycles and flash as measured for this scene and method. Otherwise an estimate: those of another
// split, or of any step.
class Costs {
  public:
    Costs(const std::filesystem::path& data, const std::string& scene) {
        const std::filesystem::path file = data / "scenes.csv";
        if (!std::filesystem::exists(file)) {
            fmt::print(stderr,
                       "advise: {} is missing: the lines are chosen by bits and steps, and all are "
                       "measured now; `fixbench scenes --output {}` measures those of the named "
                       "formats for good\n",
                       file.string(), data.string());
            return;
        }
        using scene_bench::SceneRow;
        for (const SceneRow& row : records::rows_of<SceneRow>(records::Table::load(file))) {
            if (row.scene != scene || !row.cycles_per_step_mean) continue;
            if (row.arithmetic != "nearest" && row.scalar != "float") continue;
            Known& known = measured_[{row.scalar, row.integrator}];
            known.cost = {*row.cycles_per_step_mean, row.flash_bytes.value_or(0)};
            known.exponents.insert(static_cast<int>(-std::log2(row.dt)));
        }
    }
    void add_to(Result& result) const {
        const Split split = result.choice.split;
        const std::string own = scalar_of(split);
        result.named = is_in_catalogue(split);
        for (const std::string& scalar : scalars_like(split)) {
            // Without springs the implicit method is the semi-implicit one. Compensated integration
            // is nearly that one, too.
            for (const std::string& method : {result.method, std::string("semi_implicit_euler")}) {
                if (method != result.method && result.method != "implicit_springs" &&
                    result.method != "semi_implicit_compensated")
                    break;
                const auto found = measured_.find({scalar, method});
                if (found == measured_.end()) continue;
                result.cost(found->second.cost);
                result.named |= scalar == own;
                result.estimated = (split.width() != 0 && scalar != own) ||
                                   method != result.method ||
                                   !found->second.exponents.contains(result.choice.exponent);
                return;
            }
        }
    }

  private:
    struct Known {
        Cost cost;  // of the last of the steps
        std::set<int> exponents;
    };
    std::map<std::pair<std::string, std::string>, Known> measured_;
};

// How far a run is from both limits of its split, in bits: from overflow, and from the allowed
// error.
double reserve(const Result& result, double error) {
    const Prediction& bits = result.bits;
    return std::min(
        {bits.position, bits.velocity, bits.force, bits.result, std::log2(error / result.error)});
}

// By cycles if they were measured, otherwise by the number of bits and steps.
auto price(const Result& result) {
    const int width = result.choice.split.width();
    const double bits = width == 0 ? 48 : width;  // float lies between 32 and 64 bits
    return std::tuple(result.cycles == 0, result.cycles, std::ldexp(bits, result.choice.exponent),
                      result.error);
}

void print(const Result& result) {
    const std::string cycles =
        result.fault.empty() ? fmt::format("{:.0f}", result.cycles) : result.fault;
    const std::string flash = result.flash > 0 ? fmt::format("{:.0f}", result.flash) : "-";
    const bool floating = result.choice.split.width() == 0;
    const auto bits = [&](double x) { return floating ? "-" : fmt::format("{:.1f}", x); };
    fmt::print("{:<8} {:<26} 2^-{:<4} {:>10.3g} {:>18} {:>6} {:>9} {:>9} {:>6} {:>6}\n",
               result.format, result.method, result.choice.exponent, result.error, cycles, flash,
               bits(result.bits.position), bits(result.bits.velocity), bits(result.bits.force),
               bits(result.bits.result));
}

std::optional<reference::Trajectory> truth_of(const std::string& scene) {
    const Description description = describe_scene(scene, last_exponent);
    const unsigned duration = description.steps >> last_exponent;
    reference::Times times;
    for (unsigned i = 0; i <= duration * looks_per_second; ++i)
        times.push_back(double(i) / looks_per_second);
    return reference::trajectory(scene, times);
}

std::vector<Result> run_all(const std::string& scene, const reference::Trajectory& truth,
                            unsigned threads) {
    std::vector<Choice> choices;
    for (const Split& split : splits())
        for (std::size_t method = 0; method < 5; ++method)
            for (int exponent = first_exponent; exponent <= last_exponent; ++exponent)
                choices.push_back({split, method, exponent});
    std::vector<Result> results(choices.size());
    operations::in_parallel(threads, choices.size(),
                            [&](std::size_t i) { results[i] = run(scene, truth, choices[i]); });
    return results;
}

// The diagonal of the box that contains all of a motion, m.
double extent(const reference::Trajectory& truth) {
    Point low{1e300, 1e300}, high{-1e300, -1e300};
    for (const reference::State& state : truth)
        for (const auto& body : state) {
            low = {std::min(low.x, body.position[0]), std::min(low.y, body.position[1])};
            high = {std::max(high.x, body.position[0]), std::max(high.y, body.position[1])};
        }
    return std::hypot(high.x - low.x, high.y - low.y);
}

// Measures these lines on the chip.
void measure(const AdviceOptions& options, const std::vector<Result*>& unknown) {
    records::Progress progress("advise", unknown.size());
    operations::in_parallel(options.threads, unknown.size(), [&](std::size_t i) {
        Result& line = *unknown[i];
        try {
            line.cost(options.measure(options.scene, scalar_of(line.choice.split), line.method,
                                      line.choice.exponent));
            line.estimated = false;
        } catch (const scene_bench::TooLarge& error) {
            line.fault = error.what();
            line.cycles = line.flash = 0;
            line.too_large = true;
        }
        progress.advance();
    });
}

// Sorts the lines by price and keeps as many as are wanted, none of which is an estimate: what is
// measured and turns out to be dearer makes room for the next.
void keep_cheapest(const AdviceOptions& options, std::vector<Result>& lines) {
    for (;;) {
        std::stable_sort(lines.begin(), lines.end(),
                         [](const Result& a, const Result& b) { return price(a) < price(b); });
        std::vector<Result*> unknown;
        for (std::size_t i = 0; i < std::min<std::size_t>(lines.size(), options.most); ++i)
            if (!lines[i].is_measured()) unknown.push_back(&lines[i]);
        if (unknown.empty()) break;
        measure(options, unknown);
    }
    lines.resize(std::min<std::size_t>(lines.size(), options.most));
}

}  // namespace

// A row of suitability.csv: the format of a group with the smallest error.
struct SuitabilityRow {
    std::string scene, formats, best_format, integrator;
    std::optional<double> dt, error;
    std::string unit;
    std::optional<double> error_by_extent;
    std::string fault;

    static constexpr auto columns = std::tuple(
        column("scene", &SuitabilityRow::scene), column("formats", &SuitabilityRow::formats),
        column("best_format", &SuitabilityRow::best_format),
        column("integrator", &SuitabilityRow::integrator), column("dt", &SuitabilityRow::dt),
        column("error", &SuitabilityRow::error), column("unit", &SuitabilityRow::unit),
        column("error_by_extent", &SuitabilityRow::error_by_extent),
        column("fault", &SuitabilityRow::fault));
};

void measure_suitability(const std::filesystem::path& output, unsigned threads) {
    std::vector<SuitabilityRow> rows;
    const std::pair<const char*, std::function<bool(const Result&)>> groups[] = {
        {"Q8.8", [](const Result& r) { return r.format == "Q8.8"; }},
        {"16 bits", [](const Result& r) { return r.choice.split.width() == 16; }},
        {"24 bits", [](const Result& r) { return r.choice.split.width() == 24; }},
        {"Q16.16", [](const Result& r) { return r.format == "Q16.16"; }},
        {"32 bits", [](const Result& r) { return r.choice.split.width() == 32; }},
        {"64 bits", [](const Result& r) { return r.choice.split.width() == 64; }},
        {"float", [](const Result& r) { return r.choice.split.width() == 0; }},
    };
    const std::vector<std::string> names = plane_scenes();
    records::Progress progress("suitability", names.size());
    for (const std::string& scene : names) {
        progress.advance();
        const auto truth = truth_of(scene);
        if (!truth) continue;
        const std::vector<Result> results = run_all(scene, *truth, threads);
        for (const auto& [name, belongs] : groups) {
            const Result* best = nullptr;
            for (const Result& result : results)
                if (belongs(result) && (best == nullptr || result.error < best->error))
                    best = &result;
            SuitabilityRow row{scene, name, "none", "", {}, {}, "m", {}, best->fault};
            if (std::isfinite(best->error)) {
                row.best_format = best->format;
                row.integrator = best->method;
                row.dt = std::ldexp(1.0, -best->choice.exponent);
                row.error = best->error;
                row.error_by_extent = best->error / extent(*truth);
            }
            rows.push_back(std::move(row));
        }
    }
    records::table_of(rows).save(output / "suitability.csv");
}

bool advise(const AdviceOptions& options) {
    const auto truth = truth_of(options.scene);
    if (!truth)
        throw std::runtime_error(
            fmt::format("no true motion is known for scene '{}'", options.scene));
    std::vector<Result> results = run_all(options.scene, *truth, options.threads);

    const Costs costs(options.data, options.scene);
    for (Result& result : results) costs.add_to(result);
    // For each width, method and step, the split with the largest reserve among those within the
    // error; in addition the formats with a name, whose kernels are faster.
    std::map<std::tuple<int, std::size_t, int, std::string>, Result> best;
    std::vector<Result> good;
    for (const Result& result : results) {
        if (!(result.error <= options.error)) continue;
        const Choice& choice = result.choice;
        const auto key = std::tuple(choice.split.width(), choice.method, choice.exponent,
                                    result.named ? result.format : "");
        const auto [place, added] = best.try_emplace(key, result);
        if (!added && reserve(result, options.error) > reserve(place->second, options.error))
            place->second = result;
    }
    for (const auto& [key, result] : best) good.push_back(result);
    keep_cheapest(options, good);
    if (good.empty()) {
        const Result& nearest =
            *std::min_element(results.begin(), results.end(),
                              [](const Result& a, const Result& b) { return a.error < b.error; });
        fmt::print(
            "{}: nothing stays within {:.3g} m. The closest is {} {} at 2^-{} s with {:.3g} m.\n",
            options.scene, options.error, nearest.format, nearest.method, nearest.choice.exponent,
            nearest.error);
        return false;
    }
    fmt::print("{}: within {:.3g} m of the true positions over {} s, cheapest first\n",
               options.scene, options.error,
               describe_scene(options.scene, first_exponent).steps >> first_exponent);
    fmt::print("{:<8} {:<26} {:<8} {:>8} {:>18} {:>6} {:>9} {:>9} {:>6} {:>6}\n", "format",
               "method", "step, s", "error, m", "cycles/s", "flash", "position", "velocity",
               "force", "result");
    fmt::print("{:>82} bits to overflow; result: of any operation\n", "");
    for (const Result& result : good) print(result);
    return true;
}

}  // namespace stability
