// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/calibration/calibrate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "bench/chip/simulator/chip.hpp"
#include "bench/experiments/calibration/verdicts.hpp"
#include "bench/lab/records/progress.hpp"
#include "bench/lab/records/record.hpp"
#include "bench/lab/records/whole_file.hpp"
#include "reference/numbers.hpp"
#include "reference/published.hpp"

namespace calibration {
namespace {

constexpr int upper = 850;  // the published function was fitted from here on

std::vector<Reading> upper_part(const std::vector<Reading>& readings) {
    std::vector<Reading> part;
    std::copy_if(readings.begin(), readings.end(), std::back_inserter(part),
                 [](const Reading& r) { return r.adc >= upper; });
    return part;
}

Errors errors_of(const Candidate& candidate, const std::vector<Reading>& readings) {
    Errors errors{0, 0};
    for (const Reading& r : readings) {
        const double error =
            std::abs(held_value(candidate.curve, candidate.range, r.adc) - r.grams);
        errors.rms += error * error / static_cast<double>(readings.size());
        errors.max = std::max(errors.max, error);
    }
    errors.rms = std::sqrt(errors.rms);
    return errors;
}

// For each reading except the first and the last, beyond which a curve can only extrapolate: its
// error when the curve is fitted to all others.
double leave_one_out_rms(Family family, const std::vector<Reading>& readings, bool only_upper) {
    double sum = 0;
    for (std::size_t out = 1; out + 1 < readings.size(); ++out) {
        std::vector<Reading> others = readings;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(out));
        const Curve curve = fit(family, only_upper ? upper_part(others) : others).curve;
        const double error =
            held_value(curve, rising_range(curve, others), readings[out].adc) - readings[out].grams;
        sum += error * error;
    }
    return std::sqrt(sum / static_cast<double>(readings.size() - 2));
}

void measure(Candidate& candidate, const std::vector<Reading>& readings,
             const DeviceProgram& program) {
    candidate.range = rising_range(candidate.curve, readings);
    candidate.all = errors_of(candidate, readings);
    if (const auto part = upper_part(readings); !part.empty())
        candidate.upper = errors_of(candidate, part);
    candidate.device = DeviceCurve(candidate.curve, candidate.range).measure(program);
    candidate.evaluation_error =
        evaluation_error(candidate.curve, candidate.range, candidate.device->raw);
    if (candidate.evaluation_error > max_evaluation_error)
        candidate.rejected = "its evaluation is not exact enough";
    if (candidate.range.highest < readings.back().adc)
        candidate.rejected = "does not rise up to the last reading";
}

std::string label(const Candidate& candidate) {
    return name_of(candidate.curve.family) + ", " + candidate.fitted_to;
}

std::string coefficients_text(const std::vector<double>& coefficients) {
    return fmt::format("{:.10g}", fmt::join(coefficients, " "));
}

// A row of calibration_candidates.csv. Values that were not measured because the curve was rejected
// are empty.
struct CandidateRow {
    std::string curve, formula, fitted_to, coefficients, standard_errors;
    std::optional<double> rms, max, upper_rms, upper_max, leave_one_out_rms;  // g
    std::optional<int> lowest, highest;
    std::optional<double> evaluation_error, cycles_mean, cycles_max;
    std::optional<int> flash_bytes, stack_bytes;
    std::string verdict;
    static constexpr auto columns = std::tuple(
        records::column("curve", &CandidateRow::curve),
        records::column("formula", &CandidateRow::formula),
        records::column("fitted_to", &CandidateRow::fitted_to),
        records::column("coefficients", &CandidateRow::coefficients),
        records::column("standard_errors", &CandidateRow::standard_errors),
        records::column("rms_g", &CandidateRow::rms), records::column("max_g", &CandidateRow::max),
        records::column("rms_from_850_g", &CandidateRow::upper_rms),
        records::column("max_from_850_g", &CandidateRow::upper_max),
        records::column("leave_one_out_rms_g", &CandidateRow::leave_one_out_rms),
        records::column("lowest", &CandidateRow::lowest),
        records::column("highest", &CandidateRow::highest),
        records::column("evaluation_error_g", &CandidateRow::evaluation_error),
        records::column("cycles_mean", &CandidateRow::cycles_mean),
        records::column("cycles_max", &CandidateRow::cycles_max),
        records::column("flash_bytes", &CandidateRow::flash_bytes),
        records::column("stack_bytes", &CandidateRow::stack_bytes),
        records::column("verdict", &CandidateRow::verdict));
};

std::vector<CandidateRow> candidate_rows(const std::vector<Candidate>& all, std::size_t chosen) {
    std::vector<CandidateRow> rows;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Candidate& c = all[i];
        CandidateRow row{};
        row.curve = name_of(c.curve.family);
        row.formula = formula_of(c.curve.family);
        row.fitted_to = c.fitted_to;
        if (c.device) {
            if (c.curve.family != Family::monotone_cubic)
                row.coefficients = coefficients_text(c.curve.coefficients);
            row.standard_errors = fmt::format("{:.3g}", fmt::join(c.standard_errors, " "));
            row.rms = c.all.rms;
            row.max = c.all.max;
            row.upper_rms = c.upper.rms;
            row.upper_max = c.upper.max;
            row.leave_one_out_rms = c.leave_one_out_rms;
            row.lowest = c.range.lowest;
            row.highest = c.range.highest;
            row.evaluation_error = c.evaluation_error;
            row.cycles_mean = c.device->cycles_mean;
            row.cycles_max = c.device->cycles_max;
            row.flash_bytes = c.device->flash_bytes;
            row.stack_bytes = c.device->stack_bytes;
        }
        row.verdict = i == chosen          ? "chosen"
                      : c.rejected.empty() ? "not chosen"
                                           : "rejected: " + c.rejected;
        rows.push_back(row);
    }
    return rows;
}

