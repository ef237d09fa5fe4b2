// SPDX-License-Identifier: MIT
/// \file
/// From a force sensor's reading to grams. `fixbench calibrate readings.csv` writes
/// calibration_table.hpp for a sensor; that file names its curve and its errors.
///
/// Two opposed sensors: net grams = grams<Scalar>(one) - grams<Scalar>(other). Each is converted to
/// grams before the subtraction.
#pragma once

#include <firmware/calibration_table.hpp>

namespace firmware {

/// The weight on the sensor in grams. `sum` is the sum of 2^sum_bits readings of a 10-bit
/// converter, by default of one; sum_bits must be in 0..4. The result is between 0 and the table's
/// `max_grams` and never falls as `sum` rises. A mean reading outside 0..1023 counts as the
/// nearest of the two.
template <class Scalar, int sum_bits = 0>
FIXEDPOINT_CONSTEXPR Scalar grams(int sum) {
    static_assert(sum_bits >= 0 && sum_bits <= 4,
                  "sum_bits must be in 0..4: a sum of 1, 2, 4, 8 or 16 readings.");
    return calibration::curve.template grams<Scalar, sum_bits>(sum);
}

}  // namespace firmware
