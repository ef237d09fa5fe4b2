// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/calibration/readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

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

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string::npos) return "";
    return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

// A spreadsheet's file: the table, and the line of each row.
struct Sheet {
    records::Table table;
    std::vector<std::size_t> lines;
    bool decimal_comma;
};

// Ignores Excel's mark before UTF-8, and blank lines. Where the comma is the decimal separator,
// spreadsheets separate cells by semicolons.
Sheet load_sheet(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw std::runtime_error(fmt::format("cannot read {}", file.string()));
    std::string text((std::istreambuf_iterator<char>(stream)), {});
    if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
    const bool semicolons = text.substr(0, text.find('\n')).find(';') != std::string::npos;
    std::string kept;
    std::vector<std::size_t> lines;
    std::size_t number = 1;
    for (std::size_t begin = 0; begin < text.size(); ++number) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = std::string_view(text).substr(begin, end - begin);
        begin = end + 1;
        if (line.find_first_not_of(" \t\r,;") == std::string_view::npos) continue;
        kept.append(line).push_back('\n');
        lines.push_back(number);
    }
    return {records::Table::parse(kept, file.string(), semicolons ? ';' : ','), lines, semicolons};
}

struct Row {
    Reading reading;
    std::size_t line;
};

// In order of rising weight; readings of the same weight are replaced by their mean.
std::vector<Row> averaged(const std::vector<Row>& rows) {
    std::map<double, std::vector<Row>> weights;
    for (const Row& row : rows) weights[row.reading.grams].push_back(row);
    std::vector<Row> means;
    for (const auto& [grams, group] : weights) {
        double sum = 0;
        for (const Row& row : group) sum += row.reading.adc;
        const auto mean = static_cast<int>(std::lround(sum / static_cast<double>(group.size())));
        means.push_back({{mean, grams}, group.front().line});
    }
    return means;
}

}  // namespace

std::vector<Reading> load_readings(const std::filesystem::path& file) {
    const Sheet sheet = load_sheet(file);
    const auto fail = [&](std::size_t line, const std::string& reason) {
        throw std::runtime_error(fmt::format("{}:{}: {}", file.string(), line, reason));
    };
    const auto column = [&](const char* name) {
        for (std::size_t i = 0; i < sheet.table.columns().size(); ++i)
            if (trimmed(sheet.table.columns()[i]) == name) return i;
        fail(sheet.lines.front(),
             fmt::format("no column '{}'; the columns adc_reading and actual_g are needed", name));
        return std::size_t{0};
    };
    const std::size_t adc = column("adc_reading"), grams = column("actual_g");
    const auto cell = [&](std::size_t row, std::size_t k) {
        std::string text = trimmed(sheet.table.rows()[row][k]);
        if (sheet.decimal_comma) std::replace(text.begin(), text.end(), ',', '.');
        return text;
    };
    std::vector<Row> rows;
    for (std::size_t i = 0; i < sheet.table.rows().size(); ++i) {
        // A quoted cell may contain line breaks; later lines are further down then.
        const std::size_t line = sheet.lines[std::min(i + 1, sheet.lines.size() - 1)];
        const std::string reading_text = cell(i, adc), weight_text = cell(i, grams);
        const auto reading = parsed<int>(reading_text);
        if (!reading || *reading < 0 || *reading > 1023)
            fail(line, fmt::format("adc_reading '{}' is not a whole number from 0 to 1023",
                                   reading_text));
        const auto weight = parsed<double>(weight_text);
        if (!weight || !std::isfinite(*weight) || *weight < 0)
            fail(line,
                 fmt::format("actual_g '{}' is not a weight of 0 grams or more", weight_text));
        rows.push_back({{*reading, *weight}, line});
    }
    std::vector<Reading> readings;
    for (const Row& row : averaged(rows)) {
        if (!readings.empty() && row.reading.adc <= readings.back().adc)
            fail(row.line,
                 fmt::format("adc_reading {} of {} g after {} of {} g: readings must rise "
                             "with the weight",
                             row.reading.adc, row.reading.grams, readings.back().adc,
                             readings.back().grams));
        readings.push_back(row.reading);
    }
    return readings;
}

}  // namespace calibration
