// SPDX-License-Identifier: GPL-3.0-or-later
// integrate: ordinary differential equations by GSL's Runge-Kutta pair of Prince and Dormand,
// order 8.
#pragma once

#include <functional>
#include <vector>

namespace reference {

using Variables = std::vector<double>;
using Derivative = std::function<void(const double* variables, double* rates)>;

// The variables at each time from `start` at 0 s.
std::vector<Variables> integrate(const Derivative& derivative, const Variables& start,
                                 const std::vector<double>& times, double tolerance);

}  // namespace reference
