// SPDX-License-Identifier: GPL-3.0-or-later
// The improvements over the published methods: each ablation compared with the complete engine, in
// limit, error and cycles.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <tuple>

#include "bench/lab/records/record.hpp"

namespace stability {

struct Effort;

// A row of ablations.csv.
struct AblationRow {
    std::string ablation, of_case, parameter, unit, before_method, after_method;
    std::optional<double> before, after;  // the last parameters that hold; none if none does
    // In tolerances, at a parameter that the method before does not withstand; none if the engine
    // reports an error there, or the format does not hold the case.
    std::optional<double> before_error, after_error;
    double before_cycles, after_cycles;
    std::uint64_t before_cycles_max, after_cycles_max;
    std::string before_cause, after_cause;

    static constexpr auto columns = [] {
        using records::column;
        return std::tuple(
            column("ablation", &AblationRow::ablation), column("case", &AblationRow::of_case),
            column("parameter", &AblationRow::parameter), column("unit", &AblationRow::unit),
            column("before_method", &AblationRow::before_method),
            column("after_method", &AblationRow::after_method),
            column("before", &AblationRow::before, "{:.4g}"),
            column("after", &AblationRow::after, "{:.4g}"),
            column("before_error", &AblationRow::before_error, "{:.4g}"),
            column("after_error", &AblationRow::after_error, "{:.4g}"),
            column("before_cycles", &AblationRow::before_cycles, "{:.0f}"),
            column("after_cycles", &AblationRow::after_cycles, "{:.0f}"),
            column("before_cycles_max", &AblationRow::before_cycles_max),
            column("after_cycles_max", &AblationRow::after_cycles_max),
            column("before_cause", &AblationRow::before_cause),
            column("after_cause", &AblationRow::after_cause));
    }();
};

// Writes ablations.csv.
void measure_ablations(const std::filesystem::path& output, const Effort& effort, unsigned threads);

}  // namespace stability
