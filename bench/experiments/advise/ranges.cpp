// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/advise/ranges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "bench/experiments/advise/driver.hpp"
#include "this_build.hpp"

namespace advise {
namespace {

namespace fs = std::filesystem;

std::string source_line(const fs::path& file, int number) {
    std::ifstream stream(file);
    std::string line;
    for (int i = 0; i < number && std::getline(stream, line); ++i) {
    }
    const std::size_t begin = line.find_first_not_of(" \t");
    return begin == line.npos ? "" : line.substr(begin);
}

}  // namespace

void note_operation(Operations& operations, const Words& words, std::size_t rows) {
    operations[words[1] == "negate" ? "subtract" : words[1]] +=
        std::stod(words[2]) / static_cast<double>(rows);
}

Recorded record(const Options& options, const Data& data, const fs::path& recorder,
                const fs::path& rows, const std::vector<Format>& formats) {
    std::vector<std::string> command = {recorder, rows};
    for (const Format& format : formats)
        command.push_back(fmt::format("{}.{}", format.integer_bits, format.fraction_bits));
    Recorded recorded;
    for (const Words& words : lines_of(options.program, command)) {
        if (words[0] == "inputs") {
            if (std::stoul(words[1]) != data.names.size())
                throw std::invalid_argument(fmt::format(
                    "{}: step has {} inputs, and {} has {} columns", options.program.string(),
                    words[1], options.data[0].string(), data.names.size()));
        } else if (words[0] == "output") {
            recorded.outputs.push_back(std::strtod(words[1].c_str(), nullptr));
            if (!std::isfinite(recorded.outputs.back()))
                throw std::invalid_argument(
                    fmt::format("{}: the result of row {} is not finite in double",
                                options.program.string(), recorded.outputs.size()));
        } else if (words[0] == "operation") {
            note_operation(recorded.operations, words, data.rows());
        } else {
            RangeRow row{};
            row.kind = words[0];
            row.name = words[1];
            if (row.kind == "input") row.name = data.names[std::stoul(words[1]) - 1];
            if (row.kind == "line") {
                const fs::path file = words[1];
                const fs::path below = fs::proximate(file, source_folder());
                row.name = fmt::format("{}:{}",
                                       file == options.program  ? file.filename().string()
                                       : *below.begin() == ".." ? file.string()
                                                                : below.string(),
                                       words[2]);
                row.source = source_line(file, std::stoi(words[2]));
            }
            row.count = std::stoull(words[3]);
            row.least = std::strtod(words[4].c_str(), nullptr);
            row.greatest = std::strtod(words[5].c_str(), nullptr);
            row.smallest = std::strtod(words[6].c_str(), nullptr);
            if (std::isinf(*row.smallest)) row.smallest.reset();
            row.integer_bits = std::stoi(words[7]);
            for (std::size_t i = 0; i < formats.size(); ++i) {
                const auto note = [&](std::string& text, const std::string& times) {
                    if (times != "0")
                        text += fmt::format("{}{} {}", text.empty() ? "" : "; ", formats[i].name(),
                                            times);
                };
                note(row.overflows, words[8 + 2 * i]);
                note(row.underflows, words[9 + 2 * i]);
            }
            recorded.integer_bits = std::max(recorded.integer_bits, row.integer_bits);
            recorded.ranges.push_back(std::move(row));
        }
    }
    return recorded;
}

}  // namespace advise
