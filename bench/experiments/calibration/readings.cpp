// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/calibration/readings.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "bench/lab/records/csv.hpp"

namespace calibration {
namespace {

template <class Number>
std::optional<Number> parsed(const std::string& text) {
    Number number;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

}  // namespace

std::vector<Reading> load_readings(const std::filesystem::path& file) {
    const records::Table table = records::Table::load(file);
    const auto fail = [&](std::size_t line, const std::string& reason) {
        throw std::runtime_error(fmt::format("{}:{}: {}", file.string(), line, reason));
    };
    const auto column = [&](const char* name) {
        for (std::size_t i = 0; i < table.columns().size(); ++i) {
            if (table.columns()[i] == name) return i;
        }
        fail(1,
             fmt::format("no column '{}'; the columns adc_reading and actual_g are needed", name));
        return std::size_t{0};
    };
    const std::size_t adc = column("adc_reading"), grams = column("actual_g");
    std::vector<Reading> readings;
    for (std::size_t row = 0; row < table.rows().size(); ++row) {
        const std::size_t line = row + 2;
        const std::vector<std::string>& cells = table.rows()[row];
        const auto reading = parsed<int>(cells[adc]);
        if (!reading || *reading < 0 || *reading > 1023)
            fail(line,
                 fmt::format("adc_reading '{}' is not a whole number from 0 to 1023", cells[adc]));
        const auto weight = parsed<double>(cells[grams]);
        if (!weight || !std::isfinite(*weight) || *weight < 0)
            fail(line,
                 fmt::format("actual_g '{}' is not a weight of 0 grams or more", cells[grams]));
        if (!readings.empty() && *reading <= readings.back().adc)
            fail(line, fmt::format("adc_reading {} after {}: readings must rise", *reading,
                                   readings.back().adc));
        if (!readings.empty() && *weight <= readings.back().grams)
            fail(line, fmt::format("actual_g {} after {}: weights must rise with the readings",
                                   *weight, readings.back().grams));
        readings.push_back({*reading, *weight});
    }
    return readings;
}

}  // namespace calibration
