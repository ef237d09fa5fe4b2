// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/program/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "bench/chip/edit_distance.hpp"

namespace fixbench {

std::string nearest_name(const std::string& asked, const std::vector<std::string>& known) {
    std::string nearest;
    std::size_t least = asked.size() / 3 + 2;
    for (const std::string& name : known) {
        const std::size_t d = edit_distance(asked, name);
        if (d < least) {
            least = d;
            nearest = name;
        }
    }
    return nearest;
}

void check_names(const std::string& option, const std::vector<std::string>& asked,
                 std::vector<std::string> known) {
    std::sort(known.begin(), known.end());
    known.erase(std::unique(known.begin(), known.end()), known.end());
    for (const std::string& name : asked) {
        if (std::binary_search(known.begin(), known.end(), name)) continue;
        const std::string nearest = nearest_name(name, known);
        throw std::invalid_argument(
            fmt::format("{} '{}' does not exist{}; allowed are {}", option, name,
                        nearest.empty() ? "" : fmt::format(" (did you mean {}?)", nearest),
                        fmt::join(known, ", ")));
    }
}

}  // namespace fixbench