// A row of calibration.csv, in grams.
struct ReadingRow {
    int adc;
    double actual, published, published_error, fitted, fitted_error, device, device_minus_fitted;
    static constexpr auto columns = std::tuple(
        records::column("adc_reading", &ReadingRow::adc),
        records::column("actual_g", &ReadingRow::actual),
        records::column("published_g", &ReadingRow::published, "{:.1f}"),
        records::column("published_error_g", &ReadingRow::published_error, "{:.1f}"),
        records::column("fitted_g", &ReadingRow::fitted, "{:.1f}"),
        records::column("fitted_error_g", &ReadingRow::fitted_error, "{:.1f}"),
        records::column("device_g", &ReadingRow::device, "{:.4f}"),
        records::column("device_minus_fitted_g", &ReadingRow::device_minus_fitted, "{:.5f}"));
};

std::vector<ReadingRow> reading_rows(const Candidate& chosen,
                                     const std::vector<Reading>& readings) {
    std::vector<ReadingRow> rows;
    for (const Reading& r : readings) {
        const double published = value<double>(published_function_1, r.adc);
        const double fitted = held_value(chosen.curve, chosen.range, r.adc);
        const double device = chosen.device->raw[static_cast<std::size_t>(r.adc)] / 65536.0;
        // Adding 0.0 makes a negative zero positive.
        rows.push_back({r.adc, r.grams, published + 0.0, published - r.grams + 0.0, fitted + 0.0,
                        fitted - r.grams + 0.0, device + 0.0, device - fitted + 0.0});
    }
    return rows;
}

std::string header_text(const Candidate& chosen, const std::vector<Reading>& readings,
                        const std::filesystem::path& source) {
    const DeviceMeasurement& device = *chosen.device;
    return fmt::format(
        "// SPDX-License-Identifier: MIT\n"
        "// DO NOT EDIT. Made by `fixbench calibrate {}` from {} readings.\n"
        "//\n"
        "// grams = {}, {}{}\n"
        "// Held below reading {} and above reading {}, so at most {:g} g.\n"
        "// Error at the readings: {:.1f} g rms, {:.1f} g at most; of a reading left out of the "
        "fit: {:.1f} g rms.\n"
        "// Error of the Q16.16 evaluation, over all 1024 readings: {:.4f} g at most (exact).\n"
        "// On the ATmega328P, with coefficients in RAM: {:.0f} cycles on average, {:.0f} at "
        "most.\n"
        "#pragma once\n\n"
        "#include <firmware/calibration_curves.hpp>\n\n"
        "namespace firmware {{\nnamespace calibration {{\n\n"
        "constexpr int max_grams = {:g};\n"
        "{}\n"
        "}}  // namespace calibration\n}}  // namespace firmware\n",
        (source.is_absolute() ? source.filename() : source).string(), readings.size(),
        formula_of(chosen.curve.family), chosen.fitted_to,
        chosen.curve.family == Family::monotone_cubic
            ? "."
            : fmt::format(":\n// {} = {:.10g}",
                          chosen.curve.family == Family::line ? "a, b" : "a, b, c",
                          fmt::join(chosen.curve.coefficients, ", ")),
        chosen.range.lowest, chosen.range.highest, max_grams, chosen.all.rms, chosen.all.max,
        *chosen.leave_one_out_rms, chosen.evaluation_error, device.cycles_mean, device.cycles_max,
        max_grams, DeviceCurve(chosen.curve, chosen.range).definition());
}

}  // namespace

