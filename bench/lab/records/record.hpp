// SPDX-License-Identifier: GPL-3.0-or-later
// A row of a data file is a struct, and its columns are listed next to its members:
//
//     struct Reading {
//         std::string name;
//         std::optional<double> error;  // an empty cell if there is none
//         double grams;
//         static constexpr auto columns =
//             std::tuple(column("name", &Reading::name), column("error", &Reading::error),
//                        column("grams", &Reading::grams, "{:.1f}"));
//     };
//     records::table_of(readings).save(path);
//     records::rows_of<Reading>(records::Table::load(path));
//
// The type of a member tells readers in other languages what its column holds (headers()): a number
// is in every row, unless it is a std::optional. Columns that several files share are listed in a
// base class of their rows, joined by std::tuple_cat.
#pragma once

#include <fmt/format.h>

#include <charconv>
#include <concepts>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "bench/lab/records/csv.hpp"

namespace records {

template <class Row, class Member>
struct Column {
    const char* name;
    Member Row::*member;
    const char* format;  // of fmt; null to write a number as cell() does
};

// A column for each name of a list that need not be known before the program runs.
template <class Row, class Value>
struct Columns {
    std::vector<std::string> (*names)();
    std::vector<Value> Row::*values;  // as many as there are names
    const char* format;
};
template <class Row, class Value>
constexpr Columns<Row, Value> columns_of(std::vector<std::string> (*names)(),
                                         std::vector<Value> Row::*values,
                                         const char* format = nullptr) {
    return {names, values, format};
}

template <class Row, class Member>
constexpr Column<Row, Member> column(const char* name, Member Row::*member) {
    return {name, member, nullptr};
}
template <class Value>
constexpr bool is_number = std::is_arithmetic_v<Value>;
template <class Value>
constexpr bool is_number<std::optional<Value>> = std::is_arithmetic_v<Value>;

template <class Row, class Member>
requires is_number<Member>
constexpr Column<Row, Member> column(const char* name, Member Row::*member, const char* format) {
    return {name, member, format};
}

// A number with more digits than a double has.
struct Digits {
    std::string text;
};

// What the cells of a column hold: "text", "number", or "optional", a number that a row may lack.
template <class Value>
constexpr const char* holds = is_number<Value> ? "number" : "text";
template <>
inline constexpr const char* holds<bool> = "text";
template <>
inline constexpr const char* holds<Digits> = "number";
template <class Value>
constexpr const char* holds<std::optional<Value>> = holds<Value> == std::string_view("text")
                                                        ? "text"
                                                        : "optional";

inline std::string cell(const std::string& text) { return text; }
inline std::string cell(const Digits& number) { return number.text; }
template <std::integral Number>
std::string cell(Number number) {
    if constexpr (std::same_as<Number, bool>)
        return number ? "yes" : "no";
    else
        return fmt::to_string(number);
}
template <class Value>
std::string cell(const std::optional<Value>& value) {
    return value ? cell(*value) : std::string();
}

template <class Value>
std::string cell(const Value& value, const char* format) {
    if constexpr (std::is_arithmetic_v<Value>) {
        if (format) return fmt::format(fmt::runtime(format), value);
    } else if constexpr (is_number<Value>) {
        if (format && value) return fmt::format(fmt::runtime(format), *value);
    }
    return cell(value);
}

// Reads the value of a cell as cell() writes it. Returns false if the text is not of that type.
inline bool read(const std::string& text, std::string& value) {
    value = text;
    return true;
}
template <class Number>
requires std::is_arithmetic_v<Number>
bool read(const std::string& text, Number& value) {
    if constexpr (std::same_as<Number, bool>) {
        value = text == "yes";
        return value || text == "no";
    } else {
        if constexpr (std::floating_point<Number>)
            if (text.empty()) return value = std::numeric_limits<Number>::quiet_NaN(), true;
        const char* const end = text.data() + text.size();
        const auto [rest, error] = std::from_chars(text.data(), end, value);
        return error == std::errc() && rest == end;
    }
}
template <class Value>
bool read(const std::string& text, std::optional<Value>& value) {
    return text.empty() || read(text, value.emplace());
}

// The columns of a file in their order: the name of each, and what it holds.
using Header = std::vector<std::pair<std::string, std::string>>;

template <class Row, class Member>
void add_to(Header& header, const Column<Row, Member>& one) {
    header.emplace_back(one.name, holds<Member>);
}
template <class Row, class Value>
void add_to(Header& header, const Columns<Row, Value>& several) {
    for (const std::string& name : several.names()) header.emplace_back(name, holds<Value>);
}
template <class Row>
Header header_of() {
    Header header;
    std::apply([&](const auto&... columns) { (add_to(header, columns), ...); }, Row::columns);
    return header;
}

// The headers of all rows of which some part of the program makes tables, whether or not it runs.
inline std::vector<Header (*)()>& headers() {
    static std::vector<Header (*)()> all;
    return all;
}
template <class Row>
inline const bool is_known = (headers().push_back(&header_of<Row>), true);

template <class Row>
Table table_of(const std::vector<Row>& rows) {
    [[maybe_unused]] const bool& known = is_known<Row>;  // makes the program register the row
    std::vector<std::string> names, cells;
    for (auto& [name, held] : header_of<Row>()) names.push_back(std::move(name));
    const auto add_cells = [&](const Row& row, const auto& of) {
        if constexpr (requires { of.member; })
            cells.push_back(cell(row.*of.member, of.format));
        else
            for (const auto& value : row.*of.values) cells.push_back(cell(value, of.format));
    };
    return std::apply(
        [&](const auto&... columns) {
            Table table(names);
            for (const Row& row : rows) {
                (add_cells(row, columns), ...);
                table.add(std::move(cells));
                cells.clear();
            }
            return table;
        },
        Row::columns);
}

// The rows of a table that has at least these columns. Throws std::runtime_error that names the
// file and the column if one is missing, or the line if a cell is not of its type.
template <class Row>
std::vector<Row> rows_of(const Table& table) {
    std::vector<Row> rows(table.rows().size());
    const auto fill = [&](const std::string& name, auto value_in) {
        const std::size_t index = table.column(name);
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (const std::string& text = table.rows()[i][index]; !read(text, value_in(rows[i])))
                throw std::runtime_error(fmt::format("{}:{}: '{}' is not a value of column '{}'",
                                                     table.name(), i + 2, text, name));
    };
    const auto fill_each = [&](const auto& of) {
        if constexpr (requires { of.member; }) {
            fill(
                of.name, [&](Row & row) -> auto& { return row.*of.member; });
        } else {
            for (const std::string& name : of.names())
                fill(
                    name, [&](Row & row) -> auto& { return (row.*of.values).emplace_back(); });
        }
    };
    std::apply([&](const auto&... columns) { (fill_each(columns), ...); }, Row::columns);
    return rows;
}

}  // namespace records
