// SPDX-License-Identifier: GPL-3.0-or-later
// The calibration of a force sensor: every family of curves is fitted to its readings, measured on
// the simulated chip and judged against exact arithmetic; one is chosen and written as a header.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/experiments/calibration/device_curve.hpp"

namespace calibration {

struct Errors {
    double rms, max;
};

// A curve that might be used. What could not be found stays empty, and `rejected` says why.
struct Candidate {
    std::string fitted_to;
    Curve curve;
    std::vector<double> standard_errors;
    Range range{};
    Errors all{}, upper{};                    // grams, over the readings; upper: from 850 on
    std::optional<double> leave_one_out_rms;  // grams
    std::optional<DeviceMeasurement> device;
    double evaluation_error = 0;  // grams: the chip against exact arithmetic, over 1024 readings
    std::string rejected;
};

// Curves whose evaluation is wrong by more are not used, in grams.
inline constexpr double most_evaluation_error = 0.5;

// The six families fitted to all readings, the published family fitted to those from 850 up, and
// the two published functions. The whole of it is in `fitted_to`.
std::vector<Candidate> candidates(const std::vector<Reading>& readings,
                                  const DeviceProgram& program);

// Of the candidates without objection that lie within one standard error of the least leave-one-out
// error, a factor of 1 + 1 / sqrt(2 n) for n readings left out, the one of fewest cycles. Throws
// std::runtime_error where every one is rejected.
std::size_t choose(const std::vector<Candidate>& candidates, std::size_t readings);

// The largest distance from exact arithmetic, in grams, of raws for each reading; throws
// std::runtime_error where they fall with the reading, are negative or exceed most_grams.
double evaluation_error(const Curve& curve, Range range, const std::array<std::int32_t, 1024>& raw);

struct Options {
    std::filesystem::path readings, output, header;
    DeviceProgram program;
};

// Writes calibration.csv, calibration_candidates.csv, calibration_verdicts.csv and, where one is
// named, the header.
void calibrate(const Options& options);

}  // namespace calibration
