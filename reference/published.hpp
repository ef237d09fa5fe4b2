// SPDX-License-Identifier: GPL-3.0-or-later
// The published figures as data, to be printed next to measured results. See published/README.md.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace reference {

// The source folder that holds them.
const std::filesystem::path& published_folder();

// Milliseconds for 30000 operations.
struct PublishedTiming {
    std::string type;       // as the publication names it: int16_t, fixed_16_16, float ...
    std::string operation;  // add, subtract, multiply, divide; sqrt, atan2, shift_left_16
    double milliseconds;
    std::string note;  // for functions only

    // 30000 operations at 16 MHz.
    double cycles_per_operation() const { return milliseconds * 16000 / 30000; }
};

struct WorkloadFigure {
    std::string quantity;
    std::string arithmetic;
    double value;
    std::string unit;
    std::string where;
};

// A force sensor's reading under a known weight, and the weight that the fitted curve returns.
struct ForceCalibration {
    double adc_reading;
    double actual_grams;
    double calculated_grams;
};

// Force per acceleration of the sensor's frame.
struct ForceCorrection {
    double acceleration;  // m/s^2
    double correction;    // N per m/s^2
};

// Whether a measured figure reproduces the published one, given their ratio: within 10%, both ends
// included. The ends are written out, since 1.1 - 1 is not 0.1 in double.
constexpr bool within_10_percent(double ratio) { return ratio >= 0.9 && ratio <= 1.1; }

// Each throws std::runtime_error with file, line and reason if the file is missing or malformed.
// The 24 cells of Table 3.2, row by row.
std::vector<PublishedTiming> load_table_3_2(
    const std::filesystem::path& folder = published_folder());
std::vector<PublishedTiming> load_functions(
    const std::filesystem::path& folder = published_folder());
std::vector<WorkloadFigure> load_workload(const std::filesystem::path& folder = published_folder());
std::vector<ForceCalibration> load_table_d_1(
    const std::filesystem::path& folder = published_folder());
std::vector<ForceCorrection> load_table_d_2(
    const std::filesystem::path& folder = published_folder());

}  // namespace reference
