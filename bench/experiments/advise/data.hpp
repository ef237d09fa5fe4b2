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
    std::vector<std::vector<Row>> runs;  // of a file each
    std::size_t rows() const {
        std::size_t sum = 0;
        for (const auto& run : runs) sum += run.size();
        return sum;
    }
};

// Throws std::invalid_argument of one line where a file is no table of numbers, or has other
// columns than the first.
Data load(const std::vector<std::filesystem::path>& files);

// As the programs of driver/ read them.
std::string text_of(const Data& data);

}  // namespace advise
