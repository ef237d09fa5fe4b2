// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/sequence/comparison.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <vector>

namespace sequence {
namespace {

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

std::string shortened(const std::string& line) {
    constexpr std::size_t most = 160;
    return line.size() <= most ? line : line.substr(0, most) + "...";
}

}  // namespace

std::string first_difference(const std::filesystem::path& committed,
                             const std::filesystem::path& measured) {
    const std::string name = committed.filename().string();
    for (const auto& file : {committed, measured})
        if (!std::filesystem::exists(file))
            return fmt::format("{}: {} is missing", name, file.string());
    const std::string a = text_of(committed), b = text_of(measured);
    if (a == b) return "";
    const auto before = lines_of(a), after = lines_of(b);
    const auto at = [](const std::vector<std::string>& lines, std::size_t i) {
        return i < lines.size() ? lines[i] : std::string("(the file has ended)");
    };
    std::size_t first = 0, count = 0;
    for (std::size_t i = 0; i < std::max(before.size(), after.size()); ++i) {
        if (at(before, i) == at(after, i)) continue;
        if (count++ == 0) first = i;
    }
    return fmt::format("{}:{}: {} lines differ, the first:\n  committed {}\n  measured  {}", name,
                       first + 1, count, shortened(at(before, first)), shortened(at(after, first)));
}

}  // namespace sequence
