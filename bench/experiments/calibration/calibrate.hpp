// SPDX-License-Identifier: GPL-3.0-or-later
// The calibration of a force sensor: every family of curves is fitted to its readings, measured on
// the simulated chip and compared with exact arithmetic. One is chosen and written as a header.
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

// A curve that might be used. Values that could not be determined are empty, and `rejected` says
// why.
struct Candidate {
    std::string fitted_to;
    Curve curve;
    std::vector<double> standard_errors;
    Range range{};
    Errors all{}, upper{};                    // grams, over the readings; upper: from 850
    std::optional<double> leave_one_out_rms;  // grams
    std::optional<DeviceMeasurement> device;
    double evaluation_error = 0;  // grams: the chip against exact arithmetic, over 1024 readings
    std::string rejected;
};

// Curves whose evaluation error exceeds this, in grams, are not used.
inline constexpr double max_evaluation_error = 0.5;

// The six families fitted to all readings, the published family fitted to the readings from 850,
// and the two published functions. `fitted_to` says which.
std::vector<Candidate> candidates(const std::vector<Reading>& readings,
                                  const DeviceProgram& program);

// Chooses, among the candidates that were not rejected and whose leave-one-out error is within one
// standard error of the smallest, the one with the fewest cycles. One standard error is a factor of
// 1 + 1 / sqrt(2 n) for n readings left out. Throws std::runtime_error if all were rejected.
std::size_t choose(const std::vector<Candidate>& candidates, std::size_t readings);

// The largest difference in grams between the raws, one per reading, and exact arithmetic. Throws
// std::runtime_error if they fall with the reading, are negative or exceed max_grams.
double evaluation_error(const Curve& curve, Range range, const std::array<std::int32_t, 1024>& raw);

struct Options {
    std::filesystem::path readings, output, header;
    DeviceProgram program;
};

// Writes calibration.csv, calibration_candidates.csv, calibration_verdicts.csv and, if one is
// named, the header.
void calibrate(const Options& options);

}  // namespace calibration
