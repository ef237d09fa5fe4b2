// SPDX-License-Identifier: MIT
// DO NOT EDIT. Made by `fixbench calibrate reference/published/table_d_1.csv` from 17 readings.
//
// grams = a + b x / (c - x), fitted to all readings:
// a, b, c = 76.74837599, 63.36206868, 993.5746671
// Held below reading 0 and above reading 961, so at most 2000 g.
// Error at the readings: 36.2 g rms, 88.5 g at most; of a reading left out of the fit: 44.9 g rms.
// Error of the Q16.16 evaluation, over all 1024 readings: 0.0004 g at most (exact).
// On the ATmega328P, with coefficients in RAM: 326 cycles on average, 349 at most.
#pragma once

#include <firmware/calibration_curves.hpp>

namespace firmware {
namespace calibration {

constexpr int max_grams = 2000;
constexpr Held<Hyperbola> curve = {0, 961, {877285, 1031453840, 65114909}};

}  // namespace calibration
}  // namespace firmware
