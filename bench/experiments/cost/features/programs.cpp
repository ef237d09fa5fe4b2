// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/cost/features/programs.hpp"

#include <iterator>
#include <sstream>

#include "bench/lab/records/csv.hpp"

namespace features {

std::vector<Program> load_programs(const std::filesystem::path& folder) {
    const auto table = records::Table::load(folder / "programs.csv");
    const auto scene = table.column("scene"), feature = table.column("feature"),
               with = table.column("with"), uses = table.column("uses"),
               program = table.column("program"), uninlined = table.column("uninlined");
    std::vector<Program> programs;
    for (const auto& row : table.rows()) {
        std::istringstream names(row[uses]);
        programs.push_back({row[scene], row[feature], row[with] == "yes",
                            Uses(std::istream_iterator<std::string>(names), {}),
                            folder / row[program], folder / row[uninlined]});
    }
    return programs;
}

}  // namespace features
