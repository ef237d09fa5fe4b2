// SPDX-License-Identifier: GPL-3.0-or-later
// A row of a data file is a struct, and its columns stand beside its members:
//
//     struct Reading {
//         std::string name;
//         std::optional<double> error;  // an empty cell where there is none
//         double grams;
//         static constexpr auto columns =
//             std::tuple(column("name", &Reading::name), column("error", &Reading::error),
//                        column("grams", &Reading::grams, "{:.1f}"));
//     };
//     records::table_of(readings).save(path);
#pragma once

#include <fmt/format.h>

#include <concepts>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "bench/lab/records/csv.hpp"

namespace records {

template <class Row, class Member>
struct Column {
    const char* name;
    Member Row::*member;
    const char* format;  // of fmt; null where a number is written as cell() does
};

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

inline std::string cell(const std::string& text) { return text; }
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

template <class Row, class Member>
std::string cell_of(const Row& row, const Column<Row, Member>& column) {
    const Member& value = row.*column.member;
    if constexpr (std::is_arithmetic_v<Member>) {
        if (column.format) return fmt::format(fmt::runtime(column.format), value);
    } else if constexpr (is_number<Member>) {
        if (column.format && value) return fmt::format(fmt::runtime(column.format), *value);
    }
    return cell(value);
}

template <class Row>
Table table_of(const std::vector<Row>& rows) {
    return std::apply(
        [&](const auto&... columns) {
            Table table({columns.name...});
            for (const Row& row : rows) table.add({cell_of(row, columns)...});
            return table;
        },
        Row::columns);
}

}  // namespace records
