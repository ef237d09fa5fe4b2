// SPDX-License-Identifier: GPL-3.0-or-later
// The inputs of a program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace advise {

using Row = std::vector<double>;

struct Data {
    std::vector<std::string> names;      // of the inputs
    std::vector<std::vector<Row>> runs;  // one per file
    std::size_t rows() const {
        std::size_t sum = 0;
        for (const auto& run : runs) sum += run.size();
        return sum;
    }
};

// Throws std::invalid_argument with one line if a file is not a table of numbers, or its columns
// differ from those of the first.
Data load(const std::vector<std::filesystem::path>& files);

// In the form that the programs of driver/ read.
std::string text_of(const Data& data);

}  // namespace advise
