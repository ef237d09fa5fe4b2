// SPDX-License-Identifier: GPL-3.0-or-later
// What a force sensor read under known weights.
#pragma once

#include <filesystem>
#include <vector>

namespace calibration {

struct Reading {
    int adc;       // 0..1023
    double grams;  // >= 0
};

// The columns adc_reading and actual_g of a CSV file as spreadsheets write it; others are left
// alone. Rows may stand in any order and come out by rising weight; several readings of a weight
// are averaged. Where cells are separated by semicolons, decimal commas are read too. Throws
// std::runtime_error of one line, with file and line number, where a column is missing, a cell is
// no number, a reading lies outside 0..1023, or readings do not rise with the weight.
std::vector<Reading> load_readings(const std::filesystem::path& file);

}  // namespace calibration
