// SPDX-License-Identifier: GPL-3.0-or-later
// integrate: ordinary differential equations by GSL's Runge-Kutta pair of Prince and Dormand,
// order 8.
#pragma once

#include <functional>
#include <vector>

namespace reference {

using Variables = std::vector<double>;
using Derivative = std::function<void(const double* variables, double* rates)>;

// The variables at each of the `times`, which start at 0 s with `start`. `tolerance` is the error
// allowed in a step, absolute and relative. Throws std::runtime_error if GSL cannot integrate.
std::vector<Variables> integrate(const Derivative& derivative, const Variables& start,
                                 const std::vector<double>& times, double tolerance);

}  // namespace reference
