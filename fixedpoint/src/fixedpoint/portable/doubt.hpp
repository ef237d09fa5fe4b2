// SPDX-License-Identifier: MIT
// FIXEDPOINT_DOUBT: a bound on the error of the sums of the 32-bit cores, in units of 2^-31. The
// sine of the kernels has the largest error, 9.6: its quarter turns are not rounded to nearest.
//
// Correctly rounded functions of Q16.16, on hosts and in kernels, add half an ulp plus this bound
// to a sum. If the part of the result below an ulp is then less than twice the bound, the exact
// result may lie on either side of a tie, and kernel/nearest.hpp decides.
#pragma once

#define FIXEDPOINT_DOUBT 10
