// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/advise/data.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>

#include "bench/lab/records/csv.hpp"

namespace advise {

namespace fs = std::filesystem;

Data load(const std::vector<fs::path>& files) {
    Data data;
    for (const fs::path& file : files) {
        const records::Table table = records::Table::load(file);
        if (data.names.empty()) data.names = table.columns();
        if (table.columns().size() != data.names.size())
            throw std::invalid_argument(fmt::format("{} has {} columns, and {} has {}",
                                                    file.string(), table.columns().size(),
                                                    files[0].string(), data.names.size()));
        if (table.rows().empty())
            throw std::invalid_argument(fmt::format(
                "{}: expected a line of names and at least one row of numbers", file.string()));
        std::vector<Row>& run = data.runs.emplace_back();
        for (const auto& cells : table.rows()) {
            Row& row = run.emplace_back();
            for (const std::string& cell : cells) {
                double x = 0;
                const char* const end = cell.data() + cell.size();
                const auto [rest, error] = std::from_chars(cell.data(), end, x);
                if (error != std::errc() || rest != end || !std::isfinite(x))
                    throw std::invalid_argument(
                        fmt::format("{}, row {}: '{}' is not a finite number", file.string(),
                                    run.size(), cell));
                row.push_back(x);
            }
        }
    }
    return data;
}

std::string text_of(const Data& data) {
    std::string text;
    for (const auto& run : data.runs) {
        for (const Row& row : run) {
            for (const double x : row) text += fmt::format("{} ", x);
            text.back() = '\n';
        }
        text += '\n';
    }
    return text;
}

}  // namespace advise
