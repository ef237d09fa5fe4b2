// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/calibration/verdicts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fixedpoint/fixed.hpp>
#include <optional>
#include <stdexcept>

namespace calibration {
namespace {

double worst_coefficient(const Curve& a, const Curve& b) {
    double worst = 0;
    for (std::size_t i = 0; i < a.coefficients.size(); ++i)
        worst = std::max(worst, std::abs(a.coefficients[i] / b.coefficients[i] - 1));
    return worst;
}

}  // namespace

PublishedFit reproduce(const std::string& function, const Curve& published,
                       const std::vector<Reading>& readings) {
    std::optional<PublishedFit> best;
    for (std::size_t first = 0; first + parameters < readings.size(); ++first) {
        for (std::size_t end = first + parameters + 1; end <= readings.size(); ++end) {
            const std::vector<Reading> run(readings.begin() + static_cast<std::ptrdiff_t>(first),
                                           readings.begin() + static_cast<std::ptrdiff_t>(end));
            Fit refitted;
            try {
                refitted = fit(published.family, run);
            } catch (const std::runtime_error&) {
                continue;  // this run of readings has no minimum
            }
            const double worst = worst_coefficient(refitted.curve, published);
            if (best && worst >= best->worst_coefficient) continue;
            PublishedFit found{function, published, refitted, run.front().adc, run.back().adc, 0,
                               0,        worst,     ""};
            found.excess = square_sum(published, run) / refitted.square_sum - 1;
            for (int x = found.first; x <= found.last; ++x)
                found.largest_distance = std::max(
                    found.largest_distance,
                    std::abs(value<double>(published, x) - value<double>(refitted.curve, x)));
            found.verdict = worst < 1e-6          ? "reproduced"
                            : found.excess < 1e-4 ? "equivalent"
                                                  : "not reproducible";
            best = found;
        }
    }
    if (!best) throw std::runtime_error(fmt::format("no readings can be fitted by {}", function));
    return *best;
}

Unscaled unscaled_function_1(const std::vector<Reading>& readings) {
    using fixedpoint::Q16_16;
    const auto rounded = [](double coefficient) {
        return Q16_16::from_raw(static_cast<std::int32_t>(std::floor(coefficient * 65536 + 0.5)));
    };
    const std::vector<double>& c = published_function_1.coefficients;
    Unscaled worst{0, 0};
    for (int x = 0; x <= readings.back().adc; ++x) {
        const Q16_16 reading = Q16_16::from_integer(x);
        const Q16_16 grams =
            reading / ((rounded(c[0]) * reading + rounded(c[1])) * reading + rounded(c[2]));
        const double error =
            std::abs(grams.raw() / 65536.0 - value<double>(published_function_1, x));
        if (error > worst.error) worst = {error, x};
    }
    return worst;
}

std::vector<VerdictRow> verdict_rows(const std::vector<Reading>& readings) {
    std::vector<VerdictRow> rows;
    for (const auto& [name, curve] :
         {std::pair{"function_1", published_function_1}, {"function_2", published_function_2}}) {
        const PublishedFit fit = reproduce(name, curve, readings);
        for (std::size_t i = 0; i < parameters; ++i) {
            rows.push_back({name, fmt::format("{} to {}", fit.first, fit.last),
                            std::string(1, static_cast<char>('a' + i)), curve.coefficients[i],
                            fit.refitted.curve.coefficients[i], fit.refitted.standard_errors[i],
                            fit.excess, fit.largest_distance, fit.verdict});
        }
    }
    const Unscaled unscaled = unscaled_function_1(readings);
    rows.push_back({"function_1 in Q16.16 with coefficients rounded as they stand",
                    fmt::format("0 to {}", readings.back().adc),
                    "",
                    {},
                    {},
                    {},
                    {},
                    unscaled.error,
                    fmt::format("worst at reading {}", unscaled.reading)});
    return rows;
}

}  // namespace calibration
