// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/published.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "this_build.hpp"

namespace reference {
namespace {

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> fields;
    std::size_t begin = 0;
    for (std::size_t comma; (comma = line.find(',', begin)) != line.npos; begin = comma + 1)
        fields.push_back(line.substr(begin, comma - begin));
    fields.push_back(line.substr(begin));
    return fields;
}

// A row of a file, which knows its file and line.
class Row {
  public:
    Row(const std::string& file, int line, std::vector<std::string> fields)
        : file_(file), line_(line), fields_(std::move(fields)) {}

    const std::string& text(std::size_t column) const { return fields_.at(column); }

    double number(std::size_t column) const {
        const std::string& field = fields_.at(column);
        double number;
        const auto [end, error] =
            std::from_chars(field.data(), field.data() + field.size(), number);
        if (error != std::errc() || end != field.data() + field.size() || !std::isfinite(number))
            fail(fmt::format("'{}' is not a number", field));
        return number;
    }

    void expect(const std::vector<std::string>& columns) const {
        if (fields_ != columns)
            fail(fmt::format("the header is '{}', expected '{}'", fmt::join(fields_, ","),
                             fmt::join(columns, ",")));
    }

    void expect_fields(std::size_t count) const {
        if (fields_.size() != count)
            fail(fmt::format("{} fields, expected {}", fields_.size(), count));
    }

  private:
    [[noreturn]] void fail(const std::string& reason) const {
        throw std::runtime_error(fmt::format("{}:{}: {}", file_, line_, reason));
    }

    std::string file_;
    int line_;
    std::vector<std::string> fields_;
};

// The rows below the header, each with as many fields as there are columns. The published files
// contain no quotes and no comma within a field.
std::vector<Row> read_rows(const std::filesystem::path& file,
                           const std::vector<std::string>& columns) {
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error(fmt::format("{}: cannot be read", file.string()));
    std::vector<Row> rows;
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        if (line.ends_with('\r')) line.pop_back();
        const Row row(file.string(), number, split(line));
        if (number == 1) {
            row.expect(columns);
        } else if (!line.empty()) {
            row.expect_fields(columns.size());
            rows.push_back(row);
        }
    }
    if (rows.empty()) throw std::runtime_error(fmt::format("{}: holds no rows", file.string()));
    return rows;
}

}  // namespace

const std::filesystem::path& published_folder() {
    static const std::filesystem::path folder = source_folder() / "reference/published";
    return folder;
}

std::vector<PublishedTiming> load_table_3_2(const std::filesystem::path& folder) {
    const char* operations[] = {"add", "subtract", "multiply", "divide"};
    std::vector<PublishedTiming> cells;
    for (const Row& row : read_rows(folder / "table_3_2.csv", {"type", "add_ms", "subtract_ms",
                                                               "multiply_ms", "divide_ms"})) {
        for (std::size_t i = 0; i < std::size(operations); ++i)
            cells.push_back({row.text(0), operations[i], row.number(i + 1), ""});
    }
    return cells;
}

std::vector<PublishedTiming> load_functions(const std::filesystem::path& folder) {
    std::vector<PublishedTiming> timings;
    for (const Row& row :
         read_rows(folder / "functions.csv", {"operation", "type", "ms_per_30000", "note"}))
        timings.push_back({row.text(1), row.text(0), row.number(2), row.text(3)});
    return timings;
}

std::vector<WorkloadFigure> load_workload(const std::filesystem::path& folder) {
    std::vector<WorkloadFigure> figures;
    for (const Row& row :
         read_rows(folder / "workload.csv", {"quantity", "arithmetic", "value", "unit", "where"}))
        figures.push_back({row.text(0), row.text(1), row.number(2), row.text(3), row.text(4)});
    return figures;
}

std::vector<ForceCalibration> load_table_d_1(const std::filesystem::path& folder) {
    std::vector<ForceCalibration> rows;
    for (const Row& row :
         read_rows(folder / "table_d_1.csv", {"adc_reading", "actual_g", "calculated_g"}))
        rows.push_back({row.number(0), row.number(1), row.number(2)});
    return rows;
}

std::vector<ForceCorrection> load_table_d_2(const std::filesystem::path& folder) {
    std::vector<ForceCorrection> rows;
    for (const Row& row :
         read_rows(folder / "table_d_2.csv", {"acceleration_m_s2", "correction_n_per_m_s2"}))
        rows.push_back({row.number(0), row.number(1)});
    return rows;
}

}  // namespace reference
