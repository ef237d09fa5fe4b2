// SPDX-License-Identifier: GPL-3.0-or-later
// What the program in double reports: the range of every variable and line, and its results.
#pragma once

#include <map>
#include <optional>

#include "bench/experiments/advise/advise.hpp"
#include "bench/experiments/advise/data.hpp"
#include "bench/experiments/advise/driver.hpp"
#include "bench/experiments/advise/format.hpp"
#include "bench/lab/records/record.hpp"

namespace advise {

// A row of ranges.csv: the values of a variable, or of the operations of a line.
struct RangeRow {
    std::string kind, name, source;
    std::uint64_t count;
    double least, greatest;
    std::optional<double> smallest;  // the smallest magnitude other than 0
    int integer_bits;
    std::string overflows, underflows;  // the candidates with any, and how many

    static constexpr auto columns = [] {
        using records::column;
        return std::tuple(
            column("kind", &RangeRow::kind), column("name", &RangeRow::name),
            column("count", &RangeRow::count), column("least", &RangeRow::least),
            column("greatest", &RangeRow::greatest), column("smallest", &RangeRow::smallest),
            column("integer_bits", &RangeRow::integer_bits),
            column("overflows", &RangeRow::overflows), column("underflows", &RangeRow::underflows),
            column("source", &RangeRow::source));
    }();
};

// How often a step performs an operation.
using Operations = std::map<std::string, double>;
// Records that `rows` steps performed words[1] words[2] times. A change of sign costs as much as a
// subtraction from 0.
void note_operation(Operations& operations, const Words& words, std::size_t rows);

struct Recorded {
    std::vector<double> outputs;  // of all runs, in double
    Operations operations;
    int integer_bits = 1;  // enough for all values
    std::vector<RangeRow> ranges;
};

// Runs the compiled driver/record.cpp on a file of rows, and counts overflows and underflows in the
// formats. Throws std::invalid_argument if the data do not fit the program.
Recorded record(const Options& options, const Data& data, const std::filesystem::path& recorder,
                const std::filesystem::path& rows, const std::vector<Format>& formats);

}  // namespace advise
