// SPDX-License-Identifier: GPL-3.0-or-later
// A row of a data file is a struct, and its columns stand beside its members:
//
//     struct Reading {
//         std::string name;
//         std::optional<double> error;  // an empty cell where there is none
//         static constexpr auto columns =
//             std::tuple(column("name", &Reading::name), column("error", &Reading::error));
//     };
//     records::table_of(readings).save(path);
#pragma once

#include <fmt/format.h>

#include <concepts>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "bench/lab/records/csv.hpp"

namespace records {

template <class Row, class Member>
struct Column {
    const char* name;
    Member Row::*member;
};

template <class Row, class Member>
constexpr Column<Row, Member> column(const char* name, Member Row::*member) {
    return {name, member};
}

inline std::string cell(const std::string& text) { return text; }
std::string cell(std::integral auto number) { return fmt::to_string(number); }
template <class Value>
std::string cell(const std::optional<Value>& value) {
    return value ? cell(*value) : std::string();
}

template <class Row>
Table table_of(const std::vector<Row>& rows) {
    return std::apply(
        [&](const auto&... columns) {
            Table table({columns.name...});
            for (const Row& row : rows) table.add({cell(row.*columns.member)...});
            return table;
        },
        Row::columns);
}

}  // namespace records
