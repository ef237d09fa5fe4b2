// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/records/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "bench/lab/records/whole_file.hpp"

namespace records {

namespace {

std::string escaped(std::string_view text) {
    if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"') result += '"';
        result += c;
    }
    return result + '"';
}

std::string line_of(const std::vector<std::string>& cells) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (i != 0) line += ',';
        line += escaped(cells[i]);
    }
    return line + '\n';
}

}  // namespace

std::string cell(double value) {
    if (std::isnan(value)) return "";
    if (value == std::floor(value) && std::abs(value) < 1e15) return fmt::format("{:.0f}", value);
    return fmt::format("{:.6g}", value);
}

Table::Table(std::vector<std::string> columns) : columns_(std::move(columns)) {}

void Table::add(std::vector<std::string> row) {
    if (row.size() != columns_.size()) {
        throw std::logic_error(
            fmt::format("a row of {} cells for {} columns", row.size(), columns_.size()));
    }
    rows_.push_back(std::move(row));
}

std::size_t Table::column(std::string_view name) const {
    const auto found = std::find(columns_.begin(), columns_.end(), name);
    if (found == columns_.end())
        throw std::runtime_error(fmt::format("{}: no column '{}'", name_, name));
    return static_cast<std::size_t>(found - columns_.begin());
}

std::string Table::to_csv() const {
    std::string text = line_of(columns_);
    for (const auto& row : rows_) text += line_of(row);
    return text;
}

void Table::save(const std::filesystem::path& path) const { write_whole(path, to_csv()); }

Table Table::load(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw std::runtime_error(fmt::format("cannot read {}", path.string()));
    const std::string text((std::istreambuf_iterator<char>(stream)), {});
    return parse(text, path.string());
}

Table Table::parse(std::string_view text, const std::string& name, char separator) {
    std::vector<std::vector<std::string>> lines;
    std::vector<std::string> cells;
    std::string current;
    bool in_quotes = false;
    const auto end_line = [&] {
        cells.push_back(std::move(current));
        current.clear();
        lines.push_back(std::move(cells));
        cells.clear();
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_quotes) {
            if (c != '"') {
                current += c;
            } else if (i + 1 < text.size() && text[i + 1] == '"') {
                current += '"';
                ++i;
            } else {
                in_quotes = false;
            }
        } else if (c == '"' && current.empty()) {
            in_quotes = true;
        } else if (c == separator) {
            cells.push_back(std::move(current));
            current.clear();
        } else if (c == '\n') {
            end_line();
        } else if (c != '\r') {
            current += c;
        }
    }
    if (in_quotes) {
        throw std::runtime_error(fmt::format("{}: a quoted cell has no end", name));
    }
    if (!current.empty() || !cells.empty()) end_line();
    if (lines.empty()) throw std::runtime_error(fmt::format("{}: empty", name));

    Table table(std::move(lines.front()));
    table.name_ = name;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (lines[i].size() != table.columns_.size()) {
            throw std::runtime_error(fmt::format("{}:{}: {} cells, the header has {}", name, i + 1,
                                                 lines[i].size(), table.columns_.size()));
        }
        table.rows_.push_back(std::move(lines[i]));
    }
    return table;
}

}  // namespace records
