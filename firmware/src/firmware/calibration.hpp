// SPDX-License-Identifier: MIT
/// \file
/// From a force sensor's reading to grams. calibration_table.hpp is made for a sensor by
/// `fixbench calibrate readings.csv`; it says which curve that is, and its errors.
///
/// Two opposed sensors: net grams = grams<Scalar>(one) - grams<Scalar>(other), each converted whole
/// before the subtraction.
#pragma once

#include <firmware/calibration_table.hpp>

namespace firmware {

/// The weight on the sensor for the mean of 2^sum_bits readings of a 10-bit converter, of which
/// `sum` is the sum; for one reading by default. Rises with it or stays as it is; between 0 and the
/// table's `most_grams`; readings outside 0..1023 count as the nearest.
template <class Scalar, int sum_bits = 0>
FIXEDPOINT_CONSTEXPR Scalar grams(int sum) {
    static_assert(sum_bits >= 0 && sum_bits <= 4, "A sum is of 1, 2, 4, 8 or 16 readings.");
    return calibration::curve.template grams<Scalar, sum_bits>(sum);
}

}  // namespace firmware
