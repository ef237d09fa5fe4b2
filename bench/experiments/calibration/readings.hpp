// SPDX-License-Identifier: GPL-3.0-or-later
// The readings of a force sensor under known weights.
#pragma once

#include <filesystem>
#include <vector>

namespace calibration {

struct Reading {
    int adc;       // 0..1023
    double grams;  // >= 0
};

// Reads the columns adc_reading and actual_g of a CSV file as written by spreadsheets; other
// columns are ignored. Rows may be in any order; the result is in order of rising weight, and
// several readings of a weight are averaged. If cells are separated by semicolons, decimal commas
// are accepted, too. Throws std::runtime_error with one line that names file and line number if a
// column is missing, a cell is not a number, a reading is outside 0..1023, or the readings do not
// rise with the weight.
std::vector<Reading> load_readings(const std::filesystem::path& file);

}  // namespace calibration