double evaluation_error(const Curve& curve, Range range,
                        const std::array<std::int32_t, 1024>& raw) {
    double worst = 0;
    for (int reading = 0; reading < 1024; ++reading) {
        const auto i = static_cast<std::size_t>(reading);
        if (raw[i] < 0 || raw[i] > max_grams * 65536 || (i > 0 && raw[i] < raw[i - 1]))
            throw std::runtime_error(fmt::format("{} of reading {} is {} g on the chip, after {} g",
                                                 name_of(curve.family), reading, raw[i] / 65536.0,
                                                 i > 0 ? raw[i - 1] / 65536.0 : 0.0));
        const reference::Real exact = value<reference::Real>(
            curve, reference::Real(std::clamp(reading, range.lowest, range.highest)));
        const reference::Real error = reference::Real(raw[i]) / 65536 - exact;
        worst = std::max(worst, std::abs(error.convert_to<double>()));
    }
    return worst;
}

std::vector<Candidate> candidates(const std::vector<Reading>& readings,
                                  const DeviceProgram& program) {
    std::vector<Candidate> all;
    const auto add = [&](const std::string& fitted_to, Curve curve, auto&& complete) {
        Candidate candidate{fitted_to, std::move(curve), {}, {}, {}, {}, {}, {}, 0, ""};
        try {
            complete(candidate);
            measure(candidate, readings, program);
        } catch (const simulator::SimulationError&) {
            throw;
        } catch (const std::runtime_error& error) {
            candidate.device.reset();
            candidate.rejected = error.what();
        }
        all.push_back(std::move(candidate));
        return all.back().rejected.empty();
    };
    const auto add_fit = [&](Family family, bool only_upper) {
        add(only_upper ? fmt::format("fitted to readings from {} on", upper)
                       : "fitted to all readings",
            {family, {}}, [&](Candidate& candidate) {
                Fit found = fit(family, only_upper ? upper_part(readings) : readings);
                candidate.curve = found.curve;
                candidate.standard_errors = found.standard_errors;
                candidate.leave_one_out_rms = leave_one_out_rms(family, readings, only_upper);
            });
    };
    records::Progress progress("calibrate", families.size() + 3);
    for (const Family family : families) {
        add_fit(family, false);
        progress.advance();
    }
    add_fit(Family::rational_quadratic, true);
    progress.advance();
    for (const Curve& curve : {published_function_1, published_function_2}) {
        if (add("as published", curve, [](Candidate&) {}))
            all.back().rejected = "for comparison, fitted to other readings than given";
        progress.advance();
    }
    return all;
}

std::size_t choose(const std::vector<Candidate>& all, std::size_t readings) {
    double least = INFINITY;
    for (const Candidate& c : all) {
        if (c.rejected.empty()) least = std::min(least, *c.leave_one_out_rms);
    }
    const double limit = least * (1 + 1 / std::sqrt(2.0 * static_cast<double>(readings - 2)));
    std::optional<std::size_t> chosen;
    std::string reasons;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Candidate& c = all[i];
        if (!c.rejected.empty()) {
            reasons += fmt::format("{}{}: {}", reasons.empty() ? "" : "; ", label(c), c.rejected);
        } else if (*c.leave_one_out_rms <= limit &&
                   (!chosen || c.device->cycles_mean < all[*chosen].device->cycles_mean)) {
            chosen = i;
        }
    }
    if (!chosen) throw std::runtime_error("no curve can be used: " + reasons);
    return *chosen;
}

void calibrate(const Options& options) {
    const std::vector<Reading> readings = load_readings(options.readings);
    if (readings.size() < parameters + 2)
        throw std::runtime_error(
            fmt::format("{}: {} readings; at least {} are needed: a curve has {} coefficients, and "
                        "one reading is left out to judge it",
                        options.readings.string(), readings.size(), parameters + 2, parameters));
    const std::vector<Candidate> all = candidates(readings, options.program);
    const std::size_t chosen = choose(all, readings.size());

    std::vector<Reading> published;
    for (const reference::ForceCalibration& row : reference::load_table_d_1())
        published.push_back({static_cast<int>(row.adc_reading), row.actual_grams});
    const records::Table verdicts = records::table_of(verdict_rows(published));

    records::table_of(reading_rows(all[chosen], readings)).save(options.output / "calibration.csv");
    records::table_of(candidate_rows(all, chosen))
        .save(options.output / "calibration_candidates.csv");
    verdicts.save(options.output / "calibration_verdicts.csv");
    if (!options.header.empty())
        records::write_whole(options.header, header_text(all[chosen], readings, options.readings));
    fmt::print(stderr, "{}: {:.1f} g rms, {:.1f} g where left out, {:.0f} cycles -> {}\n",
               label(all[chosen]), all[chosen].all.rms, *all[chosen].leave_one_out_rms,
               all[chosen].device->cycles_mean,
               options.header.empty() ? "no header: --header names one" : options.header.string());
}

}  // namespace calibration
