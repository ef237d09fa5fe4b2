// SPDX-License-Identifier: GPL-3.0-or-later
// A measured figure next to the published one, with a verdict.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "bench/lab/records/record.hpp"
#include "reference/published.hpp"

namespace lab {

struct VerdictRow {
    std::string quantity, arithmetic;
    std::optional<double> published;  // if anything was
    std::optional<double> measured;   // if it occurs: the mean of no calls is NaN
    std::string unit;
    std::optional<double> ratio;
    std::string verdict, reason;

    static constexpr auto columns = std::tuple(
        records::column("quantity", &VerdictRow::quantity),
        records::column("arithmetic", &VerdictRow::arithmetic),
        records::column("published", &VerdictRow::published),
        records::column("measured", &VerdictRow::measured),
        records::column("unit", &VerdictRow::unit), records::column("ratio", &VerdictRow::ratio),
        records::column("verdict", &VerdictRow::verdict),
        records::column("reason", &VerdictRow::reason));
};

// A row with the published figure of that name. The verdict is "reproduced" if the ratio is within
// 10% of 1, otherwise `otherwise`: "explained" if the reason names a cause that is itself measured
// or counted, "cause named" if nobody measured it, or "not reproducible". Throws std::logic_error
// if no such figure was published.
inline VerdictRow compared(const std::string& quantity, const std::string& arithmetic,
                           double measured, const std::string& reason, const char* otherwise) {
    static const std::vector<reference::WorkloadFigure> published = reference::load_workload();
    for (const reference::WorkloadFigure& figure : published) {
        if (figure.quantity != quantity || figure.arithmetic != arithmetic) continue;
        const double ratio = measured / figure.value;
        const char* verdict = reference::within_10_percent(ratio) ? "reproduced" : otherwise;
        return {quantity, arithmetic, figure.value, measured, figure.unit, ratio, verdict, reason};
    }
    throw std::logic_error("no published figure: " + quantity);
}

// A row without a published figure.
inline VerdictRow told(const std::string& quantity, const std::string& arithmetic, double measured,
                       const std::string& unit, const std::string& reason) {
    return {quantity, arithmetic, std::nullopt, measured, unit, std::nullopt, "measured", reason};
}

}  // namespace lab
