// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of text cells, saved and loaded as CSV (RFC 4180).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace records {

// A number as a cell: up to six significant digits, integers in full, no trailing zeros. Empty for
// NaN, which means "not measured"; the member of a row that may be NaN is a std::optional.
std::string cell(double value);

class Table {
  public:
    explicit Table(std::vector<std::string> columns);

    // Throws std::logic_error if the number of cells differs from the number of columns.
    void add(std::vector<std::string> row);

    // The name of the file, for messages; empty if there is no file.
    const std::string& name() const { return name_; }
    const std::vector<std::string>& columns() const { return columns_; }
    const std::vector<std::vector<std::string>>& rows() const { return rows_; }

    // The index of a column. Throws std::runtime_error if there is no column of that name.
    std::size_t column(std::string_view name) const;

    std::string to_csv() const;
    void save(const std::filesystem::path& path) const;

    // Throws std::runtime_error with file and line if the file is missing or malformed.
    static Table load(const std::filesystem::path& path);

    // The same for a text, which messages refer to as `name`.
    static Table parse(std::string_view text, const std::string& name, char separator = ',');

  private:
    std::string name_;
    std::vector<std::string> columns_;
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace records
