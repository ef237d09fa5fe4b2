// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the published readings yield the published coefficients.
#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "bench/experiments/calibration/curve.hpp"
#include "bench/lab/records/record.hpp"

namespace calibration {

// The published coefficients for readings from 850 and for those below.
inline const Curve published_function_1 = {Family::rational_quadratic,
                                           {-1.30315751e-5, 1.063940729e-2, 2.30339406}};
inline const Curve published_function_2 = {Family::quadratic,
                                           {8.536426146e-4, -0.2957452506, 55.22287182}};

struct PublishedFit {
    std::string function;
    Curve published;
    Fit refitted;              // to the run of readings with the closest fit
    int first, last;           // those readings
    double excess;             // of the published sum of squares over the minimum, relative
    double largest_distance;   // between the two curves over those readings, grams
    double worst_coefficient;  // largest relative difference of a coefficient
    std::string verdict;
};

// reproduced: every coefficient to six digits. equivalent: the published sum of squares exceeds the
// minimum by less than a ten-thousandth, so that the readings cannot distinguish the two curves.
PublishedFit reproduce(const std::string& function, const Curve& published,
                       const std::vector<Reading>& readings);

// The largest error in grams, and its reading, of the published Function 1 in Q16.16 when its
// coefficients are rounded to that format without scaling, over readings up to `last`.
struct Unscaled {
    double error;
    int reading;
};
Unscaled unscaled_function_1(const std::vector<Reading>& readings);

// A row of calibration_verdicts.csv: a coefficient, or the unscaled evaluation, which does not have
// one.
struct VerdictRow {
    std::string function, readings, coefficient;
    std::optional<double> published, refitted, standard_error, excess;
    double largest_distance;  // g
    std::string verdict;
    static constexpr auto columns =
        std::tuple(records::column("function", &VerdictRow::function),
                   records::column("readings", &VerdictRow::readings),
                   records::column("coefficient", &VerdictRow::coefficient),
                   records::column("published", &VerdictRow::published, "{:.10g}"),
                   records::column("refitted", &VerdictRow::refitted, "{:.10g}"),
                   records::column("standard_error", &VerdictRow::standard_error, "{:.3g}"),
                   records::column("square_sum_excess", &VerdictRow::excess, "{:.2e}"),
                   records::column("largest_distance_g", &VerdictRow::largest_distance),
                   records::column("verdict", &VerdictRow::verdict));
};

// A row for each coefficient and one for the unscaled evaluation.
std::vector<VerdictRow> verdict_rows(const std::vector<Reading>& readings);

}  // namespace calibration
