// SPDX-License-Identifier: GPL-3.0-or-later
// Do the published readings give the published coefficients?
#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "bench/experiments/calibration/curve.hpp"
#include "bench/lab/records/record.hpp"

namespace calibration {

// Coefficients as published, of readings 850 and up and of those below.
inline const Curve published_function_1 = {Family::rational_quadratic,
                                           {-1.30315751e-5, 1.063940729e-2, 2.30339406}};
inline const Curve published_function_2 = {Family::quadratic,
                                           {8.536426146e-4, -0.2957452506, 55.22287182}};

struct PublishedFit {
    std::string function;
    Curve published;
    Fit refitted;              // to the run of readings whose fit comes closest
    int first, last;           // those readings
    double excess;             // of the published sum of squares over the least, relative
    double largest_distance;   // of the two curves over those readings, grams
    double worst_coefficient;  // largest relative difference of a coefficient
    std::string verdict;
};

// reproduced: every coefficient to six digits. equivalent: the published sum of squares exceeds the
// least by under a ten-thousandth, so that the readings cannot tell the two curves apart.
PublishedFit reproduce(const std::string& function, const Curve& published,
                       const std::vector<Reading>& readings);

// The largest error in grams, at which reading, of the published Function 1 in Q16.16 where its
// coefficients are rounded to that format as they stand, over readings up to the last one.
struct Unscaled {
    double error;
    int reading;
};
Unscaled unscaled_function_1(const std::vector<Reading>& readings);

// Of calibration_verdicts.csv: a coefficient, or the unscaled evaluation, which has none.
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
