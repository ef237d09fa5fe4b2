// SPDX-License-Identifier: GPL-3.0-or-later
// Do the published readings give the published coefficients?
#pragma once

#include <string>
#include <vector>

#include "bench/experiments/calibration/curve.hpp"
#include "bench/lab/records/csv.hpp"

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

// A row for each coefficient and one for the unscaled evaluation.
records::Table verdict_table(const std::vector<Reading>& readings);

}  // namespace calibration
